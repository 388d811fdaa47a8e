// The client's wishes. Every request may come twice (the client repeats it until it is answered), so each is
// idempotent.
#include "coordinator/coordinator.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <exception>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::coordinator {

namespace {

/// A reply stays below about this; longer tables are paged.
constexpr std::size_t reply_bytes = 48 * 1024;
constexpr std::size_t most_problems_in_reply = 50;

idl::Reply error_reply(const std::string& code, const std::string& message) {
  idl::Reply reply;
  reply.mutable_error()->set_code(code);
  reply.mutable_error()->add_messages(message);
  return reply;
}

idl::Reply unknown_sweep(const std::string& wanted, const std::vector<storage::Sweep>& sweeps) {
  std::vector<std::string_view> names;
  for (const auto& sweep : sweeps) names.emplace_back(sweep.what.name);
  std::string message = "no sweep '" + wanted + "' in this database";
  if (const auto nearest = experiment::nearest_name(wanted, names); !nearest.empty()) {
    message += "; did you mean '" + nearest + "'?";
  }
  return error_reply("unknown_sweep", message);
}

std::string hex16(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
  return text.data();
}

std::string state_text(messaging::WorkerState state) {
  switch (state) {
    case messaging::WorkerState::ready:
      return "ready";
    case messaging::WorkerState::draining:
      return "draining";
    case messaging::WorkerState::leaving:
      return "leaving";
  }
  return "unknown";
}

}  // namespace

void Coordinator::take_requests(Clock::time_point now) {
  for (const auto& sample : requests_->take(64)) {
    // A client that names a database means its coordinator only.
    const bool for_another = sample.origin.database != Id128{} && sample.origin.database != store_.database_id();
    if (sample.client == 0 || for_another) continue;
    idl::Request request;
    idl::Reply reply;
    if (!request.ParseFromArray(sample.payload.data(), static_cast<int>(sample.payload.size()))) {
      reply = error_reply("malformed", "the request cannot be read; is the client of another version?");
    } else {
      try {
        reply = handle(request, now);
      } catch (const storage::StorageError& error) {
        spdlog::error("a client's request failed: {}", error.what());
        reply = error_reply(error.kind() == storage::StorageError::Kind::name_taken ? "name_taken" : "storage",
                            error.what());
      } catch (const std::exception& error) {
        spdlog::error("a client's request failed: {}", error.what());
        reply = error_reply("internal", error.what());
      }
    }
    messaging::Reply answer;
    answer.origin = origin();
    answer.client = sample.client;
    answer.correlation = sample.correlation;
    const std::string bytes = reply.SerializeAsString();
    answer.payload.assign(bytes.begin(), bytes.end());
    replies_.write(sample.client, answer);
  }
}

idl::Reply Coordinator::handle(const idl::Request& request, Clock::time_point now) {
  switch (request.kind_case()) {
    case idl::Request::kSubmit:
      return submit(request.submit(), now);
    case idl::Request::kStatus:
      return status(request.status());
    case idl::Request::kCancel:
      return cancel(request.cancel(), now);
    case idl::Request::kResults:
      return results(request.results());
    case idl::Request::kStoredJob:
      return stored_job(request.stored_job());
    case idl::Request::KIND_NOT_SET:
      break;
  }
  return error_reply("malformed", "the request asks for nothing that this coordinator knows");
}

