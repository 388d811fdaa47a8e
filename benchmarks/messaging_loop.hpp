#pragma once

#include "messaging/port.hpp"
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/qos.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <poll.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>
#include <stdexcept>
#include <string>
#include <thread>
#include <type_traits>
#include <unistd.h>
#include <vector>

/// What benchmarks/messaging measures, the same over our port and over each vendor's own interface: a sender asks, a
/// receiver that was there before answers. Both are told apart by their `End`, the endpoints of one process:
///
///   End(const messaging::JoinOptions&, bool sender)   joins; may throw
///   bool wait(milliseconds)                           until something has come; whether it has
///   bool write<Sample>(const Stamp&)                  fills a whole sample after the stamp; false: full, write again
///   void take<Sample>(each)                           each(Stamp, sample) of all that has come
///   bool write_back<Sample>(sample)                   as it was taken; false: full, write again
///
/// of messaging::Lease and messaging::ResultBatch, which here only name the kind.
namespace lamprey::benchmarks {

using Clock = std::chrono::steady_clock;

inline constexpr std::size_t ranges_of_lease = 4;
/// With these a batch has 59 KB: what a worker sends when much has been computed.
inline constexpr std::size_t records_of_batch = 100;
inline constexpr std::size_t changes_of_record = 7;

enum class Phase : std::uint32_t { greeting, round_trip, flow, acknowledgement };

/// What a sample says of itself.
struct Stamp {
  std::uint64_t incarnation = 0;  ///< of the sender: origin.epoch
  Phase phase = Phase::greeting;  ///< origin.science_version
  std::uint64_t number = 0;       ///< sequence
  bool intact = true;             ///< whether the sample is as the number asks for
};

// A record's content after its number, so that none can be mistaken for another.
inline std::uint64_t job_of(std::uint64_t batch, std::size_t record) {
  return batch * records_of_batch + record;
}
inline double figure(std::uint64_t job, std::size_t place) {
  return static_cast<double>(job) + static_cast<double>(place) / 64;
}
inline std::uint8_t octet(std::uint64_t job, std::size_t place) {
  return static_cast<std::uint8_t>(job + place);
}

struct LoopOptions {
  messaging::JoinOptions join;
  bool sender = false;
  std::uint64_t incarnation = 1;
  std::uint64_t lease_trips = 0;
  std::uint64_t result_trips = 0;
  std::uint64_t leases = 0;
  std::uint64_t batches = 0;
  bool hold = false;
};

/// Of a vendor's own loop, which has no partitions.
struct TopicNames {
  std::string to;
  std::string from;
};
template <class Sample>
TopicNames topic_names(const messaging::JoinOptions& join, bool sender) {
  std::string name = join.isolation + "/" + std::string(messaging::Topic<Sample>::name);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '-' || c == '.'; }, '_');  // not in a topic's name
  const std::string there = name + "/there";
  const std::string back = name + "/back";
  return sender ? TopicNames{there, back} : TopicNames{back, there};
}

/// Of samples under way that the receiver has not answered: fewer than a lease writer keeps (which overwrites), more
/// than a result writer does (which has to block).
template <class Sample>
inline constexpr std::uint64_t window = std::is_same_v<Sample, messaging::Lease> ? 256 : 1024;
inline constexpr std::uint64_t acknowledged_at_once = 32;
static_assert(window<messaging::Lease> < messaging::Topic<messaging::Lease>::profile.depth);
static_assert(window<messaging::ResultBatch> > messaging::Topic<messaging::ResultBatch>::profile.depth);

inline std::int64_t nanoseconds(Clock::duration duration) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(duration).count();
}

/// Whether whoever started this program has closed its standard input.
inline bool told_to_end() {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return poll(&input, 1, 0) > 0;
}

/// Asks. Throws std::runtime_error if nothing is answered for a while.
template <class End>
class Sender {
 public:
  explicit Sender(const LoopOptions& options)
      : options_(options), joined_(Clock::now()), end_(options.join, /*sender=*/true), progress_(Clock::now()) {}

