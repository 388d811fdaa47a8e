#pragma once

#include "messaging/samples.hpp"

#include <chrono>
#include <cstdint>
#include <string_view>

/// Quality of service by purpose, the same for every vendor. The reasons are in docs/decisions and the measurements
/// there; authority never rests on these settings, only on what the samples say.
namespace lamprey::messaging {

struct QosProfile {
  bool reliable = true;
  bool transient_local = false;  ///< late readers get the writer's history
  bool keep_all = false;         ///< else keep the last `depth` per key
  std::uint32_t depth = 1;       ///< of keep-last, and the bound (in samples) of keep-all and of what late readers get
  std::chrono::milliseconds liveliness{0};  ///< lease, automatic; 0: infinite
};

namespace qos {
inline constexpr QosProfile status{.transient_local = true, .liveliness = std::chrono::milliseconds{2000}};
inline constexpr QosProfile specification{.transient_local = true};
inline constexpr QosProfile lease{.transient_local = true, .depth = 512};
inline constexpr QosProfile result{.keep_all = true, .depth = 512};
inline constexpr QosProfile acknowledgement{.transient_local = true, .depth = 64};
inline constexpr QosProfile request{.transient_local = true, .depth = 8};
inline constexpr QosProfile reply{.transient_local = true, .depth = 8};
inline constexpr QosProfile progress{.transient_local = true};
}  // namespace qos

/// Topic name and profile of each sample type. The wire's version is part of the name: types of other versions never
/// meet.
template <class Sample>
struct Topic;

template <>
struct Topic<WorkerStatus> {
  static constexpr std::string_view name = "lamprey/2/worker_status";
  static constexpr QosProfile profile = qos::status;
};
template <>
struct Topic<SweepSpecification> {
  static constexpr std::string_view name = "lamprey/2/sweep_specification";
  static constexpr QosProfile profile = qos::specification;
};
template <>
struct Topic<Lease> {
  static constexpr std::string_view name = "lamprey/2/lease";
  static constexpr QosProfile profile = qos::lease;
};
template <>
struct Topic<ResultBatch> {
  static constexpr std::string_view name = "lamprey/2/result";
  static constexpr QosProfile profile = qos::result;
};
template <>
struct Topic<ResultAcknowledgement> {
  static constexpr std::string_view name = "lamprey/2/result_acknowledgement";
  static constexpr QosProfile profile = qos::acknowledgement;
};
template <>
struct Topic<Request> {
  static constexpr std::string_view name = "lamprey/2/request";
  static constexpr QosProfile profile = qos::request;
};
template <>
struct Topic<Reply> {
  static constexpr std::string_view name = "lamprey/2/reply";
  static constexpr QosProfile profile = qos::reply;
};
template <>
struct Topic<SweepProgress> {
  static constexpr std::string_view name = "lamprey/2/sweep_progress";
  static constexpr QosProfile profile = qos::progress;
};

}  // namespace lamprey::messaging
