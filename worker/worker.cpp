#include "worker/worker.hpp"

#include <algorithm>
#include <spdlog/spdlog.h>
#include <utility>
#include <variant>

namespace lamprey::worker {

namespace {

/// News (a lease taken, a lease ended) is told at once, but not more often than this.
constexpr auto shortest_status_interval = std::chrono::milliseconds{20};

/// More coordinators, or sweeps, than any site has: what comes from the network must not fill the memory.
constexpr std::size_t most_coordinators = 256;
constexpr std::size_t most_sweeps = 100'000;

messaging::JobResult to_message(const Task& task, experiment::BatchResult computed) {
  messaging::JobResult message;
  message.job = task.job;
  message.lease = task.lease;
  message.identity = computed.identity;
  message.seconds = computed.seconds;
  if (auto* outcome = std::get_if<experiment::Outcome>(&computed.result)) {
    message.kind = messaging::ResultKind::done;
    message.digest = experiment::outcome_digest(computed.identity, *outcome);
    message.outcome = std::move(*outcome);
  } else {
    message.kind = messaging::ResultKind::failed;
    message.reason = std::get<experiment::Failure>(computed.result).reason;
  }
  return message;
}

}  // namespace

Worker::Worker(messaging::Participant& participant, JobExecutor& executor, std::shared_ptr<messaging::Signal> signal,
               WorkerOptions options, Clock::time_point now)
    : participant_(participant),
      executor_(executor),
      options_(std::move(options)),
      vendor_(participant.vendor()),
      specifications_(participant.reader<messaging::SweepSpecification>(signal)),
      leases_(participant.reader<messaging::Lease>(signal, messaging::Partition::of(options_.incarnation))),
      acknowledgements_(
          participant.reader<messaging::ResultAcknowledgement>(signal, messaging::Partition::of(options_.incarnation))),
      status_(participant.writer<messaging::WorkerStatus>()),
      results_(participant.writer<messaging::ResultBatch>()),
      checkpoints_(participant.writer<messaging::Checkpoint>()),
      outbox_(options_.outbox),
      status_due_(now) {}

void Worker::step(Clock::time_point now) {
  take_specifications();
  take_leases();
  take_acknowledgements();
  take_finished(now);
  send_checkpoints();
  choose_jobs();
  if (auto offered = executor_.labels(); offered != offered_) {
    offered_ = std::move(offered);
    status_changed_ = true;
  }
  // Before they start: if a job ends this process at once, the coordinator has heard what was running.
  send_status(now);
  start_jobs();
  send_results(now);
}

/// Whether the sample comes from the newest coordinator known for its database. A newer one than before may not have
/// what was sent to its predecessor, and wants to hear at once what this worker holds.
bool Worker::current(const messaging::Origin& origin) {
  const auto known = coordinators_.find(origin.database);
  if (known != coordinators_.end() && origin.epoch < known->second.epoch) return false;
  if (known == coordinators_.end() && coordinators_.size() >= most_coordinators) return false;
  auto& coordinator = coordinators_[origin.database];
  if (origin.epoch > coordinator.epoch) {
    if (coordinator.epoch > 0) {
      spdlog::info("the coordinator has started anew (epoch {}); {} results are sent to it again", origin.epoch,
                   outbox_.held());
    }
    coordinator = {.epoch = origin.epoch, .last_lease_sequence = 0};
    outbox_.resend_all(origin.database);
    status_changed_ = true;
  }
  last_database_ = origin.database;
  return true;
}

void Worker::take_specifications() {
  for (const auto& sample : specifications_->take()) {
    if (!current(sample.origin)) continue;
    const auto key = std::pair(sample.origin.database, sample.sweep);
    if (!sample.open) {
      grids_.erase(key);
      continue;
    }
    if (grids_.contains(key) || grids_.size() >= most_sweeps) continue;
    idl::SweepSpecification specification;
    const auto& bytes = sample.specification;
    if (!specification.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
      cannot_compute(sample, "its specification cannot be read");
      continue;
    }
    try {
      grids_[key] = std::make_shared<const experiment::SweepGrid>(specification);
      spdlog::info("sweep {}: {} jobs", sample.name, grids_[key]->jobs());
    } catch (const experiment::InvalidInput& error) {
      grids_.erase(key);
      cannot_compute(sample, error.what());
    }
  }
}

void Worker::cannot_compute(const messaging::SweepSpecification& sample, const std::string& reason) {
  const auto key = std::pair(sample.origin.database, sample.sweep);
  ++counters_.specifications_refused;
  book_.forget_sweep(key.first, key.second);
  status_changed_ = true;
  if (unusable_.size() < most_sweeps && unusable_.insert(key).second) {
    spdlog::error("sweep {} is left to other workers: {}; is the coordinator of another version?", sample.name, reason);
  }
}

void Worker::take_leases() {
  for (const auto& lease : leases_->take()) {
    // A partition is a name, not a lock: whatever else is in it is nothing to obey.
    if (lease.origin.worker != options_.incarnation || !current(lease.origin)) {
      ++counters_.leases_ignored;
      continue;
    }
    auto& coordinator = coordinators_[lease.origin.database];
    coordinator.last_lease_sequence = std::max(coordinator.last_lease_sequence, lease.sequence);
    take_lease(lease);
  }
}

void Worker::take_lease(const messaging::Lease& lease) {
  switch (lease.kind) {
    case messaging::LeaseKind::welcome:
      spdlog::info("connected to a coordinator, epoch {}", lease.origin.epoch);
      // It had not known this worker, or had given it up: what was sent meanwhile has not arrived.
      outbox_.resend_all(lease.origin.database);
      break;
    case messaging::LeaseKind::refuse:
      spdlog::error("the coordinator gives this worker no work: {}", lease.reason);
      break;
    case messaging::LeaseKind::drain:
      if (!std::exchange(draining_, true)) {
        spdlog::info("told to drain: finishes the {} leases that it holds, then leaves", book_.size());
        status_changed_ = true;
      }
      break;
    case messaging::LeaseKind::revoke:
      revoke(lease);
      break;
    case messaging::LeaseKind::grant: {
      const bool usable = !leaving_ && lease.origin.science_version == experiment::science_version &&
                          !unusable_.contains({lease.origin.database, lease.sweep});
      const bool taken = usable && book_.grant(lease);
      ++(taken ? counters_.leases_taken : counters_.leases_ignored);
      status_changed_ = status_changed_ || taken;
      break;
    }
  }
}

void Worker::revoke(const messaging::Lease& lease) {
  const LeaseBook::Key key{lease.origin.database, lease.lease};
  if (lease.interrupt) {
    executor_.interrupt(key.first, key.second);
  } else {
    executor_.drop(key.first, key.second);
  }
  status_changed_ = true;
  if (!book_.revoke(key)) return;
  ++counters_.leases_revoked;
  spdlog::info("lease {:x} is revoked: {}", lease.lease, lease.reason);
}

void Worker::take_acknowledgements() {
  for (const auto& sample : acknowledgements_->take()) {
    if (sample.origin.worker != options_.incarnation || !current(sample.origin)) continue;
    for (const auto& answer : sample.results) {
      if (!outbox_.acknowledge(sample.origin.database, answer)) continue;
      const std::size_t leases = book_.size();
      book_.settled(sample.origin.database, answer.sweep, answer.job);
      status_changed_ = status_changed_ || book_.size() != leases;
      note(answer);
    }
  }
}

/// The coordinator, which knows the whole story, has logged it at the level that it deserves.
void Worker::note(const messaging::Acknowledgement& answer) {
  switch (answer.verdict) {
    case messaging::Verdict::committed:
      spdlog::debug("acknowledged: sweep {} job {} committed", experiment::to_hex(answer.sweep), answer.job);
      break;
    case messaging::Verdict::duplicate:
      ++counters_.results_duplicate;
      break;
    case messaging::Verdict::refused:
      ++counters_.results_refused;
      spdlog::info("the result of job {} is refused: {}", answer.job, answer.reason);
      break;
    case messaging::Verdict::divergent:
      ++counters_.results_divergent;
      spdlog::error("the result of job {} is divergent: {}", answer.job, answer.reason);
      break;
  }
}

void Worker::send_checkpoints() {
  for (auto& checkpoint : executor_.take_checkpoints()) send_checkpoint(std::move(checkpoint));
}

/// One that is lost costs the computation since the one before, no more.
void Worker::send_checkpoint(messaging::Checkpoint checkpoint) {
  const Id128 database = checkpoint.origin.database;
  checkpoint.origin = {database, coordinators_[database].epoch, options_.incarnation, experiment::science_version};
  if (const auto written = checkpoints_->write(checkpoint)) {
    ++counters_.checkpoints_sent;
  } else {
    spdlog::debug("the checkpoint of job {} was not sent: {}", checkpoint.job, written.error);
  }
}

void Worker::take_finished(Clock::time_point now) {
  for (auto& finished : executor_.take_finished()) {
    if (finished.checkpoint) send_checkpoint(std::move(*finished.checkpoint));
    if (std::holds_alternative<experiment::Interrupted>(finished.result.result)) {
      // Given back, or its lease is gone already: what no longer is in the heartbeat is leased to others.
      book_.revoke({finished.task.database, finished.task.lease});
      continue;
    }
    ++jobs_done_;
    const double waited = finished.waited;
    auto recording = std::move(finished.recording);
    auto message = to_message(finished.task, std::move(finished.result));
    message.waited = waited;
    message.recording = std::move(recording);
    outbox_.add(finished.task.database, finished.task.sweep, std::move(message), now);
  }
}

void Worker::choose_jobs() {
  if (leaving_) return;
  if (outbox_.full()) {
    if (!std::exchange(said_full_, true)) {
      spdlog::warn("{} results wait for a coordinator; nothing more is computed until it has taken some",
                   outbox_.held());
    }
    return;
  }
  said_full_ = false;
  const auto wanted = executor_.wanted();
  if (wanted == 0) return;
  const auto known = [this](const Id128& database, const Id128& sweep) { return grids_.contains({database, sweep}); };
  for (auto& start : book_.start(wanted, known)) {
    if (outbox_.holds(start.lease.first, start.sweep, start.job)) continue;
    const auto& grid = grids_.at({start.lease.first, start.sweep});
    if (start.job >= grid->jobs()) {
      book_.settled(start.lease.first, start.sweep, start.job);
      continue;
    }
    starting_.push_back({.database = start.lease.first,
                         .sweep = start.sweep,
                         .lease = start.lease.second,
                         .job = start.job,
                         .grid = grid,
                         .checkpoint = std::move(start.checkpoint),
                         .time_limit = start.time_limit});
  }
}

void Worker::start_jobs() {
  if (!starting_.empty()) executor_.submit(std::exchange(starting_, {}));
}

void Worker::send_results(Clock::time_point now) {
  const bool flush = leaving_ || executor_.idle();
  bool keeps_up = true;
  for (auto& batch : outbox_.due(now, flush)) {
    // A reader that does not keep up costs one failed write per step, not one per batch.
    if (!keeps_up) {
      outbox_.postpone(batch, now);
      continue;
    }
    const Id128 database = batch.origin.database;
    batch.origin = {database, coordinators_[database].epoch, options_.incarnation, experiment::science_version};
    batch.sequence = ++batches_;
    const auto written = results_->write(batch);
    if (written) continue;
    if (written.kind == messaging::WriteResult::Kind::failed) spdlog::warn("results were not sent: {}", written.error);
    outbox_.postpone(batch, now);
    keeps_up = false;
  }
}

messaging::WorkerStatus Worker::status() const {
  messaging::WorkerStatus status;
  const auto coordinator = coordinators_.find(last_database_);
  const bool known = coordinator != coordinators_.end();
  status.origin = {last_database_, known ? coordinator->second.epoch : 0, options_.incarnation,
                   experiment::science_version};
  status.heartbeat = heartbeats_;
  status.state = leaving_ || draining_ ? messaging::WorkerState::draining : messaging::WorkerState::ready;
  status.threads = executor_.threads();
  status.window = outbox_.full() ? 0 : executor_.threads() * options_.leases_per_thread;
  status.last_lease_sequence = known ? coordinator->second.last_lease_sequence : 0;
  status.jobs_done = jobs_done_;
  status.results_held = outbox_.held();
  status.leases = book_.held();
  status.running = executor_.running();
  const std::size_t next = std::min<std::size_t>(starting_.size(), executor_.threads());
  for (std::size_t i = 0; i < next; ++i) status.running.push_back({starting_[i].sweep, starting_[i].job});
  status.host = options_.host;
  status.process = options_.process;
  status.build = options_.build;
  status.flags = options_.flags;
  status.processor = options_.processor;
  status.instruction_set = options_.instruction_set;
  status.dds = vendor_;
  status.labels = options_.labels;
  status.labels.insert(status.labels.end(), offered_.begin(), offered_.end());
  status.counters = {{"checkpoints_sent", counters_.checkpoints_sent},
                     {"leases_ignored", counters_.leases_ignored},
                     {"leases_revoked", counters_.leases_revoked},
                     {"leases_taken", counters_.leases_taken},
                     {"results_divergent", counters_.results_divergent},
                     {"results_duplicate", counters_.results_duplicate},
                     {"results_refused", counters_.results_refused},
                     {"results_sent_again", outbox_.sent_again()},
                     {"samples_malformed", participant_.malformed_samples()},
                     {"specifications_refused", counters_.specifications_refused}};
  return status;
}

void Worker::send_status(Clock::time_point now) {
  // What may be the last job of this process is told before it starts, however short ago the last heartbeat was.
  const bool alone = starting_.size() == 1 && executor_.idle();
  const bool news = (status_changed_ && (alone || now - last_status_ >= shortest_status_interval)) || alone;
  if (!news && now < status_due_) return;
  ++heartbeats_;
  if (auto result = status_->write(status()); !result) spdlog::debug("heartbeat: {}", result.error);
  last_status_ = now;
  status_due_ = now + options_.heartbeat;
  status_changed_ = false;
}

void Worker::begin_leaving(Clock::time_point now) {
  leaving_ = true;
  executor_.stop();
  take_finished(now);
  status_changed_ = true;
}

void Worker::goodbye(Clock::time_point now) {
  book_.clear();
  ++heartbeats_;
  auto last = status();
  last.state = messaging::WorkerState::leaving;
  if (auto result = status_->write(last); !result) spdlog::debug("goodbye: {}", result.error);
  last_status_ = now;
}

}  // namespace lamprey::worker
