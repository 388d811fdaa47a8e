#include "client/processes/fleet.hpp"

#include "client/failure.hpp"

#include <algorithm>
#include <csignal>
#include <system_error>
#include <thread>
#include <utility>

namespace lamprey::client::processes {

namespace {

/// A coordinator's line is held back this long: should it end meanwhile, the line is the reason and is told as such.
constexpr std::chrono::milliseconds line_hold{500};

constexpr std::chrono::milliseconds patience_with_workers{1100};
constexpr std::chrono::milliseconds patience_with_all{1500};
constexpr std::chrono::milliseconds look_interval{5};

constexpr std::string_view coordinator_program = "lamprey-coordinator";
constexpr std::string_view worker_program = "lamprey-worker";

std::filesystem::path find_program(const std::filesystem::path& folder, std::string_view name) {
  auto path = folder / name;
  if (std::filesystem::exists(path)) return path;
  throw Failure(
      exit_failure, "program_missing",
      std::string(name) + " is not beside this program (" + folder.string() + "); is the installation whole?");
}

std::vector<std::string> common_arguments(const FleetOptions& options, const std::string& vendor) {
  std::vector<std::string> arguments = {"--dds",          vendor,
                                        "--domain",       std::to_string(options.join.domain),
                                        "--isolation",    options.join.isolation,
                                        "--log-level",    options.log_level,
                                        "--loopback-only"};
  // By it they find a robot's bridge.
  const std::string& file = options.join.configuration_file;
  if (!file.empty()) arguments.insert(arguments.end(), {"--config", file});
  return arguments;
}

/// What an error line of lamprey-coordinator's log says; nothing if the line is none.
std::optional<std::string> error_in(const std::string& line) {
  const std::string mark = " error " + std::string(coordinator_program) + ": ";
  const auto found = line.find(mark);
  if (found == std::string::npos) return std::nullopt;
  return line.substr(found + mark.size());
}

std::string code_name(int exit_code) {
  switch (exit_code) {
    case exit_usage:
      return "usage";
    case exit_unreachable:
      return "cannot_join";
    case exit_storage:
      return "storage";
    default:
      return "coordinator";
  }
}

}  // namespace

Fleet::Fleet(FleetOptions options, std::function<void(const std::string&)> say)
    : options_(std::move(options)), say_(std::move(say)) {
  coordinator_.name = "the coordinator";
  coordinator_.program = find_program(options_.program_folder, coordinator_program);
  coordinator_.arguments = common_arguments(options_, options_.join.vendor);
  coordinator_.arguments.insert(coordinator_.arguments.end(), {"--database", options_.database});
  if (!options_.bridge.empty()) {
    coordinator_.arguments.insert(coordinator_.arguments.end(), {"--bridge-isolation", options_.bridge_isolation});
  }
  for (std::uint32_t number = 1; number <= options_.workers; ++number) workers_.push_back(make_worker(number));
  try {
    const auto now = Clock::now();
    start(coordinator_, now);
    for (auto& worker : workers_) start(worker, now);
  } catch (const std::system_error& error) {
    throw Failure(exit_failure, "cannot_start", error.what());
  }
}

Fleet::Member Fleet::make_worker(std::uint32_t number) const {
  const auto& vendors = options_.worker_vendors;
  Member worker;
  worker.name = "worker " + std::to_string(number);
  worker.program = find_program(options_.program_folder, worker_program);
  worker.arguments =
      common_arguments(options_, vendors.empty() ? options_.join.vendor : vendors[(number - 1) % vendors.size()]);
  worker.arguments.insert(worker.arguments.end(), {"--threads", std::to_string(options_.threads)});
  if (!options_.bridge.empty()) {
    worker.arguments.insert(worker.arguments.end(),
                            {"--bridge", options_.bridge, "--bridge-isolation", options_.bridge_isolation});
  }
  return worker;
}

void Fleet::start(Member& member, Clock::time_point now) {
  member.process = std::make_unique<ChildProcess>(member.program, member.arguments);
  member.started = now;
  member.restart_at.reset();
}

void Fleet::release_lines(Clock::time_point until) {
  while (!coordinator_lines_.empty() && coordinator_lines_.front().time <= until) {
    say_(coordinator_lines_.front().text);
    coordinator_lines_.pop_front();
  }
}

void Fleet::pass_on_lines(Clock::time_point now) {
  if (coordinator_.process) {
    for (auto& line : coordinator_.process->take_lines()) coordinator_lines_.push_back({now, std::move(line)});
  }
  release_lines(now - line_hold);
  for (auto& worker : workers_) {
    if (!worker.process) continue;
    for (const auto& line : worker.process->take_lines()) say_(line);
  }
}

void Fleet::coordinator_failed(const Exit& exit) {
  std::vector<std::string> reasons;
  std::vector<std::string> other_lines;
  for (auto& [time, line] : coordinator_lines_) {
    if (auto reason = error_in(line)) {
      reasons.push_back(std::move(*reason));
    } else {
      other_lines.push_back(std::move(line));
    }
  }
  coordinator_lines_.clear();
  if (reasons.empty()) reasons = std::move(other_lines);
  if (reasons.empty()) reasons.push_back("the coordinator " + exit.text());
  throw Failure(exit.code == 0 ? exit_failure : static_cast<ExitCode>(exit.code), code_name(exit.code),
                std::move(reasons));
}

void Fleet::look_after(Member& member, Clock::time_point now) {
  if (!member.process) {
    if (member.restart_at && now >= *member.restart_at) start(member, now);
    return;
  }
  const auto exit = member.process->poll();
  if (!exit) return;
  pass_on_lines(now);
  // An exit code is the coordinator's own judgement: starting it again would not change it.
  const bool is_coordinator = &member == &coordinator_;
  if (is_coordinator && exit->code != 0) coordinator_failed(*exit);
  const std::string what = member.name + " (process " + std::to_string(member.process->process()) + ") " + exit->text();
  member.process.reset();
  const auto delay = member.policy.after_death(now - member.started);
  if (delay) member.restart_at = now + *delay;
  if (is_coordinator && !delay) coordinator_failed(*exit);
  if (!is_coordinator) last_worker_end_ = what;
  say_("lamprey: " + what + (delay ? "; starting it again" : " too often; going on without it"));
}

void Fleet::step(Clock::time_point now) {
  pass_on_lines(now);
  look_after(coordinator_, now);
  for (auto& worker : workers_) look_after(worker, now);
  const bool any_left =
      std::ranges::any_of(workers_, [](const Member& worker) { return worker.process || worker.restart_at; });
  if (!any_left) throw Failure(exit_failure, "no_workers", "no worker is left: " + last_worker_end_);
}

bool Fleet::wait_for_workers(Clock::time_point until) {
  while (true) {
    const bool all_gone =
        std::ranges::all_of(workers_, [](Member& worker) { return !worker.process || worker.process->poll(); });
    if (all_gone || Clock::now() >= until) return all_gone;
    std::this_thread::sleep_for(look_interval);
  }
}

void Fleet::stop() noexcept {
  try {
    const auto begin = Clock::now();
    for (auto& worker : workers_) {
      if (worker.process) worker.process->send(SIGTERM);
    }
    wait_for_workers(begin + patience_with_workers);
    if (coordinator_.process) coordinator_.process->send(SIGTERM);
    while (coordinator_.process && !coordinator_.process->poll() && Clock::now() < begin + patience_with_all) {
      std::this_thread::sleep_for(look_interval);
    }
    pass_on_lines(Clock::now());
    release_lines(Clock::time_point::max());
  } catch (const std::exception&) {
    // No memory for a last line: what counts is that nobody stays behind.
  }
  for (auto& worker : workers_) {
    worker.process.reset();
    worker.restart_at.reset();
  }
  coordinator_.process.reset();
}

}  // namespace lamprey::client::processes
