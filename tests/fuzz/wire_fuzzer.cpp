// Any payload that comes for a topic over Fast DDS, through everything that stands before a program: the check of
// lengths, the generated code, the conversion, the limits. What is let through is written again, and reads back to the
// same octets. The first octet of the input picks the topic.
#include "messaging/fastdds/payload_check.hpp"
#include "messaging/fastdds/wire.hpp"
#include "messaging/limits.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <array>
#include <fastdds/rtps/common/SerializedPayload.h>
#include <type_traits>
#include <vector>

namespace {

using namespace lamprey;
using namespace lamprey::messaging;
using fuzzing::require;
using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

template <class Sample>
bool read(std::span<const std::uint8_t> octets, Sample& sample) {
  if constexpr (!std::is_same_v<Sample, ResultBatch>) {  // which checks its lengths while it reads
    if (!fastdds::lengths_are_possible<Sample>(octets)) return false;
  }
  std::vector<std::uint8_t> copy(octets.begin(), octets.end());
  Payload payload;
  payload.data = copy.data();
  payload.length = static_cast<std::uint32_t>(copy.size());
  payload.max_size = payload.length;
  typename fastdds::Wire<Sample>::TypeSupport type;
  typename fastdds::Wire<Sample>::Type data;
  bool good = false;
  try {
    good = type.deserialize(&payload, &data);
  } catch (...) {  // as messaging/fastdds/type_support.hpp does
    good = false;
  }
  payload.data = nullptr;  // it isn't the payload's to free
  return good && fastdds::from_wire(data, sample) && !limit_violation(sample);
}

template <class Sample>
std::vector<std::uint8_t> written(const Sample& sample) {
  typename fastdds::Wire<Sample>::TypeSupport type;
  typename fastdds::Wire<Sample>::Type data;
  fastdds::to_wire(sample, data);
  Payload payload(type.getSerializedSizeProvider(&data)());
  require(type.serialize(&data, &payload));
  return {payload.data, payload.data + payload.length};
}

void look_for_planted_bug(const WorkerStatus& status) {
  if (!fuzzing::reached<1>(status.state == WorkerState::leaving)) return;
  if (fuzzing::reached<2>(status.heartbeat > 1000)) fuzzing::planted_bug();
}
template <class Sample>
void look_for_planted_bug(const Sample&) {}

template <class Sample>
void look_at(std::span<const std::uint8_t> octets) {
  Sample sample;
  if (!read(octets, sample)) return;
  const auto first = written(sample);
  Sample again;
  require(read<Sample>(first, again));
  require(written(again) == first);
  look_for_planted_bug(sample);
}

constexpr std::array topics = {
    &look_at<WorkerStatus>,          &look_at<SweepSpecification>, &look_at<Lease>,        &look_at<ResultBatch>,
    &look_at<ResultAcknowledgement>, &look_at<Checkpoint>,         &look_at<Request>,      &look_at<Reply>,
    &look_at<SweepProgress>,         &look_at<RobotStatus>,        &look_at<RobotRequest>, &look_at<RobotReply>,
    &look_at<ServoCommand>,          &look_at<ServoState>,         &look_at<Traffic>};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  topics[*data % topics.size()]({data + 1, size - 1});
  return 0;
}
