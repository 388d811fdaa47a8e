#include "robot_bridge/dry_run_driver.hpp"

#include <cstddef>
#include <utility>

namespace lamprey::robot_bridge {
namespace {

class DryRunDriver final : public Driver {
 public:
  explicit DryRunDriver(std::unique_ptr<Driver> device) : device_(std::move(device)) {}

  void connect() override { device_->connect(); }
  std::optional<Pose> present_position() override { return device_->present_position(); }
  void enable(const Pose& start) override { pose_ = start; }
  void move(const Pose& target, std::chrono::microseconds /*duration*/) override { pose_ = target; }
  Feedback read() override {
    device_->read();
    Feedback feedback{.position = pose_};
    for (std::size_t leg = 0; leg < science::robots::legs; ++leg) {
      const double height = pose_[science::robots::vertical_servo(leg)];
      if (height <= science::robots::flat_ground_level) feedback.feet_down |= 1U << leg;
    }
    return feedback;
  }
  bool moving() override { return false; }
  void hold() override {}
  void release() override {}
  bool let_go() noexcept override { return true; }
  void cancel() noexcept override { device_->cancel(); }
  std::string description() const override { return device_->description() + " (dry run: nothing is moved)"; }
  double highest_rate() const override { return device_->highest_rate(); }

 private:
  std::unique_ptr<Driver> device_;
  Pose pose_ = standing_pose();
};

}  // namespace

std::unique_ptr<Driver> make_dry_run_driver(std::unique_ptr<Driver> device) {
  return std::make_unique<DryRunDriver>(std::move(device));
}

}  // namespace lamprey::robot_bridge
