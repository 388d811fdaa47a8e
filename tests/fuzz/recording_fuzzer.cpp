// Any octets as what a robot recorded of a job: refused with a reason, or one that says the same when it is stored and
// read back.
#include "idl/recording.pb.h"
#include "storage/recording.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <span>
#include <string>

namespace {

using namespace lamprey;
using fuzzing::require;

idl::RobotRecording message_of(const storage::RobotRecording& recording) {
  idl::RobotRecording message;
  message.set_robot(recording.robot);
  message.set_token(recording.token);
  for (const auto& tried : recording.tries) {
    auto& evaluation = *message.add_evaluations();
    evaluation.set_evaluation(tried.evaluation);
    evaluation.set_attempt(tried.attempt);
    evaluation.set_voided(tried.voided);
    evaluation.set_measured(tried.measured);
    evaluation.mutable_commanded()->Add(tried.commanded.begin(), tried.commanded.end());
    evaluation.mutable_reported()->Add(tried.reported.begin(), tried.reported.end());
    for (const auto feet : tried.feet_down) evaluation.add_feet_down(static_cast<std::uint32_t>(feet));
  }
  return message;
}

void look_at(std::span<const std::uint8_t> octets) {
  const auto parsed = storage::parse_recording(octets);
  require(parsed.recording.has_value() == parsed.refusal.empty());
  if (!parsed.recording) return;
  const auto& recording = *parsed.recording;
  require(storage::recording_fault(recording).empty());
  for (const auto& tried : recording.tries) {
    std::string text;
    for (const auto* numbers : {&tried.commanded, &tried.reported, &tried.feet_down}) {
      storage::write_whole_numbers(*numbers, text);
      require(storage::read_whole_numbers(text) == *numbers);
    }
  }
  const std::string again = message_of(recording).SerializeAsString();
  const auto reread = storage::parse_recording({reinterpret_cast<const std::uint8_t*>(again.data()), again.size()});
  require(reread.recording == recording);
  if (recording.tries.empty() || recording.tries.front().feet_down.empty()) return;
  const auto& tried = recording.tries.front();
  if (!fuzzing::reached<1>(tried.feet_down.front() == 6)) return;
  if (fuzzing::reached<2>(tried.commanded.front() != tried.reported.front())) fuzzing::planted_bug();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  look_at({data, size});
  storage::read_whole_numbers({reinterpret_cast<const char*>(data), size});
  return 0;
}
