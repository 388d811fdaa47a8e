#pragma once

#include "messaging/fastdds/payload_check.hpp"
#include "messaging/fastdds/wire.hpp"

#include <mutex>

namespace lamprey::messaging::fastdds {

/// The generated type support, made fit for a hostile network and for threads: generated deserialisation sets aside
/// whatever a length claims and lets the failure escape into Fast DDS's thread; getKey works in a buffer that all
/// writers and readers of the type in a participant share.
template <class Sample>
class GuardedType final : public Wire<Sample>::TypeSupport {
  using Generated = typename Wire<Sample>::TypeSupport;

 public:
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    try {
      return lengths_are_possible<Sample>({payload->data, payload->length}) && Generated::deserialize(payload, data);
    } catch (...) {
      return false;
    }
  }

  bool getKey(void* data, eprosima::fastrtps::rtps::InstanceHandle_t* handle, bool force_md5) override {
    const std::lock_guard lock(mutex_);
    return Generated::getKey(data, handle, force_md5);
  }

 private:
  std::mutex mutex_;
};

}  // namespace lamprey::messaging::fastdds
