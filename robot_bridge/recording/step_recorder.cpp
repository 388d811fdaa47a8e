#include "robot_bridge/recording/step_recorder.hpp"

#include "robot_bridge/recording/octets.hpp"
#include "robot_bridge/ros2/angles.hpp"

#include <bit>
#include <cstddef>
#include <exception>
#include <spdlog/spdlog.h>
#include <string_view>
#include <utility>

namespace lamprey::robot_bridge::recording {
namespace {

using messaging::ServoState;
using std::chrono::system_clock;

constexpr std::size_t reported_channel = 0;
constexpr std::size_t commanded_channel = 1;
constexpr std::size_t step_channel = 2;

constexpr std::string_view header_definition = R"(
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
)";
constexpr std::string_view joint_state_definition = R"(std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort)";
constexpr std::string_view step_definition = R"(std_msgs/Header header
uint64 token
uint64 evaluation
uint32 time_step
bool done
bool measured
uint8 feet_down
string reason)";

std::vector<Channel> channels() {
  const std::string joint_state = std::string(joint_state_definition) + std::string(header_definition);
  const std::string step = std::string(step_definition) + std::string(header_definition);
  return {{"/joint_states", "sensor_msgs/msg/JointState", joint_state},
          {"/commanded_joint_states", "sensor_msgs/msg/JointState", joint_state},
          {"/robot_step", "lamprey_msgs/msg/RobotStep", step}};
}

/// XCDR1, little-endian: each number is aligned to its own size behind the four octets of the encapsulation header.
class Cdr {
 public:
  Cdr() : octets_{0x00, 0x01, 0x00, 0x00} {}

  template <class Integer>
  void add(Integer value) {
    while ((octets_.size() - encapsulation) % sizeof value != 0) octets_.push_back(0);
    append(octets_, value);
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(bool value) { add(static_cast<std::uint8_t>(value)); }
  void add(std::string_view text) {
    add(static_cast<std::uint32_t>(text.size() + 1));
    octets_.insert(octets_.end(), text.begin(), text.end());
    octets_.push_back(0);
  }
  void add_header(std::uint64_t nanoseconds) {
    constexpr std::uint64_t second = 1'000'000'000;
    add(static_cast<std::uint32_t>(nanoseconds / second));
    add(static_cast<std::uint32_t>(nanoseconds % second));
    add(std::string_view());
  }

  const std::vector<std::uint8_t>& octets() const { return octets_; }

 private:
  static constexpr std::size_t encapsulation = 4;
  std::vector<std::uint8_t> octets_;
};

std::vector<std::uint8_t> joint_state(const std::vector<double>& angles, std::uint64_t nanoseconds) {
  Cdr cdr;
  cdr.add_header(nanoseconds);
  cdr.add(static_cast<std::uint32_t>(ros2::joint_names.size()));
  for (const auto name : ros2::joint_names) cdr.add(name);
  cdr.add(static_cast<std::uint32_t>(angles.size()));
  for (const double angle : angles) cdr.add(angle);
  cdr.add(std::uint32_t{0});  // no velocities
  cdr.add(std::uint32_t{0});  // no efforts
  return cdr.octets();
}

std::vector<std::uint8_t> robot_step(const ServoState& state, std::uint64_t nanoseconds) {
  Cdr cdr;
  cdr.add_header(nanoseconds);
  cdr.add(state.token);
  cdr.add(state.evaluation);
  cdr.add(state.time_step);
  cdr.add(state.outcome == messaging::StepOutcome::done);
  cdr.add(state.measured);
  cdr.add(static_cast<std::uint8_t>(state.feet_down));
  cdr.add(std::string_view(state.reason));
  return cdr.octets();
}

}  // namespace

StepRecorder::StepRecorder(const std::string& path, const Calibration& calibration)
    : calibration_(calibration),
      writer_(path, channels()),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

StepRecorder::~StepRecorder() {
  thread_.request_stop();
  thread_.join();
}

void StepRecorder::add(const ServoState& state, system_clock::time_point time) {
  const auto since = std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch());
  const std::scoped_lock lock(mutex_);
  if (broken_) return;
  steps_.push_back({state, static_cast<std::uint64_t>(since.count())});
  wake_.notify_one();
}

void StepRecorder::run(const std::stop_token& stop) {
  try {
    bool more = true;
    while (more) {
      std::vector<Step> steps;
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, stop, [&] { return !steps_.empty(); });
        steps.swap(steps_);
        more = !stop.stop_requested() || !steps.empty();
      }
      for (const auto& step : steps) write(step);
      writer_.flush();
    }
    writer_.finish();
  } catch (const std::exception& error) {
    spdlog::error("{}; it ends here", error.what());
    const std::scoped_lock lock(mutex_);
    broken_ = true;
    steps_.clear();
  }
}

void StepRecorder::write(const Step& step) {
  if (step.state.outcome == messaging::StepOutcome::done) {
    const auto joints = [&](std::size_t channel, const Pose& pose) {
      writer_.write(channel, step.nanoseconds, joint_state(ros2::to_radians(calibration_, pose), step.nanoseconds));
    };
    joints(reported_channel, step.state.reported);
    joints(commanded_channel, step.state.commanded);
  }
  writer_.write(step_channel, step.nanoseconds, robot_step(step.state, step.nanoseconds));
}

}  // namespace lamprey::robot_bridge::recording
