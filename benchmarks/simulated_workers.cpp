// What a crowd of workers costs the coordinator itself, apart from DDS: the real coordinator, its ledger and SQLite,
// and real workers on the in-memory bus under a simulated clock (simulation/site.hpp). Told as one line of JSON.
#include "benchmarks/simulation/memory.hpp"
#include "benchmarks/simulation/site.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace lamprey;
using benchmarks::Cost;

constexpr auto joining_time = std::chrono::seconds{2};
constexpr auto idle_time = std::chrono::seconds{10};
constexpr std::uint64_t jobs_of_a_grid = 4;

struct Options {
  std::size_t workers = 1'000;
  std::uint64_t jobs = 20'000;
  std::uint32_t cycles = 3;
  double job_milliseconds = 100;
  std::string database;
};

std::string sweep_of(const Options& options) {
  return "name: simulated\nseed: 7\nbase: {mutation: all, cycles: " + std::to_string(options.cycles) +
         "}\ngrids:\n  - {required_stability: [25, 50, 75, 100]}\nreplicates: " +
         std::to_string(options.jobs / jobs_of_a_grid) + "\n";
}

/// The value that so large a share of them does not exceed.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

nlohmann::json measure(const Options& options) {
  const auto job_time = std::chrono::duration_cast<benchmarks::Clock::duration>(
      std::chrono::duration<double, std::milli>(options.job_milliseconds));
  const auto workers = static_cast<double>(options.workers);
  const auto jobs = static_cast<double>(options.jobs);
  benchmarks::Site site(options.workers, job_time, options.database);
  const auto before = benchmarks::counted_bytes();
  const Cost join = site.pass(joining_time);
  const auto idle_bytes = static_cast<double>(benchmarks::counted_bytes() - before) / workers;
  const Cost idle = site.pass(idle_time);
  const Cost grant = site.submit(sweep_of(options));
  const auto leased_bytes = static_cast<double>(benchmarks::counted_bytes() - before) / workers;
  const Cost work = site.work(options.jobs);
  const auto& latency = site.latency().measured();
  return {{"workers", options.workers},
          {"jobs", options.jobs},
          {"cycles", options.cycles},
          {"job_milliseconds", options.job_milliseconds},
          {"join_microseconds_per_worker", join.cpu / workers * 1e6},
          {"idle_bytes_per_worker", idle_bytes},
          {"leased_bytes_per_worker", leased_bytes},
          {"idle_share_of_a_core", idle.cpu / idle.elapsed},
          {"first_leases_milliseconds", grant.longest * 1e3},
          {"jobs_per_second", jobs / work.elapsed},
          {"share_of_time_computing", site.share_computing()},
          {"cpu_microseconds_per_job", work.cpu / jobs * 1e6},
          {"share_of_a_core", work.cpu / work.elapsed},
          {"share_of_time_in_steps", work.wall / work.elapsed},
          {"longest_step_milliseconds", work.longest * 1e3},
          {"leases", latency.size()},
          {"lease_milliseconds_median", quantile(latency, 0.5)},
          {"lease_milliseconds_99", quantile(latency, 0.99)},
          {"lease_milliseconds_longest", quantile(latency, 1)}};
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("The coordinator's own cost of a crowd of workers, on the in-memory bus.");
  Options options;
  app.add_option("--workers", options.workers, "one thread each")->check(CLI::Range(1, 100'000))->capture_default_str();
  app.add_option("--jobs", options.jobs, "rounded down to a multiple of 4")
      ->check(CLI::Range(std::uint64_t{4}, std::uint64_t{10'000'000}))
      ->capture_default_str();
  app.add_option("--cycles", options.cycles, "of each job: the more, the longer its trace")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--job-milliseconds", options.job_milliseconds, "of simulated time; 0: as fast as leases come")
      ->check(CLI::Range(0.0, 60'000.0))
      ->capture_default_str();
  app.add_option("--database", options.database, "made anew")->required();
  CLI11_PARSE(app, count, arguments);
  options.jobs -= options.jobs % jobs_of_a_grid;
  spdlog::set_level(spdlog::level::warn);
  try {
    if (std::filesystem::exists(options.database)) throw std::runtime_error("'" + options.database + "' exists");
    std::puts(measure(options).dump().c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "simulated_workers: %s\n", error.what());
    return 1;
  }
}