  nlohmann::json run() {
    nlohmann::json report;
    report["match_ns"] = greet();
    if (options_.lease_trips > 0) report["lease_trip_ns"] = round_trips<messaging::Lease>(options_.lease_trips);
    if (options_.result_trips > 0)
      report["result_trip_ns"] = round_trips<messaging::ResultBatch>(options_.result_trips);
    if (options_.leases > 0) report["leases"] = flow<messaging::Lease>(options_.leases);
    if (options_.batches > 0) report["batches"] = flow<messaging::ResultBatch>(options_.batches);
    return report;
  }

 private:
  /// From before joining to the first answer. Leases are kept for who comes late, so that one is enough; results are
  /// not.
  std::int64_t greet() {
    write<messaging::Lease>(Phase::greeting, 0);
    await_answer<messaging::Lease>(Phase::greeting, 0);
    const auto matched = progress_;
    do {
      write<messaging::ResultBatch>(Phase::greeting, 0);
      end_.wait(step);
    } while (!answered<messaging::ResultBatch>(Phase::greeting, 0));
    return nanoseconds(matched - joined_);
  }

  /// Median and 99th percentile.
  template <class Sample>
  nlohmann::json round_trips(std::uint64_t count) {
    std::vector<std::int64_t> times;
    for (std::uint64_t number = 0; number < count + unmeasured; ++number) {
      const auto start = Clock::now();
      write<Sample>(Phase::round_trip, number);
      await_answer<Sample>(Phase::round_trip, number);
      if (number >= unmeasured) times.push_back(nanoseconds(progress_ - start));
    }
    std::sort(times.begin(), times.end());
    return {times[times.size() / 2], times[times.size() * 99 / 100]};
  }

  /// At least so many samples, as fast as they are taken. All have been taken when it is over.
  template <class Sample>
  nlohmann::json flow(std::uint64_t least) {
    const std::uint64_t count = (least + acknowledged_at_once - 1) / acknowledged_at_once * acknowledged_at_once;
    acknowledged_ = 0;
    full_ = 0;
    longest_pause_ = {};
    const auto start = Clock::now();
    progress_ = start;
    for (std::uint64_t number = 0; number < count; ++number) {
      if (number % acknowledged_at_once == 0) take_acknowledgements();
      while (number - acknowledged_ >= window<Sample>) await_acknowledgement();
      write<Sample>(Phase::flow, number);
    }
    while (acknowledged_ < count) await_acknowledgement();
    return {{"samples", count},
            {"ns", nanoseconds(progress_ - start)},
            {"full", full_},
            {"longest_pause_ns", nanoseconds(longest_pause_)}};
  }

  template <class Sample>
  void write(Phase phase, std::uint64_t number) {
    while (!end_.template write<Sample>({.incarnation = options_.incarnation, .phase = phase, .number = number})) {
      ++full_;
      check_patience();
    }
  }

  template <class Sample>
  void await_answer(Phase phase, std::uint64_t number) {
    do {
      end_.wait(step);
      check_patience();
    } while (!answered<Sample>(phase, number));
  }

  template <class Sample>
  bool answered(Phase phase, std::uint64_t number) {
    bool found = false;
    end_.template take<Sample>([&](const Stamp& stamp, const auto&) {
      found |= stamp.incarnation == options_.incarnation && stamp.phase == phase && stamp.number == number;
    });
    if (found) progress_ = Clock::now();
    return found;
  }

  void await_acknowledgement() {
    end_.wait(step);
    take_acknowledgements();
    check_patience();
  }

  void take_acknowledgements() {
    end_.template take<messaging::Lease>([&](const Stamp& stamp, const auto&) {
      if (stamp.incarnation != options_.incarnation || stamp.phase != Phase::acknowledgement) return;
      acknowledged_ = std::max(acknowledged_, stamp.number);
      const auto now = Clock::now();
      longest_pause_ = std::max(longest_pause_, now - progress_);
      progress_ = now;
    });
  }

  void check_patience() const {
    if (Clock::now() - progress_ > std::chrono::seconds(30)) throw std::runtime_error("no answer for 30 s");
  }

  static constexpr std::chrono::milliseconds step{10};
  static constexpr std::uint64_t unmeasured = 50;  // the first round trips fill caches and pools

  const LoopOptions& options_;
  Clock::time_point joined_;
  End end_;
  Clock::time_point progress_;
  std::uint64_t acknowledged_ = 0;
  std::uint64_t full_ = 0;
  Clock::duration longest_pause_{};
};

