#include "coordinator/metrics.hpp"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

namespace lamprey::coordinator {

namespace {

/// A page that is filled and written once.
class Page {
 public:
  void counter(const std::string& name, const std::string& help, double value, const prometheus::Labels& labels = {}) {
    prometheus::BuildCounter()
        .Name("lamprey_" + name + "_total")
        .Help(help)
        .Register(registry_)
        .Add(labels)
        .Increment(value);
  }
  void gauge(const std::string& name, const std::string& help, double value, const prometheus::Labels& labels = {}) {
    prometheus::BuildGauge().Name("lamprey_" + name).Help(help).Register(registry_).Add(labels).Set(value);
  }
  template <class Values>
  void counters(const std::string& name, const std::string& help, const std::string& label, const Values& values) {
    for (const auto& [key, value] : values) counter(name, help, static_cast<double>(value), {{label, key}});
  }

  std::string text() const { return prometheus::TextSerializer().Serialize(registry_.Collect()); }

 private:
  prometheus::Registry registry_{prometheus::Registry::InsertBehavior::Merge};
};

void add_workers(Page& page, const Counters& counters, const Gauges& gauges) {
  const auto event = [&](const char* kind, std::uint64_t value) {
    page.counter("worker_events", "Workers that joined, left, fell silent or were refused", static_cast<double>(value),
                 {{"event", kind}});
  };
  event("joined", counters.workers_joined);
  event("left", counters.workers_left);
  event("lost", counters.workers_lost);
  event("refused", counters.workers_refused);
  page.counter("statuses_refused", "Heartbeats that no worker of ours sends",
               static_cast<double>(counters.statuses_refused));
  for (const auto& [state, count] : gauges.workers) {
    page.gauge("workers", "Workers that are here", static_cast<double>(count), {{"state", state}});
  }
  page.counters("worker_reports", "What the present workers have counted since they started", "counter",
                gauges.worker_totals);
}

void add_leases(Page& page, const Counters& counters, const Gauges& gauges) {
  const auto event = [&](const char* kind, std::uint64_t value) {
    page.counter("lease_events", "Leases granted, sent again, adopted after a restart or a cut, revoked, lost",
                 static_cast<double>(value), {{"event", kind}});
  };
  event("granted", counters.leases_granted);
  event("repeated", counters.leases_repeated);
  event("adopted", counters.leases_adopted);
  event("revoked", counters.leases_revoked);
  event("lost", counters.leases_lost);
  page.gauge("leases", "Leases that workers hold", static_cast<double>(gauges.leases));
}

void add_results(Page& page, const Counters& counters, const Gauges& gauges) {
  const auto verdict = [&](const char* kind, std::uint64_t value) {
    page.counter("results", "Results by the answer that they got", static_cast<double>(value), {{"verdict", kind}});
  };
  verdict("committed", counters.results_committed);
  verdict("duplicate", counters.results_duplicate);
  verdict("divergent", counters.results_divergent);
  verdict("ignored", counters.results_ignored);
  page.counters("results_refused", "Results refused, by reason", "reason", counters.results_refused);
  page.counter("outcomes_reused", "Outcomes that the database had already",
               static_cast<double>(counters.outcomes_reused));
  page.counter("jobs_quarantined", "Jobs given up", static_cast<double>(counters.jobs_quarantined));
  page.counter("jobs_retried", "Jobs that were tried again by somebody's wish",
               static_cast<double>(counters.jobs_retried));
  page.counter("jobs_audited", "Jobs computed again to compare", static_cast<double>(counters.jobs_audited));
  page.counter("checkpoints", "Checkpoints of long jobs", static_cast<double>(counters.checkpoints_stored),
               {{"verdict", "stored"}});
  page.counter("checkpoints", "Checkpoints of long jobs", static_cast<double>(counters.checkpoints_refused),
               {{"verdict", "refused"}});
  page.counter("samples_malformed", "DDS samples dropped because no program of ours writes such",
               static_cast<double>(gauges.malformed_samples));
  page.counters("requests", "Requests of clients, by kind", "kind", counters.requests);
}

void add_storage(Page& page, const Journal& journal, const Gauges& gauges) {
  const auto& counters = journal.counters();
  page.counter("commits", "Transactions that made results durable", static_cast<double>(counters.commits));
  page.counter("commit_seconds", "Time that they took", counters.seconds);
  page.gauge("commit_longest_seconds", "The longest of them", counters.longest_seconds);
  page.counter("storage_faults", "Times that the database failed", static_cast<double>(counters.faults));
  page.counter("events_dropped", "Events that had no room while nothing could be stored",
               static_cast<double>(counters.dropped_events));
  page.counter("recordings_dropped", "Robots' recordings that came with results and could not be kept",
               static_cast<double>(counters.dropped_recordings));
  page.gauge("storage_healthy", "Whether the database can be written", journal.healthy() ? 1 : 0);
  page.gauge("log_bytes", "Size of the write-ahead log", static_cast<double>(gauges.log_bytes));
  page.gauge("epoch", "How often a coordinator has opened the database", static_cast<double>(gauges.epoch));
}

void add_sweeps(Page& page, const Gauges& gauges) {
  for (const auto& sweep : gauges.sweeps) {
    const auto jobs = [&](const char* state, std::uint64_t value) {
      page.gauge("jobs", "Jobs of sweeps that have not ended", static_cast<double>(value),
                 {{"sweep", sweep.name}, {"state", state}});
    };
    jobs("pending", sweep.pending);
    jobs("leased", sweep.leased);
    jobs("done", sweep.counts.done);
    jobs("failed", sweep.counts.failed);
    jobs("quarantined", sweep.counts.quarantined);
    jobs("cancelled", sweep.counts.cancelled);
    page.gauge("sweep", "Sweeps that have not ended", 1, {{"sweep", sweep.name}, {"state", sweep.state}});
    page.gauge("divergences", "Results that contradict a stored one", static_cast<double>(sweep.divergences),
               {{"sweep", sweep.name}});
  }
}

}  // namespace

std::string metrics_page(const Counters& counters, const Journal& journal, const Gauges& gauges) {
  Page page;
  add_sweeps(page, gauges);
  add_workers(page, counters, gauges);
  add_leases(page, counters, gauges);
  add_results(page, counters, gauges);
  add_storage(page, journal, gauges);
  return page.text();
}

}  // namespace lamprey::coordinator
