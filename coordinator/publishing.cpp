// What anyone may see: specifications for workers, progress for whoever looks.
#include "coordinator/coordinator.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>

namespace lamprey::coordinator {

namespace {

/// Specifications repeated at a time: a site with thousands of open sweeps must not flood its network.
constexpr int repeated_specifications = 16;

/// A write-ahead log beyond this is reported, if a reader is why.
constexpr std::uint64_t large_log_bytes = std::uint64_t{128} << 20;
constexpr auto log_size_interval = std::chrono::seconds{10};

}  // namespace

/// `id`: of the sweep, or of an audit of it.
void Coordinator::publish_specification(const storage::Sweep& sweep, const Id128& id, bool open) {
  messaging::SweepSpecification sample;
  sample.origin = origin();
  sample.sweep = id;
  sample.name = sweep.what.name;
  sample.open = open;
  if (open) {
    const auto& bytes = sweep.what.specification;
    sample.specification.assign(bytes.begin(), bytes.end());
  }
  if (auto result = specifications_->write(sample); !result) {
    spdlog::error("sweep {}: its specification was not published: {}", sample.name, result.error);
  }
}

/// A worker that holds a lease but has missed its sweep's specification must not wait for ever.
void Coordinator::repeat_specifications(Clock::time_point now) {
  if (now < specifications_due_) return;
  specifications_due_ = now + (now < newcomers_until_ ? options_.newcomers_interval : options_.specification_interval);
  for (const auto& [id, audit] : audits_) publish_specification(audit.sweep, id, true);
  auto next = sweeps_.upper_bound(last_repeated_);
  for (int i = 0; i < repeated_specifications && !sweeps_.empty(); ++i) {
    if (next == sweeps_.end()) {
      if (i > 0) break;
      next = sweeps_.begin();
    }
    last_repeated_ = next->first;
    if (next->second.stored.state == storage::SweepState::running) {
      publish_specification(next->second.stored, next->first, true);
    }
    ++next;
  }
}

messaging::SweepProgress Coordinator::progress(const OpenSweep& sweep) const {
  messaging::SweepProgress sample;
  sample.origin = origin();
  const auto& stored = sweep.stored;
  sample.sweep = stored.what.id;
  sample.name = stored.what.name;
  sample.state = to_text(stored.state);
  sample.jobs = stored.what.jobs;
  sample.done = stored.counts.done;
  sample.failed = stored.counts.failed;
  sample.quarantined = stored.counts.quarantined;
  sample.cancelled = stored.counts.cancelled;
  sample.divergences = stored.divergences;
  const std::uint64_t open_jobs = stored.what.jobs - stored.counts.ended();
  sample.leased = std::min(ledger_.leased(stored.what.id), open_jobs);
  sample.pending = open_jobs - sample.leased;
  sample.jobs_per_second = sweep.rate.per_second();
  if (sample.jobs_per_second > 0) sample.seconds_left = static_cast<double>(open_jobs) / sample.jobs_per_second;
  sample.workers = static_cast<std::uint32_t>(ledger_.live_workers());
  return sample;
}

void Coordinator::publish_progress(Clock::time_point now) {
  if (now < progress_due_) return;
  progress_due_ = now + options_.progress_interval;
  for (auto& [id, sweep] : sweeps_) {
    sweep.rate.note(now, sweep.stored.counts.ended());
    if (auto result = progress_->write(progress(sweep)); !result) spdlog::debug("progress: {}", result.error);
  }
}

void Coordinator::watch_log_size(Clock::time_point now) {
  if (now < log_size_due_) return;
  log_size_due_ = now + log_size_interval;
  const auto log = journal_.store().log_size();
  const bool large = log.held_by_reader && log.bytes > large_log_bytes;
  if (large && !log_is_large_) {
    spdlog::warn("{}: a reader's open transaction keeps the write-ahead log from being reset; it has grown to {} MB",
                 journal_.store().path(), log.bytes >> 20);
  }
  log_is_large_ = large;
}

}  // namespace lamprey::coordinator
