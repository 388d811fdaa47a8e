#pragma once

#include "messaging/samples.hpp"

#include <chrono>
#include <cstdint>
#include <string_view>

/// Quality of service by purpose, the same for every vendor. The reasons are in docs/decisions and the measurements
/// there; authority never rests on these settings, only on what the samples say.
namespace lamprey::messaging {

/// Samples that arrive faster than they are taken.
inline constexpr std::uint32_t maximum_untaken = 4096;

struct QosProfile {
  bool reliable = true;
  bool transient_local = false;  ///< late readers get the writer's history
  bool keep_all = false;         ///< else keep the last `depth` per key
  std::uint32_t depth = 1;       ///< of keep-last, and the bound (in samples) of keep-all and of what late readers get
  std::uint32_t untaken = maximum_untaken;  ///< samples that a reader of an unkeyed topic holds at most
  std::chrono::milliseconds liveliness{0};  ///< lease, automatic; 0: infinite
};

namespace qos {
inline constexpr QosProfile status{.transient_local = true, .liveliness = std::chrono::milliseconds{2000}};
/// Volatile, and repeated by the coordinator: what a keyed writer keeps for late readers has holes in its numbers, and
/// a late reader that loses a packet may never get over them (docs/decisions/0001).
inline constexpr QosProfile specification{};
inline constexpr QosProfile lease{.transient_local = true, .depth = 512};
inline constexpr QosProfile result{.keep_all = true, .depth = 512};
inline constexpr QosProfile acknowledgement{.transient_local = true, .depth = 64};
/// Large and soon out of date: few are kept, and a lost one is followed by the next.
inline constexpr QosProfile checkpoint{.depth = 16, .untaken = 64};
inline constexpr QosProfile request{.transient_local = true, .depth = 8};
inline constexpr QosProfile reply{.transient_local = true, .depth = 8};
inline constexpr QosProfile progress{.transient_local = true};
/// Once a second, for whoever looks.
inline constexpr QosProfile traffic{.reliable = false};
/// Of robots. A lost command or state costs an evaluation, a late one is worse than none; so few wait.
inline constexpr QosProfile robot_status{.transient_local = true, .liveliness = std::chrono::milliseconds{2000}};
/// Volatile: what somebody wished of a bridge that has ended must not turn the servos on by the next one.
inline constexpr QosProfile robot_request{.depth = 4, .untaken = 256};
inline constexpr QosProfile robot_reply{.transient_local = true, .depth = 4, .untaken = 256};
inline constexpr QosProfile servo{.reliable = false, .untaken = 32};
}  // namespace qos

/// The version of the types on the wire, which is part of the topics' names: types of other versions never meet.
inline constexpr std::uint32_t wire_version = 4;

/// Topic name and profile of each sample type.
template <class Sample>
struct Topic;

template <>
struct Topic<WorkerStatus> {
  static constexpr std::string_view name = "lamprey/4/worker_status";
  static constexpr QosProfile profile = qos::status;
};
template <>
struct Topic<SweepSpecification> {
  static constexpr std::string_view name = "lamprey/4/sweep_specification";
  static constexpr QosProfile profile = qos::specification;
};
template <>
struct Topic<Lease> {
  static constexpr std::string_view name = "lamprey/4/lease";
  static constexpr QosProfile profile = qos::lease;
};
template <>
struct Topic<ResultBatch> {
  static constexpr std::string_view name = "lamprey/4/result";
  static constexpr QosProfile profile = qos::result;
};
template <>
struct Topic<ResultAcknowledgement> {
  static constexpr std::string_view name = "lamprey/4/result_acknowledgement";
  static constexpr QosProfile profile = qos::acknowledgement;
};
template <>
struct Topic<Checkpoint> {
  static constexpr std::string_view name = "lamprey/4/checkpoint";
  static constexpr QosProfile profile = qos::checkpoint;
};
template <>
struct Topic<Request> {
  static constexpr std::string_view name = "lamprey/4/request";
  static constexpr QosProfile profile = qos::request;
};
template <>
struct Topic<Reply> {
  static constexpr std::string_view name = "lamprey/4/reply";
  static constexpr QosProfile profile = qos::reply;
};
template <>
struct Topic<SweepProgress> {
  static constexpr std::string_view name = "lamprey/4/sweep_progress";
  static constexpr QosProfile profile = qos::progress;
};
template <>
struct Topic<Traffic> {
  static constexpr std::string_view name = "lamprey/4/traffic";
  static constexpr QosProfile profile = qos::traffic;
};
template <>
struct Topic<RobotStatus> {
  static constexpr std::string_view name = "lamprey/4/robot_status";
  static constexpr QosProfile profile = qos::robot_status;
};
template <>
struct Topic<RobotRequest> {
  static constexpr std::string_view name = "lamprey/4/robot_request";
  static constexpr QosProfile profile = qos::robot_request;
};
template <>
struct Topic<RobotReply> {
  static constexpr std::string_view name = "lamprey/4/robot_reply";
  static constexpr QosProfile profile = qos::robot_reply;
};
template <>
struct Topic<ServoCommand> {
  static constexpr std::string_view name = "lamprey/4/servo_command";
  static constexpr QosProfile profile = qos::servo;
};
template <>
struct Topic<ServoState> {
  static constexpr std::string_view name = "lamprey/4/servo_state";
  static constexpr QosProfile profile = qos::servo;
};

}  // namespace lamprey::messaging
