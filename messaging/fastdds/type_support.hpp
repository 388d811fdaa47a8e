#pragma once

#include "messaging/fastdds/payload_check.hpp"
#include "messaging/fastdds/wire.hpp"
#include "messaging/malformed_samples.hpp"
#include "messaging/qos.hpp"

#include <memory>
#include <mutex>
#include <utility>

namespace lamprey::messaging::fastdds {

/// The generated type support, made fit for a hostile network and for threads: generated deserialisation sets aside
/// whatever a length claims and lets the failure escape into Fast DDS's thread; getKey works in a buffer that all
/// writers and readers of the type in a participant share.
template <class Sample>
class GuardedType final : public Wire<Sample>::TypeSupport {
  using Generated = typename Wire<Sample>::TypeSupport;

 public:
  explicit GuardedType(std::shared_ptr<MalformedSamples> malformed) : malformed_(std::move(malformed)) {}

  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    bool good = false;
    try {
      good = has_possible_lengths(*payload) && Generated::deserialize(payload, data);
    } catch (...) {  // whatever the generated code throws, it must not reach the vendor's thread
      good = false;
    }
    // Here Fast DDS does not tell who wrote it.
    if (!good) malformed_->note(Topic<Sample>::name, "an unknown writer", "its lengths are impossible");
    return good;
  }

  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override {
    const std::lock_guard lock(mutex_);
    return Generated::getKey(data, handle, force_md5);
  }

 private:
  static bool has_possible_lengths(const eprosima::fastrtps::rtps::SerializedPayload_t& payload) {
    if constexpr (requires { Generated::checks_lengths; }) {
      return true;
    } else {
      return lengths_are_possible<Sample>({payload.data, payload.length});
    }
  }

  std::shared_ptr<MalformedSamples> malformed_;
  std::mutex mutex_;
};

}  // namespace lamprey::messaging::fastdds
