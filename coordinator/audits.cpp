// Done jobs, computed again by other workers. To the ledger, and to workers, an audit is a sweep of its own: with the
// same specification, the audit's id and only the jobs that are to be compared.
#include "coordinator/audit.hpp"
#include "coordinator/coordinator.hpp"
#include "coordinator/replies.hpp"

#include <cmath>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::coordinator {

namespace {

std::optional<storage::Sweep> sweep_of(const storage::ResultsStore& store, std::int64_t row) {
  for (auto& sweep : store.sweeps()) {
    if (sweep.row == row) return std::move(sweep);
  }
  return std::nullopt;
}

std::shared_ptr<const experiment::SweepGrid> grid_of(const storage::Sweep& sweep) {
  idl::SweepSpecification specification;
  if (!specification.ParseFromString(sweep.what.specification)) return nullptr;
  try {
    return std::make_shared<const experiment::SweepGrid>(specification);
  } catch (const experiment::InvalidInput&) {
    return nullptr;
  }
}

}  // namespace

void Coordinator::open_audit(const storage::Audit& stored) {
  const auto& store = journal_.store();
  auto sweep = sweep_of(store, stored.sweep);
  const auto grid = sweep ? grid_of(*sweep) : nullptr;
  if (grid == nullptr) return;
  auto jobs = audit_sample(*grid, store.done_jobs(stored.sweep), stored.share, stored.seed);
  jobs.remove(store.audited_jobs(stored.row));
  ledger_.add_audit(stored.id, by_author(store, stored.sweep, jobs));
  publish_specification(*sweep, stored.id, true);
  audits_.insert_or_assign(stored.id, OpenAudit{stored, std::move(*sweep), grid});
}

void Coordinator::take_audit_result(OpenAudit& audit, const messaging::Origin& origin,
                                    const messaging::JobResult& result, Clock::time_point now) {
  const Id128& id = audit.stored.id;
  messaging::Acknowledgement answer{id, result.job, result.digest, messaging::Verdict::duplicate, {}};
  if (!ledger_.is_open(id, result.job)) {
    answers_.push_back({origin.worker, std::move(answer), result.lease, -1});
    return;
  }
  OpenSweep sweep;
  sweep.stored = audit.sweep;
  sweep.grid = audit.grid;
  const auto judgement = judge(sweep, origin, result);
  if (!judgement.row) return refuse(origin, id, result, judgement.refusal, now);
  if (!judgement.row->digest) return refuse(origin, id, result, "the job is done and cannot fail", now);
  const auto stored = journal_.store().find_job(audit.sweep.row, result.job);
  if (!stored || !stored->digest) return refuse(origin, id, result, "the job has no outcome to compare with", now);
  const bool agreed = *stored->digest == result.digest;
  if (!agreed) answer_divergence(audit.sweep.what.name, audit.sweep.row, *stored->digest, origin, result, answer);
  end_audited_job(audit, result.job, origin.worker, result.digest, agreed);
  answers_.push_back({origin.worker, std::move(answer), result.lease, -1});
}

void Coordinator::end_audited_job(OpenAudit& audit, std::uint64_t job, std::uint64_t worker,
                                  const experiment::Digest& digest, bool agreed) {
  journal_.batch().audited.push_back(
      {.audit = audit.stored.row, .job = job, .worker = worker, .digest = digest, .agreed = agreed});
  ++(agreed ? audit.stored.agreed : audit.stored.diverged);
  ++counters_.jobs_audited;
  ledger_.ended(audit.stored.id, job, 0, -1);
}

/// After a commit: what an audit counts is durable then.
void Coordinator::close_ended_audits() {
  for (auto it = audits_.begin(); it != audits_.end();) {
    const auto& audit = it->second;
    if (!audit.stored.finished()) {
      ++it;
      continue;
    }
    revoke(ledger_.close_sweep(it->first).revocations);
    publish_specification(audit.sweep, it->first, false);
    spdlog::log(audit.stored.diverged > 0 ? spdlog::level::err : spdlog::level::info,
                "audit of sweep {}: {} jobs agree, {} do not", audit.sweep.what.name, audit.stored.agreed,
                audit.stored.diverged);
    journal_.event("audit_finished", 0,
                   std::to_string(audit.stored.agreed) + " agree, " + std::to_string(audit.stored.diverged) + " do not",
                   audit.sweep.row);
    it = audits_.erase(it);
  }
}

idl::Reply Coordinator::audit(const idl::AuditRequest& request) {
  if (!std::isfinite(request.share()) || request.share() <= 0 || request.share() > 1) {
    return error_reply("not_possible", "an audit's share is above 0 and at most 1");
  }
  const auto sweep = find_sweep(request.sweep());
  if (!sweep) return unknown_sweep(request.sweep());
  if (sweep->state != storage::SweepState::finished && sweep->state != storage::SweepState::cancelled) {
    return error_reply("not_possible", "sweep " + sweep->what.name + " is " + to_text(sweep->state) +
                                           "; it can be audited when it has ended");
  }
  auto& store = journal_.store();
  storage::Audit audit;
  audit.id = audit_id(sweep->what.id, request.share(), request.seed());
  audit.sweep = sweep->row;
  audit.share = request.share();
  audit.seed = request.seed();
  if (audits_.contains(audit.id)) return audit_reply(status_of(audits_.at(audit.id).stored));
  const auto grid = grid_of(*sweep);
  if (grid == nullptr)
    return error_reply("storage", "the stored specification of sweep " + sweep->what.name + " is unreadable");
  audit.jobs = audit_sample(*grid, store.done_jobs(sweep->row), audit.share, audit.seed).size();
  if (audit.jobs == 0) {
    return error_reply("not_possible",
                       "that share of sweep " + sweep->what.name + " has no job that is done and repeats bit by bit");
  }
  const auto stored = store.add_audit(audit);
  if (!stored.finished()) {
    open_audit(stored);
    spdlog::info("audit of sweep {}: {} jobs are computed again", sweep->what.name, stored.jobs);
  }
  return audit_reply(status_of(stored));
}

idl::Reply Coordinator::audit_status(const idl::AuditStatusRequest& request) {
  const auto id = experiment::id128_from_hex(request.audit());
  if (id) {
    if (const auto open = audits_.find(*id); open != audits_.end()) return audit_reply(status_of(open->second.stored));
    for (const auto& stored : journal_.store().audits()) {
      if (stored.id == *id) return audit_reply(status_of(stored));
    }
  }
  return error_reply("unknown_audit", "no audit '" + experiment::printable(request.audit()) + "' in this database");
}

idl::AuditStatus Coordinator::status_of(const storage::Audit& audit) const {
  idl::AuditStatus status;
  status.set_audit(experiment::to_hex(audit.id));
  if (const auto sweep = sweep_of(journal_.store(), audit.sweep)) status.set_sweep(sweep->what.name);
  status.set_state(audit.finished() && !audits_.contains(audit.id) ? "finished" : "running");
  status.set_jobs(audit.jobs);
  status.set_agreed(audit.agreed);
  status.set_diverged(audit.diverged);
  status.set_waiting_for_another_worker(ledger_.waiting_for_another_worker(audit.id));
  return status;
}

}  // namespace lamprey::coordinator
