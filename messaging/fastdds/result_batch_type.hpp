#pragma once

#include "messaging/samples.hpp"

#include <cstdint>
#include <functional>
#include <lampreyPubSubTypes.h>

namespace lamprey::messaging::fastdds {

/// A batch of results on its way to or from its payload. It takes the place of the generated type, whose hundreds of
/// vectors cost as much as all of Fast DDS: batches are nearly all that is sent, and of some 60 KB each.
struct ResultBatchOnWire {
  const ResultBatch* outgoing = nullptr;  ///< borrowed
  ResultBatch incoming;
  bool sensible = true;  ///< of `incoming`: its enumerators are known, its columns of equal length
};

/// What Fast DDS handles a ResultBatchOnWire by. The payload is that of the generated type; nothing beyond its end is
/// read, and no more memory set aside than it can fill.
class ResultBatchType : public wire::ResultBatchPubSubType {
 public:
  static constexpr bool checks_lengths = true;

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override;
  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override;
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override;
  void* createData() override;
  void deleteData(void* data) override;
};

}  // namespace lamprey::messaging::fastdds
