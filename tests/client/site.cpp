#include "tests/client/site.hpp"

#include "experiment/batch_engine.hpp"
#include "experiment/sweep.hpp"
#include "storage/results_store.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <unistd.h>
#include <utility>

namespace lamprey::tests {

const char* const small_sweep =
    "name: small\n"
    "seed: 7\n"
    "base: {cycles: 20, mutation: all}\n"
    "grids:\n"
    "  - {steps: [uniform, normal], required_fuel: [25, 50]}\n"
    "replicates: 2\n";

namespace {

/// Sees the same whenever it looks, but for the traffic: at first, half of it.
class StandingWatch final : public messaging::discovery::Watch {
 public:
  explicit StandingWatch(messaging::discovery::DomainView view) : view_(std::move(view)) {}
  messaging::discovery::DomainView look() override {
    auto seen = view_;
    if (std::exchange(first_, false)) std::ranges::for_each(seen.traffic, halve);
    return seen;
  }

 private:
  static void halve(messaging::Traffic& traffic) {
    traffic.seconds /= 2;
    for (auto& topic : traffic.topics) {
      topic.written /= 2;
      topic.read /= 2;
    }
  }

  messaging::discovery::DomainView view_;
  bool first_ = true;
};

}  // namespace

Site::Site() {
  static std::atomic<int> counter{0};
  directory_ = std::filesystem::temp_directory_path() /
               ("lamprey-client-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
  std::filesystem::create_directories(directory_);
  ::setenv("LAMPREY_CONFIG", "/dev/null", 1);  // whatever this machine is set to
}

Site::~Site() {
  std::filesystem::remove_all(directory_);
}

ToolRun Site::run(const std::vector<std::string>& arguments, std::size_t columns) {
  std::ostringstream out;
  std::ostringstream err;
  const client::output::Console console{.out = out, .err = err, .columns = columns};
  const auto join = [this](const messaging::JoinOptions& options) {
    joined.push_back(options.vendor);
    if (options.vendor == unjoinable) throw messaging::JoinError("no " + options.vendor + " here");
    return bus.join("client");
  };
  const auto watch = [this](const messaging::JoinOptions&) { return std::make_unique<StandingWatch>(domain); };
  const client::Environment environment{
      .join = join, .watch = watch, .interrupted = [this] { return interrupted.load(); }, .program_folder = directory_};
  ToolRun run;
  run.exit_code = client::run_tool(arguments, console, environment);
  run.out = out.str();
  run.err = err.str();
  return run;
}

std::string Site::file(const std::string& name, const std::string& text) const {
  std::ofstream(directory_ / name) << text;
  return path(name);
}

std::string Site::database(const std::string& yaml, std::uint64_t done) const {
  const auto file = experiment::parse_sweep(yaml, "test.yaml");
  const experiment::SweepGrid grid(file.specification);
  storage::ResultsStore store(path("results.db"));
  const auto row = store
                       .add_sweep({.id = experiment::sweep_id(file.specification),
                                   .name = file.specification.name(),
                                   .specification = file.specification.SerializeAsString(),
                                   .source = yaml,
                                   .seed = file.specification.seed(),
                                   .replicates = grid.replicates(),
                                   .jobs = grid.jobs()})
                       .sweep.row;
  const auto engine = experiment::make_scalar_engine();
  storage::Batch batch;
  for (std::uint64_t number = 0; number <= done && number < grid.jobs(); ++number) {
    const auto job = grid.job(number);
    storage::EndedJob ended;
    ended.sweep = row;
    ended.job = number;
    ended.identity = experiment::identity(job);
    ended.parameters = experiment::to_json(job.parameters);
    ended.seed = job.seed;
    ended.replicate = job.replicate;
    if (number < done) {
      ended.outcome = std::get<experiment::Outcome>(engine->run({&job, 1}, {}).front().result);
      ended.digest = experiment::outcome_digest(*ended.identity, *ended.outcome);
    } else {
      ended.state = storage::JobState::failed;
      ended.reason = "no memory";
    }
    batch.jobs.push_back(std::move(ended));
  }
  store.commit(batch);
  return path("results.db");
}

}  // namespace lamprey::tests