idl::Reply Coordinator::submit(const idl::SubmitRequest& request, Clock::time_point now) {
  const auto& specification = request.specification();
  if (const auto problems = experiment::validate(specification); !problems.empty()) {
    idl::Reply reply;
    auto* error = reply.mutable_error();
    error->set_code("invalid_specification");
    for (std::size_t i = 0; i < std::min(problems.size(), most_problems_in_reply); ++i) {
      error->add_messages(problems[i].message);
      error->add_fields(problems[i].field);
    }
    return reply;
  }
  const experiment::SweepGrid grid(specification);
  storage::NewSweep sweep;
  sweep.id = experiment::sweep_id(specification);
  sweep.name = specification.name();
  sweep.specification = specification.SerializeAsString();
  sweep.source = request.source();
  sweep.seed = specification.seed();
  sweep.replicates = grid.replicates();
  sweep.jobs = grid.jobs();
  const auto added = store_.add_sweep(sweep);
  if (!added.existed) {
    open(added.sweep, true);
    sweeps_.at(sweep.id).rate.note(now, 0);
    spdlog::info("sweep {}: {} jobs submitted", sweep.name, sweep.jobs);
  }
  idl::Reply reply;
  reply.mutable_submit()->set_id(experiment::to_hex(sweep.id));
  reply.mutable_submit()->set_jobs(sweep.jobs);
  reply.mutable_submit()->set_existed(added.existed);
  return reply;
}

std::optional<storage::Sweep> Coordinator::find_sweep(const std::string& name_or_id) const {
  for (auto& sweep : store_.sweeps()) {
    if (sweep.what.name == name_or_id || experiment::to_hex(sweep.what.id) == name_or_id) return sweep;
  }
  return std::nullopt;
}

idl::SweepStatus Coordinator::status_of(const storage::Sweep& stored) const {
  idl::SweepStatus status;
  status.set_name(stored.what.name);
  status.set_id(experiment::to_hex(stored.what.id));
  status.set_state(to_text(stored.state));
  status.set_divergences(stored.divergences);
  auto* counts = status.mutable_counts();
  counts->set_jobs(stored.what.jobs);
  counts->set_done(stored.counts.done);
  counts->set_failed(stored.counts.failed);
  counts->set_quarantined(stored.counts.quarantined);
  counts->set_cancelled(stored.counts.cancelled);
  if (const auto open = sweeps_.find(stored.what.id); open != sweeps_.end()) {
    const auto live = progress(open->second);
    status.set_state(live.state);
    counts->set_pending(live.pending);
    counts->set_leased(live.leased);
    status.set_jobs_per_second(live.jobs_per_second);
    if (live.seconds_left >= 0) status.set_seconds_left(live.seconds_left);
  }
  return status;
}

idl::Reply Coordinator::status(const idl::StatusRequest& request) {
  idl::Reply reply;
  auto* status = reply.mutable_status();
  const auto sweeps = store_.sweeps();
  for (const auto& sweep : sweeps) {
    const bool wanted = request.sweep().empty() || sweep.what.name == request.sweep() ||
                        experiment::to_hex(sweep.what.id) == request.sweep();
    if (wanted) *status->add_sweeps() = status_of(sweep);
  }
  if (!request.sweep().empty() && status->sweeps_size() == 0) return unknown_sweep(request.sweep(), sweeps);
  for (const auto& view : ledger_.workers()) {
    auto* worker = status->add_workers();
    worker->set_worker(hex16(view.status->origin.worker));
    worker->set_host(view.status->host);
    worker->set_process(view.status->process);
    worker->set_threads(view.status->threads);
    worker->set_state(state_text(view.status->state));
    worker->set_dds(view.status->dds);
    worker->set_jobs_done(view.status->jobs_done);
    worker->set_leases(static_cast<std::uint32_t>(view.leases));
  }
  status->set_database(database_path_);
  status->set_database_id(experiment::to_hex(store_.database_id()));
  status->set_epoch(store_.epoch());
  return reply;
}

