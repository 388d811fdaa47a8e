#include "client/views/workers.hpp"

#include "client/output/formatting.hpp"
#include "client/output/table.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace lamprey::client::views {

namespace {

using output::Align;
using output::with_thousands;
using output::without_controls;

std::string process_text(const idl::WorkerSummary& worker) {
  return without_controls(worker.host()) + "/" + std::to_string(worker.process());
}

std::string labels_text(const idl::WorkerSummary& worker) {
  return without_controls(output::joined({worker.labels().begin(), worker.labels().end()}, ", "));
}

std::string running_text(const idl::WorkerSummary& worker) {
  constexpr int most = 4;
  std::vector<std::string> jobs;
  for (int i = 0; i < std::min(worker.running_size(), most); ++i) {
    const auto& job = worker.running(i);
    jobs.push_back("job " + std::to_string(job.job()) + " of " + without_controls(job.sweep()) + ": cycle " +
                   with_thousands(job.cycle()) + ", " + output::duration(job.seconds()));
  }
  if (worker.running_size() > most) jobs.push_back("and " + std::to_string(worker.running_size() - most) + " more");
  return output::joined(jobs, "; ");
}

bool nobody(const output::Console& console, const idl::StatusReply& status) {
  if (status.workers().empty()) console.out << "No workers: start lamprey-worker on any machine.\n";
  return status.workers().empty();
}

}  // namespace

Json worker_json(const idl::WorkerSummary& worker) {
  Json running = Json::array();
  for (const auto& job : worker.running()) {
    running.push_back({{"sweep", job.sweep()}, {"job", job.job()}, {"cycle", job.cycle()}, {"seconds", job.seconds()}});
  }
  return {{"worker", worker.worker()},
          {"host", worker.host()},
          {"process", worker.process()},
          {"threads", worker.threads()},
          {"state", worker.state()},
          {"dds", worker.dds()},
          {"jobs_done", worker.jobs_done()},
          {"leases", worker.leases()},
          {"labels", std::vector<std::string>(worker.labels().begin(), worker.labels().end())},
          {"build", worker.build()},
          {"processor", worker.processor()},
          {"instruction_set", worker.instruction_set()},
          {"results_held", worker.results_held()},
          {"seconds_since_heard", worker.seconds_since_heard()},
          {"running", std::move(running)}};
}

Json workers_json(const idl::StatusReply& status) {
  Json workers = Json::array();
  for (const auto& worker : status.workers()) workers.push_back(worker_json(worker));
  return workers;
}

void print_workers(const output::Console& console, const idl::StatusReply& status) {
  if (nobody(console, status)) return;
  output::Table table({{"worker"},
                       {"host/process"},
                       {"threads", Align::right},
                       {"state"},
                       {"DDS"},
                       {"jobs done", Align::right},
                       {"leases", Align::right}});
  for (const auto& worker : status.workers()) {
    table.add({worker.worker(), process_text(worker), std::to_string(worker.threads()), worker.state(), worker.dds(),
               with_thousands(worker.jobs_done()), with_thousands(worker.leases())});
  }
  table.print(console);
}

void print_workers_in_detail(const output::Console& console, const idl::StatusReply& status, std::size_t most) {
  if (nobody(console, status)) return;
  const bool labels =
      std::ranges::any_of(status.workers(), [](const auto& worker) { return worker.labels_size() > 0; });
  std::vector<output::Table::Column> columns = {{"worker"},
                                                {"host/process"},
                                                {"state"},
                                                {"threads", Align::right},
                                                {"leases", Align::right},
                                                {"jobs done", Align::right},
                                                {"results held", Align::right},
                                                {"last heard", Align::right}};
  if (labels) columns.push_back({"labels"});
  output::Table table(std::move(columns));
  std::size_t shown = 0;
  for (const auto& worker : status.workers()) {
    if (most > 0 && shown++ == most) break;
    table.add({worker.worker(), process_text(worker), worker.state(), std::to_string(worker.threads()),
               with_thousands(worker.leases()), with_thousands(worker.jobs_done()),
               with_thousands(worker.results_held()), output::duration(worker.seconds_since_heard()) + " ago",
               labels_text(worker)});
    if (const auto running = running_text(worker); !running.empty()) table.note(running);
  }
  table.print(console);
  const auto all = static_cast<std::size_t>(status.workers_size());
  if (most > 0 && all > most) {
    console.out << console.dim("and " + output::counted(all - most, "more worker", "more workers")) << '\n';
  }
}

}  // namespace lamprey::client::views
