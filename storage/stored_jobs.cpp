#include "storage/job_row.hpp"
#include "storage/store_implementation.hpp"

#include <limits>

namespace lamprey::storage {

experiment::JobRanges read_ranges(Statement& numbers) {
  experiment::JobRanges ranges;
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  while (numbers.step()) {
    const std::uint64_t job = numbers.bits(0);
    if (job != first + count) {
      if (count > 0) ranges.add(first, count);
      first = job;
      count = 0;
    }
    ++count;
  }
  if (count > 0) ranges.add(first, count);
  return ranges;
}

experiment::JobRanges ResultsStore::ended_jobs(std::int64_t sweep) const {
  Statement numbers(implementation_->connection, "SELECT job FROM job WHERE sweep = ? ORDER BY job");
  return read_ranges(numbers.with(sweep));
}

experiment::JobRanges ResultsStore::done_jobs(std::int64_t sweep) const {
  Statement numbers(implementation_->connection, "SELECT job FROM job WHERE sweep = ? AND state = 'done' ORDER BY job");
  return read_ranges(numbers.with(sweep));
}

std::optional<ResultsStore::StoredJob> ResultsStore::find_job(std::int64_t sweep, std::uint64_t job) const {
  auto& find = implementation_->find_job;
  find.with(sweep, job);
  std::optional<StoredJob> found;
  if (find.step()) {
    found.emplace();
    const auto state = job_state(find.text(0));
    if (!state) {
      const std::string text(find.text(0));
      find.reset();
      throw StorageError(StorageError::Kind::corrupt, path() + ": no job has the state '" + text + "'");
    }
    found->state = *state;
    found->digest = find.digest(1);
    found->worker = find.bits(2);
  }
  find.reset();
  return found;
}

std::optional<EndedJob> ResultsStore::read_job(std::int64_t sweep, std::uint64_t job) const {
  auto& read = implementation_->read_job;
  read.with(sweep, job);
  std::optional<StoredJobRow> stored;
  if (read.step()) stored = read_job_row(read);
  read.reset();
  if (!stored || !stored->malformed.empty()) return std::nullopt;
  return std::move(stored->job);
}

std::vector<ResultsStore::StoredIdentity> ResultsStore::identities(std::uint64_t seed, std::int64_t but_of_sweep,
                                                                   const Place& after, std::uint64_t most) const {
  const auto& connection = implementation_->connection;
  Statement sweeps(connection,
                   "SELECT sweep FROM sweep WHERE seed = ? AND sweep <> ? AND sweep >= ? AND done > 0 "
                   "AND state <> 'deleting' ORDER BY sweep");
  Statement jobs(connection,
                 "SELECT job, identity FROM job WHERE sweep = ? AND job >= ? AND state = 'done' ORDER BY job LIMIT ?");
  std::vector<StoredIdentity> found;
  sweeps.with(seed, but_of_sweep, after.begun ? after.sweep : std::numeric_limits<std::int64_t>::min());
  while (found.size() < most && sweeps.step()) {
    const auto sweep = sweeps.integer(0);
    const bool goes_on = after.begun && sweep == after.sweep;
    jobs.with(sweep, goes_on ? after.job + 1 : 0, most - found.size());
    while (jobs.step()) {
      // A malformed identity is verify's to report; nothing can be reused by it.
      if (const auto identity = jobs.digest(1)) found.push_back({{sweep, jobs.bits(0), true}, *identity});
    }
    jobs.reset();
  }
  return found;
}

std::vector<ResultsStore::CountedAttempts> ResultsStore::counted_attempts(std::int64_t sweep) const {
  Statement attempts(implementation_->connection,
                     "SELECT job, worker FROM attempt WHERE sweep = ?1 AND counted = 1 "
                     "AND NOT EXISTS (SELECT 1 FROM job WHERE job.sweep = ?1 AND job.job = attempt.job) "
                     "ORDER BY job, attempt");
  attempts.with(sweep);
  std::vector<CountedAttempts> counted;
  while (attempts.step()) {
    const auto job = attempts.bits(0);
    if (counted.empty() || counted.back().job != job) counted.push_back({job, {}});
    counted.back().workers.push_back(attempts.bits(1));
  }
  return counted;
}

std::vector<std::uint64_t> ResultsStore::checkpointed_jobs(std::int64_t sweep) const {
  Statement numbers(implementation_->connection, "SELECT job FROM checkpoint WHERE sweep = ? ORDER BY job");
  numbers.with(sweep);
  std::vector<std::uint64_t> jobs;
  while (numbers.step()) jobs.push_back(numbers.bits(0));
  return jobs;
}

std::optional<Checkpoint> ResultsStore::find_checkpoint(std::int64_t sweep, std::uint64_t job) const {
  Statement find(implementation_->connection,
                 "SELECT worker, cycle, seconds, state FROM checkpoint WHERE sweep = ? AND job = ?");
  find.with(sweep, job);
  if (!find.step()) return std::nullopt;
  const auto state = find.blob(3);
  return Checkpoint{.sweep = sweep,
                    .job = job,
                    .worker = find.bits(0),
                    .cycle = static_cast<std::uint32_t>(find.bits(1)),
                    .seconds = find.real(2),
                    .state = {state.begin(), state.end()}};
}

}  // namespace lamprey::storage
