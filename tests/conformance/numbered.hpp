#pragma once

#include "messaging/keys.hpp"
#include "messaging/port.hpp"
#include "messaging/qos.hpp"

#include <cstdint>
#include <type_traits>
#include <vector>

/// Samples of any topic with a number and, where the topic has keys, a key: for what holds for all topics alike.
namespace lamprey::messaging::conformance {

template <class Sample>
auto& number_in(Sample& sample) {
  if constexpr (requires { sample.origin; }) {
    return sample.origin.epoch;
  } else if constexpr (requires { sample.token; }) {
    return sample.token;
  } else {
    return sample.malformed;
  }
}

template <class Sample>
std::uint64_t number_of(const Sample& sample) {
  return number_in(sample);
}

template <class Sample>
std::vector<std::uint64_t> numbers_of(const std::vector<Sample>& samples) {
  std::vector<std::uint64_t> all;
  all.reserve(samples.size());
  for (const auto& sample : samples) all.push_back(number_of(sample));
  return all;
}

/// first, first + 1, … last; empty if last is before first.
inline std::vector<std::uint64_t> numbers_from(std::uint64_t first, std::uint64_t last) {
  std::vector<std::uint64_t> all;
  for (std::uint64_t number = first; number <= last; ++number) all.push_back(number);
  return all;
}

inline void set_key(WorkerStatus& sample, std::uint64_t key) {
  sample.origin.worker = key;
}
inline void set_key(SweepSpecification& sample, std::uint64_t key) {
  sample.sweep = {0, key};
}
inline void set_key(SweepProgress& sample, std::uint64_t key) {
  sample.sweep = {0, key};
}
inline void set_key(RobotStatus& sample, std::uint64_t key) {
  sample.robot = key;
}

/// Topics without keys take no notice of it.
template <class Sample>
Sample numbered(std::uint64_t number, std::uint64_t key = 0) {
  Sample sample;
  number_in(sample) = number;
  if constexpr (Keyed<Sample>) set_key(sample, key);
  return sample;
}

/// Calls action(std::type_identity<Sample>{}) for the sample type of each topic.
template <class Action>
void for_each_topic(const Action& action) {
  const auto all = [&]<class... Samples>(TopicPorts<Samples...>*) { (action(std::type_identity<Samples>{}), ...); };
  all(static_cast<Participant*>(nullptr));
}

}  // namespace lamprey::messaging::conformance