/// What has come of a flow, whose samples are numbered from 0.
struct Tally {
  std::uint64_t next = 0;
  std::uint64_t taken = 0;
  std::uint64_t lost = 0;
  std::uint64_t doubled = 0;
  std::uint64_t broken = 0;

  void note(const Stamp& stamp) {
    ++taken;
    if (!stamp.intact) ++broken;
    if (stamp.number < next) {
      ++doubled;
      return;
    }
    lost += stamp.number - next;
    next = stamp.number + 1;
  }
  nlohmann::json report() const { return {{"taken", taken}, {"lost", lost}, {"doubled", doubled}, {"broken", broken}}; }
};

/// Answers, until it is told to end.
template <class End>
class Receiver {
 public:
  explicit Receiver(const LoopOptions& options) : options_(options), end_(options.join, /*sender=*/false) {}

  nlohmann::json run() {
    std::puts("ready");
    std::fflush(stdout);
    while (end_.wait(std::chrono::milliseconds(50)) || !told_to_end()) {
      serve<messaging::Lease>(leases_);
      serve<messaging::ResultBatch>(batches_);
    }
    nlohmann::json seen = nlohmann::json::object();
    for (const auto& [incarnation, time] : seen_)
      seen[std::to_string(incarnation)] = nanoseconds(time.time_since_epoch());
    return {{"seen_ns", seen}, {"leases", leases_.report()}, {"batches", batches_.report()}};
  }

 private:
  template <class Sample>
  void serve(Tally& tally) {
    end_.template take<Sample>([&](const Stamp& stamp, const auto& sample) {
      if (stamp.phase == Phase::flow) {
        tally.note(stamp);
        if (tally.taken % acknowledged_at_once == 0) acknowledge(stamp.incarnation, tally.taken);
        return;
      }
      if (stamp.phase == Phase::greeting) seen_.try_emplace(stamp.incarnation, Clock::now());
      while (!end_.template write_back<Sample>(sample)) {
        if (told_to_end()) return;
      }
    });
  }

  void acknowledge(std::uint64_t incarnation, std::uint64_t taken) {
    const Stamp stamp{.incarnation = incarnation, .phase = Phase::acknowledgement, .number = taken};
    while (!end_.template write<messaging::Lease>(stamp)) {
      if (told_to_end()) return;
    }
  }

  const LoopOptions& options_;
  End end_;
  std::map<std::uint64_t, Clock::time_point> seen_;  ///< when each incarnation has first been heard of
  Tally leases_;
  Tally batches_;
};

inline void add_loop_options(CLI::App& app, LoopOptions& options) {
  auto* const sender = app.add_flag("--sender", options.sender, "Ask, rather than answer until standard input ends");
  app.add_option("--incarnation", options.incarnation)->needs(sender);
  app.add_option("--lease-trips", options.lease_trips, "Round trips of leases")->needs(sender);
  app.add_option("--result-trips", options.result_trips, "Round trips of result batches")->needs(sender);
  app.add_option("--leases", options.leases, "As fast as they are taken")->needs(sender);
  app.add_option("--batches", options.batches, "Of results, as fast as they are taken")->needs(sender);
  app.add_flag("--hold", options.hold, "Stay after the report, until standard input ends")->needs(sender);
  messaging::program::add_join_options(app, options.join);
}

/// main() of a loop's program, which prints its report as one line of JSON.
template <class End>
int loop_main(int count, char** arguments, const char* description) {
  using namespace messaging::program;
  CLI::App app(description);
  LoopOptions options;
  add_loop_options(app, options);
  const auto print = [](const nlohmann::json& report) {
    std::puts(report.dump().c_str());
    std::fflush(stdout);
  };
  try {
    app.parse(count, arguments);
    spdlog::set_default_logger(spdlog::stderr_logger_mt(arguments[0]));
    if (!options.sender) {
      print(Receiver<End>(options).run());
      return exit_ok;
    }
    Sender<End> sender(options);
    print(sender.run());
    while (options.hold && !told_to_end()) std::this_thread::sleep_for(std::chrono::milliseconds(50));
    return exit_ok;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? exit_ok : exit_usage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", arguments[0], error.what());
    return exit_failure;
  }
}

}  // namespace lamprey::benchmarks
