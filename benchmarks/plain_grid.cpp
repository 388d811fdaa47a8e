// The physical limit that `lamprey run` is measured against: the same jobs by the same engine on the same number of
// threads, without DDS, SQLite, digests or processes. Prints the wall seconds and jobs as JSON.
//
//   plain_grid SWEEP_FILE THREADS
#include "experiment/batch_engine.hpp"
#include "experiment/sweep.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

int main(int count, char** arguments) {
  using namespace lamprey;
  if (count != 3) {
    std::fputs("usage: plain_grid SWEEP_FILE THREADS\n", stderr);
    return 2;
  }
  try {
    const experiment::SweepGrid grid(experiment::read_sweep_file(arguments[1]).specification);
    const int threads = std::stoi(arguments[2]);
    std::atomic<std::uint64_t> next{0};
    std::atomic<std::uint64_t> accepted{0};
    const auto start = std::chrono::steady_clock::now();
    {
      std::vector<std::jthread> pool;
      for (int i = 0; i < threads; ++i) {
        pool.emplace_back([&] {
          const auto engine = experiment::make_scalar_engine();
          for (std::uint64_t number = next++; number < grid.jobs(); number = next++) {
            const std::vector<experiment::Job> job{grid.job(number)};
            const auto result = engine->run(job, {});
            accepted += std::get<experiment::Outcome>(result.front().result).accepted;
          }
        });
      }
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::printf("{\"jobs\": %llu, \"seconds\": %.3f, \"accepted_changes\": %llu}\n",
                static_cast<unsigned long long>(grid.jobs()), seconds, static_cast<unsigned long long>(accepted));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "plain_grid: %s\n", error.what());
    return 1;
  }
}
