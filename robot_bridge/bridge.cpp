#include "robot_bridge/bridge.hpp"

#include "experiment/problem.hpp"
#include "messaging/robot/robot_name.hpp"
#include "messaging/robot/robot_state.hpp"

#include <algorithm>
#include <cmath>
#include <spdlog/spdlog.h>
#include <utility>

namespace lamprey::robot_bridge {
namespace {

using messaging::Partition;
using messaging::RobotRequestKind;
using messaging::StepOutcome;

constexpr std::chrono::milliseconds heartbeat_interval{500};
/// Whoever stops the robot is answered within this, whether or not the device has confirmed.
constexpr std::chrono::milliseconds stop_answer{60};
constexpr std::chrono::seconds activation_time{5};
constexpr std::chrono::seconds placing_time{60};

}  // namespace

Bridge::Bridge(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal, ControlLoop& control,
               StateFile& file, const BridgeOptions& options, Clock::time_point now)
    : signal_(std::move(signal)),
      control_(control),
      file_(file),
      options_(options),
      robot_(messaging::robot_number(options.robot)),
      claims_(file.state().newest_token, options.claim_lease),
      gate_(options.grace),
      requests_(participant, signal_, robot_),
      commands_(participant.reader<messaging::ServoCommand>(signal_, Partition::of(robot_))),
      states_(participant.writer<messaging::ServoState>(Partition::of(robot_))),
      statuses_(participant.writer<messaging::RobotStatus>()),
      participant_(participant) {
  if (options_.emergency != nullptr) emergency_.emplace(*options_.emergency, signal_, robot_);
  if (stopped()) {
    spdlog::warn("the emergency stop is latched: {}", file_.state().stop_reason);
    // The bridge that latched it may not have reached the device.
    control_.stop();
  }
  step(now);
}

void Bridge::step(Clock::time_point now) {
  control_status_ = control_.status();
  take_requests(now);
  take_reports(now);
  take_commands(now);
  look_after_evaluation(now);
  answer_pending(now);
  publish_status(now);
}

void Bridge::finish() {
  void_evaluation("the bridge ends");
  last_status_.state = RobotState::finalized;
  ++last_status_.heartbeat;
  static_cast<void>(statuses_->write(last_status_));
}

std::string Bridge::hindrance() const {
  if (stopped()) return "emergency stop: " + file_.state().stop_reason;
  if (control_status_.state == RobotState::active) return {};
  const std::string state(to_text(control_status_.state));
  return "the robot is " + state + (control_status_.reason.empty() ? "" : ": " + control_status_.reason);
}

void Bridge::take_requests(Clock::time_point now) {
  for (const auto& request : requests_.take()) look_at(requests_, request, now);
  if (!emergency_) return;
  // Whoever is on this door's vendor comes through both; anything but the stop has the other one.
  for (const auto& request : emergency_->take()) {
    if (request.kind == RobotRequestKind::stop) look_at(*emergency_, request, now);
  }
}

void Bridge::look_at(RequestDoor& door, const Request& request, Clock::time_point now) {
  const bool waits = std::ranges::any_of(pending_, [&](const Pending& pending) {
    return pending.door == &door && pending.request.asker == request.asker &&
           pending.request.correlation == request.correlation;
  });
  if (waits) return;
  const bool stops_anew = request.kind == RobotRequestKind::stop && !stopped();
  if (stops_anew || !door.answer_again(request)) handle(door, request, now);
}

void Bridge::handle(RequestDoor& door, const Request& request, Clock::time_point now) {
  switch (request.kind) {
    case RobotRequestKind::claim:
      return claim(request, now);
    case RobotRequestKind::release: {
      const bool was_its = claims_.holds(request.token, now);
      const auto answer = claims_.release(request.asker, request.token, now);
      if (answer.granted && was_its) control_.halt();
      if (answer.granted && request.token == gate_.token()) void_evaluation("its claim was released");
      return send(reply_to(request, answer.granted, answer.reason));
    }
    case RobotRequestKind::stop:
      return stop(door, request, now);
    case RobotRequestKind::reset:
      return reset(request);
    case RobotRequestKind::activate:
      if (stopped()) return send(reply_to(request, false, hindrance()));
      pending_.push_back({&door, request, control_.activate(request.confirmed), now + activation_time});
      return;
    case RobotRequestKind::deactivate:
      void_evaluation("the robot was deactivated");
      pending_.push_back({&door, request, control_.deactivate(), now + activation_time});
      return;
    case RobotRequestKind::place:
      return place(request, now);
  }
}

void Bridge::claim(const Request& request, Clock::time_point now) {
  // A claim that is in force is renewed over a failure of the device: its holder waits for the robot to come back.
  const std::string why_not = hindrance();
  if (!why_not.empty() && (stopped() || !claims_.holds(request.token, now))) {
    return send(reply_to(request, false, why_not));
  }
  auto answer = claims_.claim(request.asker, request.token, now);
  if (answer.is_new) {
    auto state = file_.state();
    state.newest_token = answer.token;
    if (!store(state)) {
      claims_.revoke();
      return send(reply_to(request, false, "the bridge can't store the claim's token"));
    }
    spdlog::info("claim {} granted to {:016x}", answer.token, request.asker);
  }
  if (answer.granted) control_.keep_on(now);
  send(reply_to(request, answer.granted, answer.reason));
}

void Bridge::stop(RequestDoor& door, const Request& request, Clock::time_point now) {
  const auto order = control_.stop();
  const std::string reason = request.reason.empty() ? "no reason given" : experiment::printable(request.reason);
  spdlog::warn("emergency stop: {}", reason);
  if (!stopped() || !stop_is_stored_) latch(stopped() ? file_.state().stop_reason : reason);
  claims_.revoke();
  void_evaluation("emergency stop: " + reason);
  pending_.push_back({&door, request, order, now + stop_answer});
}

void Bridge::latch(const std::string& reason) {
  stop_is_stored_ = false;
  try {
    file_.latch(reason);
    stop_is_stored_ = true;
  } catch (const std::exception& error) {
    spdlog::error("{}: the stop is in force, but ends with this bridge", error.what());
  }
}

void Bridge::reset(const Request& request) {
  auto state = file_.state();
  const bool was_stopped = std::exchange(state.stopped, false);
  state.stop_reason.clear();
  if (was_stopped && !store(state)) return send(reply_to(request, false, "the bridge can't store that it is reset"));
  if (was_stopped) spdlog::info("the emergency stop was reset by {:016x}", request.asker);
  send(reply_to(request, true, {}));
}

void Bridge::place(const Request& request, Clock::time_point now) {
  std::string why_not = hindrance();
  if (why_not.empty() && !claims_.holds(request.token, now)) {
    why_not = "claim " + std::to_string(request.token) + " is not in force";
  }
  const bool numbers = std::ranges::all_of(request.position, [](double position) { return std::isfinite(position); });
  if (why_not.empty() && !numbers) why_not = "a position is no number";
  if (!why_not.empty()) return send(reply_to(request, false, why_not));
  claims_.renew(now);
  void_evaluation("the robot was placed anew");
  pending_.push_back({&requests_, request, control_.place(request.position), now + placing_time});
}

bool Bridge::store(const StoredState& state) {
  try {
    file_.store(state);
    return true;
  } catch (const std::exception& error) {
    spdlog::error("{}", error.what());
    return false;
  }
}

void Bridge::answer_pending(Clock::time_point now) {
  for (std::size_t i = 0; i < pending_.size();) {
    const Pending& pending = pending_[i];
    const bool done = control_status_.orders_done >= pending.order;
    const bool place = pending.request.kind == RobotRequestKind::place;
    const bool held = claims_.holds(pending.request.token, now);
    if (!done && now < pending.until && (!place || held)) {
      if (place) claims_.renew(now);
      ++i;
      continue;
    }
    // Not where a newer claim places the robot already.
    if (!done && place && held) control_.halt();
    Reply reply = reply_to(pending.request, true, {});
    switch (pending.request.kind) {
      case RobotRequestKind::stop:
        if (!done || !control_status_.servos_off) {
          reply.reason = "latched, but the device has not confirmed that its servos are off";
        } else if (!stop_is_stored_) {
          reply.reason = "its servos are off, but the stop could not be stored and ends with this bridge";
        }
        break;
      case RobotRequestKind::deactivate:
        if (!done || !control_status_.servos_off) {
          reply.granted = false;
          reply.reason = "the device has not confirmed that its servos are off";
        }
        break;
      default:
        reply.reason = hindrance();
        if (reply.reason.empty() && !done) reply.reason = "it took too long";
        reply.granted = reply.reason.empty();
    }
    RequestDoor& door = *pending.door;
    pending_.erase(pending_.begin() + static_cast<std::ptrdiff_t>(i));
    send(door, std::move(reply));
  }
}

Bridge::Reply Bridge::reply_to(const Request& request, bool granted, const std::string& reason) const {
  return {.robot = robot_,
          .asker = request.asker,
          .correlation = request.correlation,
          .granted = granted,
          .reason = reason,
          .token = claims_.newest_token(),
          .lease_milliseconds = static_cast<std::uint32_t>(options_.claim_lease.count()),
          .state = control_status_.state,
          .stopped = stopped()};
}

void Bridge::send(RequestDoor& door, Reply reply) {
  requests_refused_ += std::uint64_t{!reply.granted};
  door.answer(std::move(reply));
}

void Bridge::take_commands(Clock::time_point now) {
  for (const auto& command : commands_->take()) {
    if (command.robot != robot_) {
      ++other_robots_;
      continue;
    }
    const auto decision = gate_.look(command, claims_, now);
    if (!decision.voided.empty()) void_evaluation(decision.voided);
    if (!decision.accepted) continue;
    claims_.renew(now);
    if (const auto why_not = hindrance(); !why_not.empty()) {
      void_evaluation(why_not);
      continue;
    }
    control_.order({.evaluation = command.evaluation,
                    .time_step = command.time_step,
                    .target = command.position,
                    .arrived = Clock::now()});
  }
}

void Bridge::take_reports(Clock::time_point now) {
  for (auto& report : control_.take_reports()) {
    // One of an evaluation that is void by now is of no use to anybody.
    if (report.order.evaluation != gate_.evaluation() || report.order.time_step != gate_.time_step()) continue;
    if (!report.done) {
      void_evaluation(report.reason);
      continue;
    }
    gate_.step_done(now);
    messaging::ServoState state{.robot = robot_,
                                .token = gate_.token(),
                                .evaluation = report.order.evaluation,
                                .time_step = report.order.time_step,
                                .reason = {}};
    state.commanded = report.commanded;
    state.reported = report.feedback.position;
    state.measured = report.feedback.measured;
    state.feet_down = report.feedback.feet_down;
    state.command_to_line_nanoseconds =
        static_cast<std::uint64_t>(std::max<std::int64_t>(report.command_to_line.count(), 0));
    state.line_to_state_nanoseconds =
        static_cast<std::uint64_t>(std::max<std::int64_t>(report.line_to_state.count(), 0));
    publish(state);
  }
}

void Bridge::look_after_evaluation(Clock::time_point now) {
  if (const auto reason = gate_.overdue(now)) void_evaluation(*reason);
  if (gate_.evaluating() && control_status_.state != RobotState::active) void_evaluation(hindrance());
}

void Bridge::publish(const messaging::ServoState& state) {
  // One that can't be written is one that was lost: whoever waits for it voids the evaluation.
  static_cast<void>(states_->write(state));
  if (options_.on_state) options_.on_state(state);
}

/// Tells whoever runs it; there may be none.
void Bridge::void_evaluation(const std::string& reason) {
  const bool was_going_on = gate_.abandon();
  if (!was_going_on && reason.empty()) return;
  if (gate_.evaluation() == 0) return;
  const messaging::ServoState state{.robot = robot_,
                                    .token = gate_.token(),
                                    .evaluation = gate_.evaluation(),
                                    .time_step = gate_.time_step(),
                                    .outcome = StepOutcome::voided,
                                    .reason = reason};
  publish(state);
  spdlog::debug("evaluation {} of claim {} is void: {}", gate_.evaluation(), gate_.token(), reason);
}

std::vector<messaging::RobotCounter> Bridge::counters() const {
  const auto microseconds = [](std::chrono::microseconds time) { return static_cast<std::uint64_t>(time.count()); };
  const GateCounters& gate = gate_.counters();
  const ControlStatus& control = control_status_;
  std::vector<messaging::RobotCounter> all{{"steps", control.steps},
                                           {"late_steps", control.late_steps},
                                           {"late_moves", control.late_moves},
                                           {"device_errors", control.device_errors},
                                           {"setpoints_clamped", control.clamped},
                                           {"setpoints_slowed", control.slowed},
                                           {"commands_accepted", gate.accepted},
                                           {"commands_under_no_claim", gate.under_no_claim},
                                           {"commands_repeated", gate.repeated},
                                           {"commands_of_void_evaluations", gate.of_void},
                                           {"commands_not_numbers", gate.not_numbers},
                                           {"evaluations_voided", gate.voided},
                                           {"requests_refused", requests_refused_},
                                           {"samples_for_other_robots", other_robots_ + requests_.strays()},
                                           {"samples_malformed", participant_.malformed_samples()}};
  const auto add = [&](const std::string& name, const Histogram& histogram) {
    all.push_back({name + "_microseconds_median", microseconds(histogram.quantile(0.5))});
    all.push_back({name + "_microseconds_percentile_ninety_nine", microseconds(histogram.quantile(0.99))});
    all.push_back({name + "_microseconds_largest", microseconds(histogram.largest())});
  };
  add("command_to_line", control.command_to_line);
  add("line_to_state", control.line_to_state);
  add("jitter", control.jitter);
  return all;
}

void Bridge::publish_status(Clock::time_point now) {
  messaging::RobotStatus status;
  status.robot = robot_;
  status.name = options_.robot;
  status.state = control_status_.state;
  status.stopped = stopped();
  status.reason = stopped() ? file_.state().stop_reason : control_status_.reason;
  status.incarnation = options_.incarnation;
  status.token = claims_.newest_token();
  status.holder = claims_.holder(now);
  status.rate = options_.rate;
  status.driver = options_.driver;
  status.device = control_status_.device;
  status.scheduling = control_status_.scheduling;
  status.host = options_.host;
  status.process = options_.process;
  status.build = options_.build;
  status.dds = participant_.vendor();
  status.heartbeat = last_status_.heartbeat;
  status.counters = last_status_.counters;
  if (status == last_status_ && now < status_due_) return;
  status.counters = counters();
  ++status.heartbeat;
  status_due_ = now + heartbeat_interval;
  last_status_ = std::move(status);
  static_cast<void>(statuses_->write(last_status_));
}

}  // namespace lamprey::robot_bridge
