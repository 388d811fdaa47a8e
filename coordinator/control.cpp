// What a person wishes. Each wish is durable before it is answered, and the same wish twice is the same as once.
#include "coordinator/coordinator.hpp"
#include "coordinator/replies.hpp"
#include "experiment/execution_validation.hpp"
#include "experiment/sweep_validation.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::coordinator {

namespace {

using State = storage::SweepState;

std::string hex16(std::uint64_t value) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value));
  return text.data();
}

idl::Reply not_possible(const storage::Sweep& sweep, const std::string& wish) {
  return error_reply("not_possible",
                     "sweep " + sweep.what.name + " is " + to_text(sweep.state) + "; it cannot be " + wish);
}

storage::Batch change_of_state(const storage::Sweep& sweep, State state, std::string kind, const std::string& text,
                               const std::string& reason = {}) {
  storage::Batch change;
  change.states.push_back({sweep.row, state, reason});
  change.events.push_back({std::move(kind), sweep.row, std::nullopt, 0, text});
  return change;
}

}  // namespace

/// What has been computed counts, before a wish changes anything. False if nothing can be stored now.
bool Coordinator::commit_now(Clock::time_point now) {
  if (!journal_.healthy()) return false;
  journal_.hurry();
  commit(now);
  return journal_.healthy();
}

idl::Reply Coordinator::control_reply(const Id128& id, std::uint64_t jobs) const {
  idl::Reply reply;
  auto* control = reply.mutable_control();
  control->set_jobs(jobs);
  const auto sweep = find_sweep(experiment::to_hex(id));
  control->set_state(sweep ? to_text(sweep->state) : "deleted");
  return reply;
}

idl::Reply Coordinator::cancel(const idl::CancelRequest& request, Clock::time_point now) {
  if (!commit_now(now)) return error_reply("storage", journal_.fault() + "; nothing was cancelled");
  const auto stored = find_sweep(request.sweep());
  if (!stored) return unknown_sweep(request.sweep());
  const auto open = sweeps_.find(stored->what.id);
  if (stored->state == State::running || stored->state == State::paused) begin_cancelling(open->second, {});
  idl::Reply reply;
  std::uint64_t cancelled = stored->counts.cancelled;
  if (open != sweeps_.end()) cancelled = stored->what.jobs - stored->counts.ended() + stored->counts.cancelled;
  reply.mutable_cancel()->set_cancelled(cancelled);
  return reply;
}

/// `reason`: why it ends early; empty if a person wishes it. Everything staged has been committed.
void Coordinator::begin_cancelling(OpenSweep& sweep, const std::string& reason) {
  const Id128 id = sweep.stored.what.id;
  const std::uint64_t jobs = sweep.stored.what.jobs - sweep.stored.counts.ended();
  const std::string text = std::to_string(jobs) + " jobs" + (reason.empty() ? "" : ": " + reason);
  journal_.store().commit(change_of_state(sweep.stored, State::cancelling,
                                          reason.empty() ? "sweep_cancelling" : "sweep_stopped", text, reason));
  sweep.stored.state = State::cancelling;
  sweep.stored.reason = reason;
  auto closed = ledger_.close_sweep(id);
  sweep.to_cancel = std::move(closed.open_jobs);
  if (sweep.reuse) sweep.to_cancel.add(sweep.reuse->open_jobs());
  sweep.reuse.reset();
  revoke(std::move(closed.revocations));
  publish_specification(sweep.stored, id, false);
  spdlog::info("sweep {}: cancelling {}", sweep.stored.what.name, text);
}

