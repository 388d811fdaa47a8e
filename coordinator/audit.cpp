#include "coordinator/audit.hpp"

#include "experiment/models.hpp"

#include <cmath>
#include <string>

namespace lamprey::coordinator {

namespace {

/// SplitMix64 (Steele, Lea, Flood 2014): a bijection of 64 bits that mixes well.
std::uint64_t mixed(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9;
  value = (value ^ (value >> 27)) * 0x94d049bb133111eb;
  return value ^ (value >> 31);
}

}  // namespace

bool is_in_audit(double share, std::uint64_t seed, std::uint64_t job) {
  constexpr double two_to_the_53 = 9007199254740992.0;
  const double uniform = static_cast<double>(mixed(mixed(seed) ^ job) >> 11) / two_to_the_53;
  return uniform < share;
}

Id128 audit_id(const Id128& sweep, double share, std::uint64_t seed) {
  const auto share_bits = std::to_string(std::llround(share * 1e9));
  return experiment::leading_128_bits(experiment::sha256("lamprey-audit/1\n" + experiment::to_hex(sweep) + "\n" +
                                                         share_bits + "\n" + std::to_string(seed) + "\n"));
}

JobRanges audit_sample(const experiment::SweepGrid& grid, const JobRanges& done, double share, std::uint64_t seed) {
  JobRanges sample;
  for (const auto& range : done.ranges()) {
    for (std::uint64_t job = range.first; job < range.first + range.count; ++job) {
      if (!is_in_audit(share, seed, job)) continue;
      const auto repeatability = experiment::repeatability(grid.job(job).parameters);
      if (repeatability == experiment::Repeatability::bitwise) sample.add(job, 1);
    }
  }
  return sample;
}

std::map<std::uint64_t, JobRanges> by_author(const storage::ResultsStore& store, std::int64_t sweep,
                                             const JobRanges& jobs) {
  std::map<std::uint64_t, JobRanges> authors;
  for (const auto& range : jobs.ranges()) {
    for (std::uint64_t job = range.first; job < range.first + range.count; ++job) {
      if (const auto stored = store.find_job(sweep, job)) authors[stored->worker].add(job, 1);
    }
  }
  return authors;
}

}  // namespace lamprey::coordinator
