#pragma once

#include "lamprey.h"
#include "messaging/samples.hpp"
#include "robot.h"

#include <dds/dds.h>
#include <memory_resource>

/// Our samples as the C types that idlc generates, and back.
namespace lamprey::messaging::cyclonedds {

/// The generated type and its descriptor.
template <class Sample>
struct Wire;

#define LAMPREY_WIRE_TYPE(Sample)                                                               \
  template <>                                                                                   \
  struct Wire<Sample> {                                                                         \
    using Type = lamprey_wire_##Sample;                                                         \
    static const dds_topic_descriptor_t* descriptor() { return &lamprey_wire_##Sample##_desc; } \
  }
LAMPREY_WIRE_TYPE(WorkerStatus);
LAMPREY_WIRE_TYPE(SweepSpecification);
LAMPREY_WIRE_TYPE(Lease);
LAMPREY_WIRE_TYPE(ResultBatch);
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

/// Holds the arrays that a generated struct points to.
using Arena = std::pmr::monotonic_buffer_resource;

/// The generated struct borrows: it is valid while `sample` and `arena` are, and must not be freed or changed.
lamprey_wire_WorkerStatus to_wire(const WorkerStatus& sample, Arena& arena);
lamprey_wire_SweepSpecification to_wire(const SweepSpecification& sample, Arena& arena);
lamprey_wire_Lease to_wire(const Lease& sample, Arena& arena);
lamprey_wire_ResultBatch to_wire(const ResultBatch& sample, Arena& arena);
lamprey_wire_ResultAcknowledgement to_wire(const ResultAcknowledgement& sample, Arena& arena);
lamprey_wire_Checkpoint to_wire(const Checkpoint& sample, Arena& arena);
lamprey_wire_Request to_wire(const Request& sample, Arena& arena);
lamprey_wire_Reply to_wire(const Reply& sample, Arena& arena);
lamprey_wire_SweepProgress to_wire(const SweepProgress& sample, Arena& arena);
lamprey_wire_Traffic to_wire(const Traffic& sample, Arena& arena);
lamprey_wire_RobotStatus to_wire(const RobotStatus& sample, Arena& arena);
lamprey_wire_RobotRequest to_wire(const RobotRequest& sample, Arena& arena);
lamprey_wire_RobotReply to_wire(const RobotReply& sample, Arena& arena);
lamprey_wire_ServoCommand to_wire(const ServoCommand& sample, Arena& arena);
lamprey_wire_ServoState to_wire(const ServoState& sample, Arena& arena);

/// False if the sample says what none of ours can say (an unknown enumerator, columns of unequal length).
bool from_wire(const lamprey_wire_WorkerStatus& wire, WorkerStatus& sample);
bool from_wire(const lamprey_wire_SweepSpecification& wire, SweepSpecification& sample);
bool from_wire(const lamprey_wire_Lease& wire, Lease& sample);
bool from_wire(const lamprey_wire_ResultBatch& wire, ResultBatch& sample);
bool from_wire(const lamprey_wire_ResultAcknowledgement& wire, ResultAcknowledgement& sample);
bool from_wire(const lamprey_wire_Checkpoint& wire, Checkpoint& sample);
bool from_wire(const lamprey_wire_Request& wire, Request& sample);
bool from_wire(const lamprey_wire_Reply& wire, Reply& sample);
bool from_wire(const lamprey_wire_SweepProgress& wire, SweepProgress& sample);
bool from_wire(const lamprey_wire_Traffic& wire, Traffic& sample);
bool from_wire(const lamprey_wire_RobotStatus& wire, RobotStatus& sample);
bool from_wire(const lamprey_wire_RobotRequest& wire, RobotRequest& sample);
bool from_wire(const lamprey_wire_RobotReply& wire, RobotReply& sample);
bool from_wire(const lamprey_wire_ServoCommand& wire, ServoCommand& sample);
bool from_wire(const lamprey_wire_ServoState& wire, ServoState& sample);

}  // namespace lamprey::messaging::cyclonedds