idl::Reply Coordinator::control(const idl::ControlRequest& request, Clock::time_point now) {
  if (!commit_now(now)) return error_reply("storage", journal_.fault() + "; nothing was changed");
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) {
    // Deleting twice is as good as once; but whoever mistypes a name should learn it.
    return unknown_sweep(request.sweep());
  }
  switch (request.action()) {
    case idl::ControlRequest::PAUSE:
      return pause(*sweep);
    case idl::ControlRequest::RESUME:
      return resume(*sweep, request);
    case idl::ControlRequest::RETRY:
      return retry(*sweep, request.cancelled_too(), now);
    case idl::ControlRequest::ARCHIVE:
      return archive(*sweep, true);
    case idl::ControlRequest::UNARCHIVE:
      return archive(*sweep, false);
    case idl::ControlRequest::DELETE:
      return remove(*sweep);
    default:
      return error_reply("malformed", "the request wishes nothing that this coordinator knows");
  }
}

idl::Reply Coordinator::pause(const storage::Sweep& sweep) {
  const Id128& id = sweep.what.id;
  if (sweep.state == State::paused) return control_reply(id, ledger_.pending(id));
  if (sweep.state != State::running) return not_possible(sweep, "paused");
  journal_.store().commit(change_of_state(sweep, State::paused, "sweep_paused", sweep.what.name));
  sweeps_.at(id).stored.state = State::paused;
  revoke(ledger_.pause(id));
  spdlog::info("sweep {}: paused", sweep.what.name);
  return control_reply(id, ledger_.pending(id));
}

idl::Reply Coordinator::resume(const storage::Sweep& sweep, const idl::ControlRequest& request) {
  const Id128& id = sweep.what.id;
  if (request.has_specification()) {
    if (!experiment::validate(request.specification()).empty()) {
      return error_reply("invalid_specification", "the given specification is not valid");
    }
    if (experiment::sweep_id(request.specification()) != id) return changed(sweep, request.specification());
  }
  if (sweep.state == State::running) return control_reply(id, ledger_.pending(id));
  if (sweep.state != State::paused) return not_possible(sweep, "resumed");
  journal_.store().commit(change_of_state(sweep, State::running, "sweep_resumed", sweep.what.name));
  sweeps_.at(id).stored.state = State::running;
  ledger_.resume(id);
  publish_specification(sweep, id, true);
  spdlog::info("sweep {}: goes on", sweep.what.name);
  return control_reply(id, ledger_.pending(id));
}

idl::Reply Coordinator::retry(const storage::Sweep& sweep, bool cancelled_too, Clock::time_point now) {
  const Id128& id = sweep.what.id;
  const auto jobs = journal_.store().retry(sweep.row, cancelled_too);
  if (jobs.empty()) return control_reply(id, 0);
  counters_.jobs_retried += jobs.size();
  spdlog::info("sweep {}: {} jobs are tried again", sweep.what.name, jobs.size());
  const auto stored = find_sweep(experiment::to_hex(id));
  if (const auto open_sweep = sweeps_.find(id); open_sweep != sweeps_.end()) {
    open_sweep->second.stored = *stored;
    ledger_.add_jobs(id, jobs);
  } else {
    open(*stored);
    sweeps_.at(id).rate.note(now, stored->counts.ended());
  }
  return control_reply(id, jobs.size());
}

idl::Reply Coordinator::archive(const storage::Sweep& sweep, bool archived) {
  if (archived && sweeps_.contains(sweep.what.id)) return not_possible(sweep, "archived before it has ended");
  if (sweep.archived != archived) journal_.store().set_archived(sweep.row, archived);
  return control_reply(sweep.what.id, sweep.what.jobs);
}

idl::Reply Coordinator::remove(const storage::Sweep& sweep) {
  const Id128& id = sweep.what.id;
  if (sweep.state == State::deleting) return control_reply(id, sweep.counts.ended());
  if (sweep.state != State::finished && sweep.state != State::cancelled) {
    return not_possible(sweep, "deleted; cancel it first");
  }
  storage::Sweep deleting = sweep;
  deleting.state = State::deleting;
  journal_.store().commit(change_of_state(sweep, State::deleting, "sweep_deleting",
                                          sweep.what.name + ": " + std::to_string(sweep.counts.ended()) + " jobs"));
  for (auto it = audits_.begin(); it != audits_.end();) {
    if (it->second.sweep.row != sweep.row) {
      ++it;
      continue;
    }
    revoke(ledger_.close_sweep(it->first).revocations);
    it = audits_.erase(it);
  }
  open(deleting);
  spdlog::info("sweep {}: deleting {} jobs", sweep.what.name, sweep.counts.ended());
  return control_reply(id, sweep.counts.ended());
}

