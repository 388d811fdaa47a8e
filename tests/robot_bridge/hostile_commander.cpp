// Commands a robot as nobody should: beyond its range, with what is no number, for other robots, under claims that are
// over, never were or are somebody else's, out of order, again, and 10,000 times a second. Half of the time it holds
// the claim, and then gives commands that are let through, to where no servo can go.
//
//   lamprey_hostile_commander --robot NAME --seconds N --seed N [--no-claim] [DDS options]
//
// Prints how many commands of each kind it has sent, as JSON.
#include "messaging/program/exit_codes.hpp"
#include "messaging/program/join_options.hpp"
#include "messaging/robot/robot_asker.hpp"
#include "messaging/robot/robot_name.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <thread>

namespace {

using namespace lamprey;
using namespace std::chrono_literals;
using messaging::ServoCommand;
using messaging::ServoState;
using Clock = std::chrono::steady_clock;

struct Options {
  std::string robot;
  int seconds = 5;
  std::uint64_t seed = 1;
  bool no_claim = false;
  messaging::JoinOptions join;
};

class Commander {
 public:
  Commander(messaging::Participant& participant, const Options& options)
      : options_(options),
        random_(options.seed),
        robot_(messaging::robot_number(options.robot)),
        asker_(participant, signal_, robot_, options.seed),
        states_(participant.reader<ServoState>(signal_, messaging::Partition::of(robot_))),
        statuses_(participant.reader<messaging::RobotStatus>(signal_)),
        commands_(participant.writer<ServoCommand>(messaging::Partition::of(robot_))) {}

  void run() {
    const auto end = Clock::now() + std::chrono::seconds(options_.seconds);
    for (bool claiming = true; Clock::now() < end; claiming = !claiming) {
      if (claiming && !options_.no_claim) ask(messaging::RobotRequestKind::claim);
      for (const auto phase_end = Clock::now() + 400ms; Clock::now() < phase_end;) {
        if (token_ != 0) evaluate();
        harass(20, 3ms);
      }
      harass(2000, 100us);
      if (token_ != 0) ask(messaging::RobotRequestKind::release);
    }
  }

  nlohmann::json sent() const { return sent_; }

 private:
  std::uint64_t below(std::uint64_t bound) {
    return std::uniform_int_distribution<std::uint64_t>(0, bound - 1)(random_);
  }

  void ask(messaging::RobotRequestKind kind) {
    messaging::RobotRequest request;
    request.kind = kind;
    request.token = token_;
    const auto reply = asker_.ask(request, 300ms, [] { return false; });
    const bool ours = kind == messaging::RobotRequestKind::claim && reply && reply->granted;
    token_ = ours ? reply->token : 0;
    evaluation_ = newest_evaluation_ = 0;
  }

  /// Under the claim, each step when the one before it is over, to where the servos can't go, or not so fast; until a
  /// fault is put in.
  void evaluate() {
    listen(std::nullopt);
    evaluation_ = newest_evaluation_ + 1;
    const auto faulty = static_cast<std::uint32_t>(3 + below(6));
    for (std::uint32_t step = 0; step < faulty; ++step) {
      send("beyond the range", wild(token_, evaluation_, step));
      if (!is_made(step)) return;
    }
    ServoCommand command = wild(token_, evaluation_, faulty);
    switch (below(4)) {
      case 0:
        command.position[below(command.position.size())] = std::numeric_limits<double>::quiet_NaN();
        send("not a number", command);
        break;
      case 1:
        command.position[below(command.position.size())] =
            (below(2) == 0 ? 1 : -1) * std::numeric_limits<double>::infinity();
        send("infinite", command);
        break;
      case 2:
        --command.time_step;
        send("again", command);
        break;
      default:
        command.time_step += 1 + static_cast<std::uint32_t>(below(1000));
        send("out of order", command);
        break;
    }
    std::this_thread::sleep_for(5ms);
    ++command.time_step;
    send("of a void evaluation", command);
    std::this_thread::sleep_for(5ms);
  }

  bool is_made(std::uint32_t step) {
    for (const auto until = Clock::now() + 200ms; Clock::now() < until;) {
      if (const auto made = listen(step)) return *made;
      signal_->wait_for(5ms);
    }
    return false;
  }

