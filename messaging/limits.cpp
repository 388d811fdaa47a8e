#include "messaging/limits.hpp"

#include <string_view>
#include <utility>

namespace lamprey::messaging {
namespace {

/// Collects the first violation.
class Check {
 public:
  void text(std::string_view field, std::string_view value) { size(field, value.size(), maximum_text_bytes); }
  void elements(std::string_view field, std::size_t count) { size(field, count, maximum_elements); }
  void payload(std::string_view field, std::size_t bytes) { size(field, bytes, maximum_payload_bytes); }

  void size(std::string_view field, std::size_t size, std::size_t most) {
    if (size <= most || violation_) return;
    violation_ = std::string(field) + ": size " + std::to_string(size) + ", at most " + std::to_string(most);
  }

  std::optional<std::string> violation() && { return std::move(violation_); }

 private:
  std::optional<std::string> violation_;
};

}  // namespace

std::optional<std::string> limit_violation(const WorkerStatus& sample) {
  Check check;
  check.elements("leases", sample.leases.size());
  for (const auto& lease : sample.leases) check.elements("leases.remaining", lease.remaining.size());
  check.elements("running", sample.running.size());
  check.text("host", sample.host);
  check.text("build", sample.build);
  check.text("flags", sample.flags);
  check.text("processor", sample.processor);
  check.text("instruction_set", sample.instruction_set);
  check.text("dds", sample.dds);
  check.size("labels", sample.labels.size(), maximum_labels);
  for (const auto& label : sample.labels) check.text("labels", label);
  check.size("counters", sample.counters.size(), maximum_counters);
  for (const auto& counter : sample.counters) check.text("counters.name", counter.name);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const SweepSpecification& sample) {
  Check check;
  check.text("name", sample.name);
  check.payload("specification", sample.specification.size());
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const Lease& sample) {
  Check check;
  check.elements("ranges", sample.ranges.size());
  check.payload("checkpoint", sample.checkpoint.size());
  check.text("reason", sample.reason);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const ResultBatch& sample) {
  Check check;
  check.elements("results", sample.results.size());
  for (const auto& result : sample.results) {
    check.elements("results.outcome.trace", result.outcome.trace.size());
    check.elements("results.outcome.measures", result.outcome.measures.size());
    for (const auto& measure : result.outcome.measures) check.text("results.outcome.measures.name", measure.name);
    check.text("results.reason", result.reason);
    check.payload("results.recording", result.recording.size());
  }
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const ResultAcknowledgement& sample) {
  Check check;
  check.elements("results", sample.results.size());
  for (const auto& result : sample.results) check.text("results.reason", result.reason);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const Checkpoint& sample) {
  Check check;
  check.payload("state", sample.state.size());
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const Request& sample) {
  Check check;
  check.payload("payload", sample.payload.size());
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const Reply& sample) {
  Check check;
  check.payload("payload", sample.payload.size());
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const SweepProgress& sample) {
  Check check;
  check.text("name", sample.name);
  check.text("state", sample.state);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const Traffic& sample) {
  Check check;
  check.size("topics", sample.topics.size(), maximum_counters);
  for (const auto& topic : sample.topics) check.text("topics.topic", topic.topic);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const RobotStatus& sample) {
  Check check;
  check.text("name", sample.name);
  check.text("reason", sample.reason);
  check.text("driver", sample.driver);
  check.text("device", sample.device);
  check.text("scheduling", sample.scheduling);
  check.text("host", sample.host);
  check.text("build", sample.build);
  check.text("dds", sample.dds);
  check.size("counters", sample.counters.size(), maximum_counters);
  for (const auto& counter : sample.counters) check.text("counters.name", counter.name);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const RobotRequest& sample) {
  Check check;
  check.text("reason", sample.reason);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const RobotReply& sample) {
  Check check;
  check.text("reason", sample.reason);
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const ServoCommand& /*sample*/) {
  return std::nullopt;
}

std::optional<std::string> limit_violation(const ServoState& sample) {
  Check check;
  check.text("reason", sample.reason);
  return std::move(check).violation();
}

}  // namespace lamprey::messaging
