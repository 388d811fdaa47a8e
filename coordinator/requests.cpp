// What a client asks. Every request may come twice (the client repeats it until it is answered), so each is idempotent.
#include "coordinator/coordinator.hpp"
#include "coordinator/replies.hpp"
#include "experiment/specification_difference.hpp"

#include <algorithm>
#include <exception>
#include <spdlog/spdlog.h>
#include <string_view>
#include <utility>

namespace lamprey::coordinator {

namespace {

constexpr std::size_t most_problems_in_reply = 50;

/// Of one step, so that heartbeats and results are heard however many clients ask.
constexpr std::size_t requests_per_step = 64;

std::string code_of(storage::StorageError::Kind kind) {
  switch (kind) {
    case storage::StorageError::Kind::name_taken:
      return "name_taken";
    case storage::StorageError::Kind::not_possible:
      return "not_possible";
    default:
      return "storage";
  }
}

std::string kind_of(const idl::Request& request) {
  const auto* kind = idl::Request::descriptor()->FindOneofByName("kind");
  const auto* field = request.GetReflection()->GetOneofFieldDescriptor(request, kind);
  return field == nullptr ? "unknown" : field->name();
}

}  // namespace

void Coordinator::take_requests(Clock::time_point now) {
  for (const auto& sample : requests_->take(requests_per_step)) {
    // A client that names a database means its coordinator only.
    const bool for_another =
        sample.origin.database != Id128{} && sample.origin.database != journal_.store().database_id();
    if (sample.client == 0 || for_another) continue;
    messaging::Reply reply;
    reply.origin = origin();
    reply.client = sample.client;
    reply.correlation = sample.correlation;
    const std::string bytes = answer(sample, now).SerializeAsString();
    reply.payload.assign(bytes.begin(), bytes.end());
    replies_.write(sample.client, reply);
  }
}

idl::Reply Coordinator::answer(const messaging::Request& sample, Clock::time_point now) {
  idl::Request request;
  if (!request.ParseFromArray(sample.payload.data(), static_cast<int>(sample.payload.size()))) {
    ++counters_.requests["malformed"];
    return error_reply("malformed", "the request cannot be read; is the client of another version?");
  }
  ++counters_.requests[kind_of(request)];
  try {
    return handle(request, now);
  } catch (const storage::StorageError& error) {
    const auto code = code_of(error.kind());
    spdlog::log(code == "storage" ? spdlog::level::err : spdlog::level::info, "a client's request is refused: {}",
                error.what());
    return error_reply(code, error.what());
  } catch (const std::exception& error) {
    spdlog::error("a client's request failed: {}", error.what());
    return error_reply("internal", error.what());
  }
}

idl::Reply Coordinator::handle(const idl::Request& request, Clock::time_point now) {
  switch (request.kind_case()) {
    case idl::Request::kSubmit:
      return submit(request.submit(), now);
    case idl::Request::kStatus:
      return status(request.status(), now);
    case idl::Request::kCancel:
      return cancel(request.cancel(), now);
    case idl::Request::kResults:
      return results(request.results());
    case idl::Request::kStoredJob:
      return stored_job(request.stored_job());
    case idl::Request::kControl:
      return control(request.control(), now);
    case idl::Request::kRename:
      return rename(request.rename());
    case idl::Request::kAdjust:
      return adjust(request.adjust());
    case idl::Request::kDrain:
      return drain(request.drain(), now);
    case idl::Request::kAudit:
      return audit(request.audit());
    case idl::Request::kAuditStatus:
      return audit_status(request.audit_status());
    case idl::Request::kMetrics:
      return metrics();
    case idl::Request::kTrace:
      return trace(request.trace());
    case idl::Request::kEvents:
      return events(request.events());
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
  sweep.execution = specification.execution().SerializeAsString();
  sweep.fresh = request.fresh();
  if (const auto other = find_sweep(sweep.name); other && other->what.id != sweep.id) {
    return changed(*other, specification);
  }
  if (const auto open_sweep = sweeps_.find(sweep.id);
      open_sweep != sweeps_.end() && open_sweep->second.stored.state == storage::SweepState::deleting) {
    return error_reply("not_possible", "sweep " + sweep.name + " is being deleted; submit it when it is gone");
  }
  const auto added = journal_.store().add_sweep(sweep);
  if (!added.existed) {
    open(added.sweep);
    sweeps_.at(sweep.id).rate.note(now, 0);
    spdlog::info("sweep {}: {} jobs submitted", sweep.name, sweep.jobs);
  }
  idl::Reply reply;
  reply.mutable_submit()->set_id(experiment::to_hex(sweep.id));
  reply.mutable_submit()->set_jobs(sweep.jobs);
  reply.mutable_submit()->set_existed(added.existed);
  return reply;
}

/// Another sweep has the name: says in what they differ.
idl::Reply Coordinator::changed(const storage::Sweep& stored, const idl::SweepSpecification& given) const {
  idl::SweepSpecification specification;
  if (!specification.ParseFromString(stored.what.specification)) {
    return error_reply("storage", "the stored specification of sweep " + stored.what.name + " is unreadable");
  }
  idl::Reply reply;
  auto* error = reply.mutable_error();
  error->set_code("sweep_changed");
  for (auto& line : experiment::differences(specification, given)) {
    if (error->messages_size() == static_cast<int>(most_problems_in_reply)) break;
    error->add_messages(std::move(line));
  }
  return reply;
}

std::optional<storage::Sweep> Coordinator::find_sweep(const std::string& name_or_id) const {
  for (auto& sweep : journal_.store().sweeps()) {
    if (sweep.what.name == name_or_id || experiment::to_hex(sweep.what.id) == name_or_id) return std::move(sweep);
  }
  return std::nullopt;
}

idl::Reply Coordinator::unknown_sweep(const std::string& wanted) const {
  const auto sweeps = journal_.store().sweeps();
  std::vector<std::string_view> names;
  for (const auto& sweep : sweeps) names.emplace_back(sweep.what.name);
  std::string message = "no sweep '" + experiment::printable(wanted) + "' in this database";
  if (const auto nearest = experiment::nearest_name(wanted, names); !nearest.empty()) {
    message += "; did you mean '" + nearest + "'?";
  }
  return error_reply("unknown_sweep", message);
}

}  // namespace lamprey::coordinator
