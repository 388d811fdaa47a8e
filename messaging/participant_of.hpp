#pragma once

#include "messaging/port.hpp"

#include <memory>
#include <type_traits>
#include <utility>

/// For those who implement the port: turns two member templates into the overrides of all sample types.
namespace lamprey::messaging {

template <class Derived, class Base, class... Samples>
class Overrides;

template <class Derived, class Base>
class Overrides<Derived, Base> : public Base {};

template <class Derived, class Base, class Sample, class... Others>
class Overrides<Derived, Base, Sample, Others...> : public Overrides<Derived, Base, Others...> {
 public:
  using Overrides<Derived, Base, Others...>::make_writer;
  using Overrides<Derived, Base, Others...>::make_reader;

  std::unique_ptr<Writer<Sample>> make_writer(std::type_identity<Sample>, Partition partition) final {
    return static_cast<Derived*>(this)->template open_writer<Sample>(partition);
  }
  std::unique_ptr<Reader<Sample>> make_reader(std::type_identity<Sample>, Partition partition,
                                              std::shared_ptr<Signal> signal) final {
    return static_cast<Derived*>(this)->template open_reader<Sample>(partition, std::move(signal));
  }
};

/// Base of a vendor's participant, which has the public members
/// `template <class Sample> std::unique_ptr<Writer<Sample>> open_writer(Partition)` and
/// `template <class Sample> std::unique_ptr<Reader<Sample>> open_reader(Partition, std::shared_ptr<Signal>)`.
template <class Derived>
using ParticipantOf = Overrides<Derived, Participant, WorkerStatus, SweepSpecification, Lease, ResultBatch,
                                ResultAcknowledgement, Checkpoint, Request, Reply, SweepProgress, Traffic, RobotStatus,
                                RobotRequest, RobotReply, ServoCommand, ServoState>;

}  // namespace lamprey::messaging
