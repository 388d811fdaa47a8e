#pragma once

#include "messaging/samples.hpp"

#include <lampreyPubSubTypes.h>

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
LAMPREY_WIRE_TYPE(ResultBatch);
LAMPREY_WIRE_TYPE(ResultAcknowledgement);
LAMPREY_WIRE_TYPE(Request);
LAMPREY_WIRE_TYPE(Reply);
LAMPREY_WIRE_TYPE(SweepProgress);
#undef LAMPREY_WIRE_TYPE

wire::WorkerStatus to_wire(const WorkerStatus& sample);
wire::SweepSpecification to_wire(const SweepSpecification& sample);
wire::Lease to_wire(const Lease& sample);
wire::ResultBatch to_wire(const ResultBatch& sample);
wire::ResultAcknowledgement to_wire(const ResultAcknowledgement& sample);
wire::Request to_wire(const Request& sample);
wire::Reply to_wire(const Reply& sample);
wire::SweepProgress to_wire(const SweepProgress& sample);

/// Moves what it can out of `from`. False if the sample says what none of ours can say (an unknown enumerator, columns
/// of unequal length).
bool from_wire(wire::WorkerStatus& from, WorkerStatus& sample);
bool from_wire(wire::SweepSpecification& from, SweepSpecification& sample);
bool from_wire(wire::Lease& from, Lease& sample);
bool from_wire(wire::ResultBatch& from, ResultBatch& sample);
bool from_wire(wire::ResultAcknowledgement& from, ResultAcknowledgement& sample);
bool from_wire(wire::Request& from, Request& sample);
bool from_wire(wire::Reply& from, Reply& sample);
bool from_wire(wire::SweepProgress& from, SweepProgress& sample);

}  // namespace lamprey::messaging::fastdds
