#pragma once

#include "messaging/fastdds/result_batch_type.hpp"
#include "messaging/samples.hpp"

#include <lampreyPubSubTypes.h>
#include <robotPubSubTypes.h>

/// Our samples as the C++ types that Fast DDS Gen makes (namespace lamprey::wire), and back.
namespace lamprey::messaging::fastdds {

/// The generated type and its type support.
template <class Sample>
struct Wire;

#define LAMPREY_WIRE_TYPE(Sample)                          \
  template <>                                              \
  struct Wire<Sample> {                                    \
    using Type = lamprey::wire::Sample;                    \
    using TypeSupport = lamprey::wire::Sample##PubSubType; \
  }
LAMPREY_WIRE_TYPE(WorkerStatus);
LAMPREY_WIRE_TYPE(SweepSpecification);
LAMPREY_WIRE_TYPE(Lease);
LAMPREY_WIRE_TYPE(ResultAcknowledgement);
LAMPREY_WIRE_TYPE(Checkpoint);
LAMPREY_WIRE_TYPE(Request);
LAMPREY_WIRE_TYPE(Reply);
LAMPREY_WIRE_TYPE(SweepProgress);
LAMPREY_WIRE_TYPE(Traffic);
LAMPREY_WIRE_TYPE(RobotStatus);
LAMPREY_WIRE_TYPE(RobotRequest);
LAMPREY_WIRE_TYPE(RobotReply);
LAMPREY_WIRE_TYPE(ServoCommand);
LAMPREY_WIRE_TYPE(ServoState);
#undef LAMPREY_WIRE_TYPE
template <>
struct Wire<ResultBatch> {
  using Type = ResultBatchOnWire;
  using TypeSupport = ResultBatchType;
};

/// Whatever `to` was before; its memory is used again.
void to_wire(const WorkerStatus& sample, wire::WorkerStatus& to);
void to_wire(const SweepSpecification& sample, wire::SweepSpecification& to);
void to_wire(const Lease& sample, wire::Lease& to);
void to_wire(const ResultBatch& sample, ResultBatchOnWire& to);  ///< borrows the sample
void to_wire(const ResultAcknowledgement& sample, wire::ResultAcknowledgement& to);
void to_wire(const Checkpoint& sample, wire::Checkpoint& to);
void to_wire(const Request& sample, wire::Request& to);
void to_wire(const Reply& sample, wire::Reply& to);
void to_wire(const SweepProgress& sample, wire::SweepProgress& to);
void to_wire(const Traffic& sample, wire::Traffic& to);
void to_wire(const RobotStatus& sample, wire::RobotStatus& to);
void to_wire(const RobotRequest& sample, wire::RobotRequest& to);
void to_wire(const RobotReply& sample, wire::RobotReply& to);
void to_wire(const ServoCommand& sample, wire::ServoCommand& to);
void to_wire(const ServoState& sample, wire::ServoState& to);

/// Moves what it can out of `from`, which may be deserialised into again. False if the sample says what none of ours
/// can say (an unknown enumerator, columns of unequal length).
bool from_wire(wire::WorkerStatus& from, WorkerStatus& sample);
bool from_wire(wire::SweepSpecification& from, SweepSpecification& sample);
bool from_wire(wire::Lease& from, Lease& sample);
bool from_wire(ResultBatchOnWire& from, ResultBatch& sample);
bool from_wire(wire::ResultAcknowledgement& from, ResultAcknowledgement& sample);
bool from_wire(wire::Checkpoint& from, Checkpoint& sample);
bool from_wire(wire::Request& from, Request& sample);
bool from_wire(wire::Reply& from, Reply& sample);
bool from_wire(wire::SweepProgress& from, SweepProgress& sample);
bool from_wire(wire::Traffic& from, Traffic& sample);
bool from_wire(wire::RobotStatus& from, RobotStatus& sample);
bool from_wire(wire::RobotRequest& from, RobotRequest& sample);
bool from_wire(wire::RobotReply& from, RobotReply& sample);
bool from_wire(wire::ServoCommand& from, ServoCommand& sample);
bool from_wire(wire::ServoState& from, ServoState& sample);

}  // namespace lamprey::messaging::fastdds
