#include "client/sweep_summary.hpp"

#include "client/output/formatting.hpp"

namespace lamprey::client {

Json counts_json(const messaging::SweepProgress& progress) {
  return {{"jobs", progress.jobs},          {"pending", progress.pending}, {"leased", progress.leased},
          {"done", progress.done},          {"failed", progress.failed},   {"quarantined", progress.quarantined},
          {"cancelled", progress.cancelled}};
}

void add_sweep(Json& document, const messaging::SweepProgress& progress) {
  document["sweep"] = progress.name;
  document["id"] = experiment::to_hex(progress.sweep);
  document["state"] = progress.state;
  document["counts"] = counts_json(progress);
  document["divergences"] = progress.divergences;
}

std::string counts_text(const messaging::SweepProgress& progress) {
  std::string text =
      output::counted(progress.jobs, "job", "jobs") + ": " + output::with_thousands(progress.done) + " done";
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) text += ", " + output::with_thousands(count) + " " + what;
  };
  add(progress.failed, "failed");
  add(progress.quarantined, "quarantined");
  add(progress.cancelled, "cancelled");
  add(progress.leased, "leased");
  add(progress.pending, "pending");
  return text;
}

ExitCode exit_code_of(const messaging::SweepProgress& progress) {
  if (progress.divergences > 0) return exit_mismatch;
  return progress.failed + progress.quarantined + progress.cancelled > 0 ? exit_jobs_failed : exit_ok;
}

}  // namespace lamprey::client