idl::Reply Coordinator::cancel(const idl::CancelRequest& request, Clock::time_point now) {
  const auto stored = find_sweep(request.sweep());
  if (!stored) return unknown_sweep(request.sweep(), store_.sweeps());
  idl::Reply reply;
  const auto open = sweeps_.find(stored->what.id);
  if (open != sweeps_.end() && open->second.stored.state == storage::SweepState::running) {
    staged_since_ = {};
    commit(now);  // what has been computed counts
    if (storage_failed_) return error_reply("storage", "the database has no room; nothing was cancelled");
  }
  // That commit may have ended the sweep.
  if (const auto running = sweeps_.find(stored->what.id);
      running != sweeps_.end() && running->second.stored.state == storage::SweepState::running) {
    OpenSweep& sweep = running->second;
    storage::Batch change;
    change.states.push_back({sweep.stored.row, storage::SweepState::cancelling});
    store_.commit(change);
    sweep.stored.state = storage::SweepState::cancelling;
    auto closed = ledger_.close_sweep(stored->what.id);
    sweep.to_cancel = std::move(closed.open_jobs);
    for (auto& message : closed.revocations) send(message.origin.worker, message);
    publish_specification(sweep, false);
    spdlog::info("sweep {}: cancelling {} jobs", sweep.stored.what.name, sweep.to_cancel.size());
    event("sweep_cancelling", 0, std::to_string(sweep.to_cancel.size()) + " jobs", sweep.stored.row);
    reply.mutable_cancel()->set_cancelled(sweep.to_cancel.size());
    return reply;
  }
  std::uint64_t cancelled = stored->counts.cancelled;
  if (const auto cancelling = sweeps_.find(stored->what.id); cancelling != sweeps_.end()) {
    cancelled = cancelling->second.stored.what.jobs - cancelling->second.stored.counts.ended() +
                cancelling->second.stored.counts.cancelled;
  }
  reply.mutable_cancel()->set_cancelled(cancelled);
  return reply;
}

storage::ResultsReader& Coordinator::reader() {
  if (!reader_) reader_ = std::make_unique<storage::ResultsReader>(store_.path());
  return *reader_;
}

idl::Reply Coordinator::results(const idl::ResultsRequest& request) {
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) return unknown_sweep(request.sweep(), store_.sweeps());
  constexpr std::uint64_t most_rows = 100;
  const std::uint64_t limit = request.limit() == 0 ? most_rows : std::min<std::uint64_t>(request.limit(), most_rows);
  const auto table = reader().results(sweep->what.name, request.first_job(), limit);
  idl::Reply reply;
  auto* results = reply.mutable_results();
  for (const auto& column : table.columns) results->add_columns(column);
  const auto job_column = std::ranges::find(table.columns, "job") - table.columns.begin();
  std::size_t bytes = 0;
  std::uint64_t last_job = 0;
  for (const auto& row : table.rows) {
    for (const auto& value : row) bytes += value.size() + 2;
    if (bytes > reply_bytes && results->rows_size() > 0) break;
    auto* copy = results->add_rows();
    for (const auto& value : row) copy->add_values(value);
    last_job = std::stoull(row.at(static_cast<std::size_t>(job_column)));
  }
  const auto sent = static_cast<std::uint64_t>(results->rows_size());
  if (sent < table.rows.size() || sent == limit) results->set_next_job(last_job + 1);
  return reply;
}

idl::Reply Coordinator::stored_job(const idl::StoredJobRequest& request) {
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) return unknown_sweep(request.sweep(), store_.sweeps());
  const auto job = store_.find_job(sweep->row, request.job());
  if (!job) {
    return error_reply("no_such_job", "job " + std::to_string(request.job()) + " of sweep " + sweep->what.name +
                                          (request.job() < sweep->what.jobs ? " has not ended" : " does not exist"));
  }
  idl::Reply reply;
  auto* stored = reply.mutable_stored_job();
  if (!stored->mutable_specification()->ParseFromString(sweep->what.specification)) {
    return error_reply("storage", "the stored specification of sweep " + sweep->what.name + " is unreadable");
  }
  stored->set_job(request.job());
  stored->set_state(to_text(job->state));
  if (job->digest) stored->set_digest(experiment::to_hex(*job->digest));
  stored->set_science_version(sweep->science_version);
  stored->set_build(build_of(job->worker).value_or(""));
  return reply;
}

}  // namespace lamprey::coordinator
