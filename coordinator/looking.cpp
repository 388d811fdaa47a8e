// What a client wants to see; nothing here changes anything.
#include "coordinator/coordinator.hpp"
#include "coordinator/replies.hpp"
#include "experiment/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

namespace lamprey::coordinator {

namespace {

/// A reply stays below about this; longer tables are paged.
constexpr std::size_t reply_bytes = 48 * 1024;
constexpr std::uint64_t most_result_rows = 100;
constexpr std::size_t most_trace_rows = 1'000;
constexpr std::uint64_t most_events = 200;

std::string hex16(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
  return text.data();
}

std::string state_text(const Ledger::WorkerView& worker) {
  if (worker.refused) return "refused";
  switch (worker.status->state) {
    case messaging::WorkerState::ready:
      return "ready";
    case messaging::WorkerState::draining:
      return "draining";
    case messaging::WorkerState::leaving:
      return "leaving";
  }
  return "unknown";
}

/// The page of the trace that begins with that row.
void add_rows(idl::TraceReply& reply, const std::vector<experiment::AcceptedChange>& trace, std::uint64_t first) {
  for (std::uint64_t i = first; i < trace.size(); ++i) {
    if (reply.rows_size() == static_cast<int>(most_trace_rows)) return reply.set_more(true);
    const auto& change = trace[i];
    auto* row = reply.add_rows();
    row->set_cycle(change.cycle);
    row->set_stability(change.score.stability);
    row->set_distance(change.score.distance);
    row->set_fuel(change.score.fuel);
    row->set_total(change.score.total);
  }
}

}  // namespace

idl::SweepStatus Coordinator::status_of(const storage::Sweep& stored) const {
  idl::SweepStatus status;
  status.set_name(stored.what.name);
  status.set_id(experiment::to_hex(stored.what.id));
  status.set_state(to_text(stored.state));
  status.set_divergences(stored.divergences);
  status.set_archived(stored.archived);
  status.set_reused(stored.reused);
  status.set_audited(stored.audited);
  status.set_reason(stored.reason);
  // What is unreadable is shown as if nothing had been said; `lamprey verify` tells.
  if (!status.mutable_execution()->ParseFromString(stored.what.execution)) status.clear_execution();
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

idl::Reply Coordinator::status(const idl::StatusRequest& request, Clock::time_point now) {
  idl::Reply reply;
  auto* status = reply.mutable_status();
  for (const auto& sweep : journal_.store().sweeps()) {
    const bool wanted = request.sweep().empty() || sweep.what.name == request.sweep() ||
                        experiment::to_hex(sweep.what.id) == request.sweep();
    if (wanted) *status->add_sweeps() = status_of(sweep);
  }
  if (!request.sweep().empty() && status->sweeps_size() == 0) return unknown_sweep(request.sweep());
  for (const auto& view : ledger_.workers()) add_worker(*status, view, now);
  status->set_database(database_path_);
  status->set_database_id(experiment::to_hex(journal_.store().database_id()));
  status->set_epoch(journal_.store().epoch());
  status->set_storage_fault(journal_.fault());
  const auto now_by_calendar = std::chrono::system_clock::now().time_since_epoch();
  status->set_unix_milliseconds(std::chrono::duration_cast<std::chrono::milliseconds>(now_by_calendar).count());
  return reply;
}

void Coordinator::add_worker(idl::StatusReply& status, const Ledger::WorkerView& view, Clock::time_point now) const {
  auto* worker = status.add_workers();
  const auto& said = *view.status;
  worker->set_worker(hex16(said.origin.worker));
  worker->set_host(said.host);
  worker->set_process(said.process);
  worker->set_threads(said.threads);
  worker->set_state(state_text(view));
  worker->set_dds(said.dds);
  worker->set_jobs_done(said.jobs_done);
  worker->set_leases(static_cast<std::uint32_t>(view.leases));
  for (const auto& label : said.labels) worker->add_labels(label);
  worker->set_build(said.build);
  worker->set_processor(said.processor);
  worker->set_instruction_set(said.instruction_set);
  worker->set_results_held(said.results_held);
  worker->set_seconds_since_heard(std::chrono::duration<double>(now - view.heard).count());
  constexpr int most_running = 64;
  for (const auto& job : said.running) {
    if (worker->running_size() == most_running) break;
    auto* running = worker->add_running();
    running->set_sweep(name_of(job.sweep));
    running->set_job(job.job);
    running->set_cycle(job.cycle);
    running->set_seconds(job.seconds);
  }
}

/// Of a sweep that has not ended, or of the one that an audit is about; its id where it is neither.
std::string Coordinator::name_of(const Id128& id) const {
  if (const auto sweep = sweeps_.find(id); sweep != sweeps_.end()) return sweep->second.stored.what.name;
  if (const auto audit = audits_.find(id); audit != audits_.end()) return audit->second.sweep.what.name + " (audit)";
  return experiment::to_hex(id);
}

storage::ResultsReader& Coordinator::reader() {
  if (!reader_) reader_ = std::make_unique<storage::ResultsReader>(journal_.store().path());
  return *reader_;
}

idl::Reply Coordinator::results(const idl::ResultsRequest& request) {
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) return unknown_sweep(request.sweep());
  const std::uint64_t limit =
      request.limit() == 0 ? most_result_rows : std::min<std::uint64_t>(request.limit(), most_result_rows);
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
  if (!sweep) return unknown_sweep(request.sweep());
  const auto job = journal_.store().find_job(sweep->row, request.job());
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

idl::Reply Coordinator::trace(const idl::TraceRequest& request) {
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) return unknown_sweep(request.sweep());
  if (request.job() >= sweep->what.jobs) {
    return error_reply("no_such_job",
                       "job " + std::to_string(request.job()) + " of sweep " + sweep->what.name + " does not exist");
  }
  idl::Reply reply;
  auto* trace = reply.mutable_trace();
  const auto& store = journal_.store();
  if (const auto row = store.read_job(sweep->row, request.job())) {
    trace->set_state(to_text(row->state));
    if (row->outcome) {
      trace->set_cycle(row->outcome->cycles);
      trace->set_cycles(row->outcome->cycles);
      add_rows(*trace, row->outcome->trace, request.first_row());
    }
    return reply;
  }
  trace->set_state(ledger_.is_leased(sweep->what.id, request.job()) ? "leased" : "pending");
  if (const auto open = sweeps_.find(sweep->what.id); open != sweeps_.end() && open->second.grid) {
    trace->set_cycles(static_cast<std::uint64_t>(open->second.grid->job(request.job()).parameters.integer("cycles")));
  }
  if (const auto checkpoint = store.find_checkpoint(sweep->row, request.job())) {
    trace->set_state("running");
    trace->set_cycle(checkpoint->cycle);
    const std::vector<std::uint8_t> state(checkpoint->state.begin(), checkpoint->state.end());
    add_rows(*trace, experiment::read_checkpoint_trace(state), request.first_row());
  }
  return reply;
}

idl::Reply Coordinator::events(const idl::EventsRequest& request) {
  std::optional<std::int64_t> row;
  if (!request.sweep().empty()) {
    const auto sweep = find_sweep(request.sweep());
    if (!sweep) return unknown_sweep(request.sweep());
    row = sweep->row;
  }
  const std::uint64_t limit =
      request.limit() == 0 ? most_events : std::min<std::uint64_t>(request.limit(), most_events);
  std::map<std::int64_t, std::string> names;
  for (const auto& sweep : journal_.store().sweeps()) names.emplace(sweep.row, sweep.what.name);
  idl::Reply reply;
  auto* events = reply.mutable_events();
  for (const auto& stored : journal_.store().events(row, static_cast<std::int64_t>(request.after()), limit)) {
    auto* event = events->add_events();
    event->set_event(static_cast<std::uint64_t>(stored.number));
    event->set_at(stored.unix_milliseconds);
    event->set_kind(stored.event.kind);
    if (stored.event.sweep) event->set_sweep(names[*stored.event.sweep]);
    if (stored.event.job) event->set_job(*stored.event.job);
    if (stored.event.worker != 0) event->set_worker(hex16(stored.event.worker));
    event->set_text(stored.event.text);
    if (reply.ByteSizeLong() > reply_bytes) break;
  }
  return reply;
}

idl::Reply Coordinator::metrics() {
  Gauges gauges;
  gauges.epoch = journal_.store().epoch();
  gauges.malformed_samples = participant_.malformed_samples();
  gauges.log_bytes = journal_.store().log_size().bytes;
  gauges.leases = ledger_.leases();
  for (const auto& [id, sweep] : sweeps_) {
    const auto live = progress(sweep);
    gauges.sweeps.push_back({.name = live.name,
                             .state = live.state,
                             .pending = live.pending,
                             .leased = live.leased,
                             .counts = sweep.stored.counts,
                             .divergences = live.divergences});
  }
  for (const auto& view : ledger_.workers()) {
    ++gauges.workers[state_text(view)];
    for (const auto& counter : view.status->counters) gauges.worker_totals[counter.name] += counter.value;
  }
  idl::Reply reply;
  reply.mutable_metrics()->set_text(metrics_page(counters_, journal_, gauges));
  return reply;
}

}  // namespace lamprey::coordinator
