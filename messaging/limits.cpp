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

  std::optional<std::string> violation() && { return std::move(violation_); }

 private:
  void size(std::string_view field, std::size_t size, std::size_t most) {
    if (size <= most || violation_) return;
    violation_ = std::string(field) + ": size " + std::to_string(size) + ", at most " + std::to_string(most);
  }

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
  check.text("dds", sample.dds);
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
  }
  return std::move(check).violation();
}

std::optional<std::string> limit_violation(const ResultAcknowledgement& sample) {
  Check check;
  check.elements("results", sample.results.size());
  for (const auto& result : sample.results) check.text("results.reason", result.reason);
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

}  // namespace lamprey::messaging