idl::Reply Coordinator::rename(const idl::RenameRequest& request) {
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) {
    // The same wish again: its answer was lost.
    const auto renamed = find_sweep(request.name());
    return renamed ? control_reply(renamed->what.id, renamed->what.jobs) : unknown_sweep(request.sweep());
  }
  if (auto fault = experiment::sweep_name_fault(request.name())) return error_reply("not_possible", *fault);
  if (sweep->what.name != request.name()) {
    journal_.store().rename(sweep->row, request.name());
    if (const auto open_sweep = sweeps_.find(sweep->what.id); open_sweep != sweeps_.end()) {
      open_sweep->second.stored.what.name = request.name();
    }
    for (auto& [id, audit] : audits_) {
      if (audit.sweep.row == sweep->row) audit.sweep.what.name = request.name();
    }
    spdlog::info("sweep {} is called {} now", sweep->what.name, request.name());
  }
  return control_reply(sweep->what.id, sweep->what.jobs);
}

idl::Reply Coordinator::adjust(const idl::AdjustRequest& request) {
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) return unknown_sweep(request.sweep());
  idl::Execution execution;
  if (!execution.ParseFromString(sweep->what.execution)) {
    return error_reply("storage", "how sweep " + sweep->what.name + " is run is stored unreadably");
  }
  if (request.has_priority()) execution.set_priority(request.priority());
  if (request.has_max_concurrent()) execution.set_max_concurrent(request.max_concurrent());
  if (const auto problems = experiment::validate(execution); !problems.empty()) {
    return error_reply("not_possible", problems.front().message);
  }
  const std::string bytes = execution.SerializeAsString();
  if (bytes != sweep->what.execution) {
    journal_.store().set_execution(sweep->row, bytes);
    if (const auto open_sweep = sweeps_.find(sweep->what.id); open_sweep != sweeps_.end()) {
      open_sweep->second.execution = execution;
      open_sweep->second.stored.what.execution = bytes;
      ledger_.set_policy(sweep->what.id, policy_of(execution, *open_sweep->second.grid));
    }
    spdlog::info("sweep {}: priority {}, at most {} jobs at once (0: any number)", sweep->what.name,
                 execution.priority(), execution.max_concurrent());
  }
  return control_reply(sweep->what.id, sweep->what.jobs);
}

idl::Reply Coordinator::drain(const idl::DrainRequest& request, Clock::time_point now) {
  // A worker that has just joined needs its row first.
  if (!commit_now(now)) return error_reply("storage", journal_.fault() + "; nothing was changed");
  std::vector<std::string> names;
  idl::Reply reply;
  for (const auto& view : ledger_.workers()) {
    const auto& status = *view.status;
    const std::uint64_t worker = status.origin.worker;
    const std::array<std::string, 3> called = {hex16(worker), status.host,
                                               status.host + "/" + std::to_string(status.process)};
    names.insert(names.end(), called.begin(), called.end());
    if (std::ranges::find(called, request.worker()) == called.end()) continue;
    journal_.store().set_draining(worker, true);
    if (auto message = ledger_.drain(worker)) send(worker, std::move(*message));
    spdlog::info("worker {} is drained: it finishes what it holds and leaves", called[2]);
    reply.mutable_drain()->add_workers(called[0]);
  }
  if (reply.has_drain()) return reply;
  std::string message = "no worker '" + experiment::printable(request.worker()) + "' is here";
  const std::vector<std::string_view> views(names.begin(), names.end());
  if (const auto nearest = experiment::nearest_name(request.worker(), views); !nearest.empty()) {
    message += "; did you mean '" + nearest + "'?";
  }
  return error_reply("unknown_worker", message);
}

}  // namespace lamprey::coordinator