  /// To the robot, for what others do with it; whether that step of the own evaluation is made or void, if it tells.
  std::optional<bool> listen(std::optional<std::uint32_t> step) {
    for (const auto& status : statuses_->take()) {
      if (status.robot == robot_) newest_token_ = status.token;
    }
    std::optional<bool> made;
    for (const auto& state : states_->take()) {
      newest_token_ = std::max(newest_token_, state.token);
      if (state.token != newest_token_) continue;
      newest_evaluation_ = std::max(newest_evaluation_, state.evaluation);
      if (state.token != token_ || state.evaluation != evaluation_) continue;
      if (state.outcome == messaging::StepOutcome::voided) made = false;
      if (state.outcome == messaging::StepOutcome::done && state.time_step == step) made = true;
    }
    return made;
  }

  /// From outside of any claim of its own.
  void harass(int commands, Clock::duration pace) {
    auto due = Clock::now();
    for (int i = 0; i < commands; ++i) {
      listen(std::nullopt);
      const auto evaluation = newest_evaluation_ + (below(100) == 0 ? 1 : 0);
      ServoCommand command = wild(newest_token_, evaluation, static_cast<std::uint32_t>(below(30)));
      switch (below(40) == 0 ? 3 : below(3) + 4 * below(2)) {
        case 0:
          command.robot ^= 1 + below(std::numeric_limits<std::uint32_t>::max());
          send("for another robot", command);
          break;
        case 1:
          command.token = random_();
          send("under no claim", command);
          break;
        case 2:
          command.token -= 1 + below(3);
          send("under an old claim", command);
          break;
        case 3:
          // As if two held one claim.
          ++command.evaluation;
          command.time_step = 0;
          send("under the claim of whoever holds it", command);
          break;
        default:
          send("anything under that claim", command);
          break;
      }
      std::this_thread::sleep_until(due += pace);
    }
  }

  ServoCommand wild(std::uint64_t token, std::uint64_t evaluation, std::uint32_t step) {
    constexpr std::array extremes{1e300, -1e300, 30.000001, -1e-9, 1e6, -1e6};
    ServoCommand command;
    command.robot = robot_;
    command.token = token;
    command.evaluation = evaluation;
    command.time_step = step;
    for (double& position : command.position) {
      position = below(2) == 0 ? extremes[below(extremes.size())] : static_cast<double>(below(31));
    }
    return command;
  }

  void send(const std::string& kind, const ServoCommand& command) {
    if (commands_->write(command)) ++sent_[kind];
  }

  const Options& options_;
  std::mt19937_64 random_;
  std::uint64_t robot_;
  std::shared_ptr<messaging::Signal> signal_ = std::make_shared<messaging::Signal>();
  messaging::RobotAsker asker_;
  std::unique_ptr<messaging::Reader<ServoState>> states_;
  std::unique_ptr<messaging::Reader<messaging::RobotStatus>> statuses_;
  std::unique_ptr<messaging::Writer<ServoCommand>> commands_;
  std::uint64_t token_ = 0;         ///< of its own claim
  std::uint64_t newest_token_ = 0;  ///< of anybody's
  std::uint64_t newest_evaluation_ = 0;
  std::uint64_t evaluation_ = 0;
  std::map<std::string, std::uint64_t> sent_;
};

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Commands a robot as nobody should.");
  Options options;
  app.add_option("--robot", options.robot)->required();
  app.add_option("--seconds", options.seconds)->check(CLI::Range(1, 3600));
  app.add_option("--seed", options.seed)->check(CLI::PositiveNumber);
  app.add_flag("--no-claim", options.no_claim);
  messaging::program::add_join_options(app, options.join);
  try {
    app.parse(count, arguments);
    const auto participant = messaging::join(options.join);
    Commander commander(*participant, options);
    commander.run();
    std::cout << commander.sent().dump() << std::endl;
    return messaging::program::exit_ok;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? messaging::program::exit_ok : messaging::program::exit_usage;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return messaging::program::exit_failure;
  }
}
