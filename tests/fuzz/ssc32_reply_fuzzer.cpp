// Any octets in place of an SSC-32's answer: refused, or what the device may say.
#include "robot_bridge/drivers/ssc32_protocol.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <string>

namespace {

using namespace lamprey;
using namespace lamprey::robot_bridge::drivers;
using fuzzing::require;

void look_at_version(std::span<const std::uint8_t> answer) {
  const auto version = ssc32::version_of(answer);
  if (!version) return;
  require(version->size() == answer.size() && version->starts_with("SSC32"));
  for (const char letter : *version) require(letter >= ' ' && letter <= '~');
  if (!fuzzing::reached<1>(version->size() >= 20)) return;
  if (fuzzing::reached<2>(version->ends_with('!'))) fuzzing::planted_bug();
}

void look_at_pulses(std::span<const std::uint8_t> answer) {
  const auto pulses = ssc32::tens_of_microseconds(answer);
  if (!pulses) return;
  require(pulses->size() == answer.size());
  for (const auto tens : *pulses) {
    require(tens == 0 || (10 * tens >= ssc32::lowest_pulse && 10 * tens <= ssc32::highest_pulse));
    require(ssc32::tells_pulse(tens, 10 * tens) && !ssc32::tells_pulse(tens, 10 * tens + 10));
  }
}

void look_at_inputs(std::span<const std::uint8_t> answer) {
  const auto levels = ssc32::input_levels(answer);
  if (!levels) return;
  require(levels->size() == answer.size());
  for (std::size_t i = 0; i < answer.size(); ++i) require((answer[i] == '1') == (*levels)[i]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span answer(data, size);
  look_at_version(answer);
  look_at_pulses(answer);
  look_at_inputs(answer);
  return 0;
}
