#pragma once

#include "messaging/samples.hpp"

/// The keys of idl/lamprey.idl, for code that treats samples of different keys differently. A sample type without a
/// key_of is keyless: all its samples are one instance.
namespace lamprey::messaging {

inline Id128 key_of(const WorkerStatus& sample) {
  return {0, sample.origin.worker};
}
inline Id128 key_of(const SweepSpecification& sample) {
  return sample.sweep;
}
inline Id128 key_of(const SweepProgress& sample) {
  return sample.sweep;
}
inline Id128 key_of(const RobotStatus& sample) {
  return {0, sample.robot};
}

template <class Sample>
concept Keyed = requires(const Sample& sample) {
  key_of(sample);
};

}  // namespace lamprey::messaging
