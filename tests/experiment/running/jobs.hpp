#pragma once

#include "experiment/job_run.hpp"

#include <initializer_list>
#include <string>
#include <utility>
#include <variant>

namespace lamprey::experiment {

using Setting = std::pair<const char*, Value>;

inline Parameters parameters_with(std::initializer_list<Setting> settings) {
  Parameters parameters;
  for (const auto& [name, value] : settings) parameters.set(name, value);
  return parameters;
}

inline Job job_with(std::initializer_list<Setting> settings, std::uint64_t seed = 2006, std::uint32_t replicate = 0) {
  return {.number = 0, .seed = seed, .replicate = replicate, .parameters = parameters_with(settings)};
}

inline Value text(const char* value) {
  return std::string(value);
}
inline Value whole(std::int64_t value) {
  return value;
}

/// Runs to the end; throws std::bad_variant_access if it was interrupted.
inline Outcome outcome_of(const Job& job) {
  return std::get<Outcome>(run_job(job, {}));
}

inline std::string digest_of(const Job& job) {
  return to_hex(outcome_digest(identity(job), outcome_of(job)));
}

}  // namespace lamprey::experiment
