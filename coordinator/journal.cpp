#include "coordinator/journal.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>

namespace lamprey::coordinator {

namespace {

/// Events wait in memory while nothing can be stored; beyond so many the newest are only counted.
constexpr std::size_t most_events = 100'000;

}  // namespace

Journal::Journal(storage::ResultsStore store, JournalOptions options, Clock::time_point now)
    : store_(std::move(store)), options_(options), staged_since_(now), retry_at_(now) {}

void Journal::event(std::string kind, std::uint64_t worker, std::string text, std::optional<std::int64_t> sweep,
                    std::optional<std::uint64_t> job) {
  if (batch_.events.size() >= most_events) {
    ++counters_.dropped_events;
    return;
  }
  batch_.events.push_back({std::move(kind), sweep, job, worker, std::move(text)});
}

void Journal::add(const Id128& id, storage::EndedJob row, std::size_t bytes, Clock::time_point now) {
  if (batch_.empty()) staged_since_ = now;
  staged_.emplace(std::pair(id, row.job), storage::ResultsStore::StoredJob{row.state, row.digest, row.worker});
  staged_bytes_ += bytes;
  batch_.jobs.push_back(std::move(row));
  arrivals_.push_back(now);
}

void Journal::add(storage::RecordedAttempt attempt, std::size_t bytes) {
  // While nothing can be stored its worker sends it again and again.
  if (std::ranges::find(batch_.recordings, attempt) != batch_.recordings.end()) return;
  staged_bytes_ += bytes;
  batch_.recordings.push_back(std::move(attempt));
}

const storage::ResultsStore::StoredJob* Journal::staged(const Id128& sweep, std::uint64_t job) const {
  const auto found = staged_.find({sweep, job});
  return found == staged_.end() ? nullptr : &found->second;
}

std::optional<storage::Batch> Journal::commit(Clock::time_point now) {
  if (batch_.empty()) {
    staged_since_ = now;
    hurried_ = false;
    return std::nullopt;
  }
  const bool due =
      hurried_ || now - staged_since_ >= options_.commit_interval || staged_bytes_ >= options_.commit_bytes;
  if (healthy() ? !due : now < retry_at_) return std::nullopt;
  for (std::size_t i = 0; i < batch_.jobs.size(); ++i) {
    batch_.jobs[i].commit_seconds = std::chrono::duration<double>(now - arrivals_[i]).count();
  }
  const auto begin = std::chrono::steady_clock::now();
  try {
    store_.commit(batch_);
  } catch (const storage::StorageError& error) {
    note_fault(error, now);
    return std::nullopt;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++counters_.commits;
  counters_.seconds += seconds;
  counters_.longest_seconds = std::max(counters_.longest_seconds, seconds);
  if (!std::exchange(fault_, {}).empty()) spdlog::info("{}: going on, it can be written again", store_.path());
  arrivals_.clear();
  staged_.clear();
  staged_bytes_ = 0;
  staged_since_ = now;
  hurried_ = false;
  return std::exchange(batch_, {});
}

void Journal::note_fault(const storage::StorageError& error, Clock::time_point now) {
  ++counters_.faults;
  retry_at_ = now + options_.storage_retry;
  if (fault_ == error.what()) return;
  spdlog::error("{}; waiting: nothing is lost, and it is tried again every {} s", error.what(),
                std::chrono::duration_cast<std::chrono::seconds>(options_.storage_retry).count());
  // Also what there is to commit, and so to find out by that all is well again.
  event("storage_fault", 0, error.what());
  fault_ = error.what();
}

}  // namespace lamprey::coordinator
