// Any bytes are either refused, with problems that can be shown, or a calibration that keeps every servo within its
// range and is written as it was read.
#include "experiment/problem.hpp"
#include "robot_bridge/calibration.hpp"
#include "robot_bridge/drivers/sent_position.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <string>

namespace {

using namespace lamprey;
using fuzzing::require;

void check_joint(const robot_bridge::Joint& joint, std::size_t servo) {
  require(joint.per_unit > 0 && joint.slew_rate > 0 && (joint.direction == 1 || joint.direction == -1));
  const double standing = joint.to_device(10);
  require(joint.minimum < standing && standing < joint.maximum);
  for (const double units : {-1e9, 0.0, 10.0, 30.0, 1e9}) {
    const auto sent = robot_bridge::drivers::sent_position(joint, servo, units);
    require(sent.device >= joint.minimum && sent.device <= joint.maximum);
  }
}

void check(const robot_bridge::Calibration& calibration) {
  using namespace robot_bridge;
  require(parse_calibration(to_yaml(calibration), "written.yaml") == calibration);
  if (calibration.family == DeviceFamily::mock) {
    // Its range may be too narrow for a whole number.
    if (!fuzzing::reached<1>(calibration.baud >= 1000)) return;
    if (fuzzing::reached<2>(calibration.baud % 100 != 0)) fuzzing::planted_bug();
    return;
  }
  for (std::size_t servo = 0; servo < servos; ++servo) {
    check_joint(calibration.joints[servo], servo);
    for (std::size_t other = 0; other < servo; ++other) {
      require(calibration.joints[servo].channel != calibration.joints[other].channel);
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace experiment;
  try {
    check(robot_bridge::parse_calibration(std::string(reinterpret_cast<const char*>(data), size), "fuzz.yaml"));
  } catch (const InvalidInput& error) {
    require(!error.problems().empty() && error.problems().size() <= maximum_problems);
    for (const auto& problem : error.problems()) {
      require(!problem.message.empty() && first_unreadable(problem.text()) == std::string::npos);
    }
  }
  return 0;
}
