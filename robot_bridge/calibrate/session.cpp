#include "robot_bridge/calibrate/session.hpp"

#include "experiment/problem.hpp"
#include "robot_bridge/calibration_fields.hpp"
#include "science/problems/controlled_quadruped.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

namespace lamprey::robot_bridge::calibrate {
namespace {

/// Of the whole range in so many seconds: a person can follow, and let go of the key in time.
constexpr double seconds_for_whole_range = 5;
constexpr std::chrono::milliseconds look_interval{50};
constexpr std::chrono::milliseconds retry_interval{500};

constexpr std::string_view help = R"(  1500, +10, -10     move this joint there, slowly
  stand              the leg stands here (unit 10)
  units U            the leg is at U units here; 'stand' first (how far a unit is, and which way)
  minimum, maximum   the range ends here; nothing beyond is ever sent
  slew N             the fastest that it is ever asked to move, per second
  next, back, joint NAME|NUMBER
  free, hold         let all servos go, to move them by hand; hold them again
  show               all joints
  save, quit         write the file and end; end without
)";

std::optional<double> number(const std::string& text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_relative(const std::string& text) {
  return text.starts_with('+') || text.starts_with('-');
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

}  // namespace

Calibration first_draft(DeviceFamily family, std::int32_t baud) {
  const DeviceNumbers numbers = device_numbers(family);
  const double span = numbers.highest - numbers.lowest;
  Calibration calibration;
  calibration.family = family;
  calibration.baud = baud;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    Joint& joint = calibration.joints[servo];
    joint.channel = static_cast<std::int32_t>(servo) + (family == DeviceFamily::dynamixel ? 1 : 0);
    joint.centre = std::round(numbers.lowest + span / 2);
    joint.minimum = joint.centre - std::round(span / 10);
    joint.maximum = joint.centre + std::round(span / 10);
    joint.per_unit = std::round(span / 100);
    joint.slew_rate = std::round(span / 2);
  }
  return calibration;
}

Calibration whole_range(const Calibration& calibration) {
  const DeviceNumbers numbers = device_numbers(calibration.family);
  Calibration range = calibration;
  const double per_unit = (numbers.highest - numbers.lowest) / (highest_position - lowest_position);
  for (auto& joint : range.joints) {
    joint = {.channel = joint.channel,
             .minimum = numbers.lowest,
             .centre = numbers.lowest + per_unit * (science::robots::standing_position - lowest_position),
             .maximum = numbers.highest,
             .per_unit = per_unit,
             .direction = 1,
             .offset = 0,
             .slew_rate = (numbers.highest - numbers.lowest) / seconds_for_whole_range};
  }
  range.feet = {};
  range.contact_board.reset();
  return range;
}

Session::Session(Driver& driver, const Calibration& begin, std::istream& in, std::ostream& out,
                 std::function<bool()> interrupted)
    : driver_(driver),
      calibration_(begin),
      range_(whole_range(begin)),
      in_(in),
      out_(out),
      interrupted_(std::move(interrupted)) {}

Ending Session::run() {
  out_ << driver_.description() << '\n';
  if (!turn_on()) return Ending::quit;
  out_ << help;
  prompt();
  for (std::string line; !interrupted_() && std::getline(in_, line); prompt()) {
    const auto words = words_of(line);
    if (!words.empty() && !survives(words)) break;
  }
  out_ << '\n';
  try {
    driver_.release();
  } catch (const DriverError& error) {
    out_ << error.what() << "; THE SERVOS MAY STILL BE ON\n";
  }
  return ending_;
}

/// A device that fails costs nothing that has been measured: it is looked for again until it is back.
bool Session::survives(const Words& words) {
  try {
    return obey(words);
  } catch (const DriverError& error) {
    out_ << error.what() << "; the servos count as free, 'hold' them to go on\n";
    on_ = false;
  }
  while (!interrupted_()) {
    try {
      driver_.connect();
      driver_.release();
      return true;
    } catch (const DriverError&) {
      std::this_thread::sleep_for(retry_interval);
    }
  }
  return true;
}

/// Servos stay where they are, or go where somebody agrees that they may.
bool Session::turn_on() {
  auto start = driver_.present_position();
  if (!start) {
    out_ << "This device can't tell where its servos are: they will jump to where the legs stand by the calibration.\n"
            "Lift the robot off the ground, keep your hands away, and type yes: "
         << std::flush;
    std::string answer;
    if (!std::getline(in_, answer) || words_of(answer) != Words{"yes"}) return false;
    start.emplace();
    for (std::size_t servo = 0; servo < servos; ++servo) {
      const Joint& joint = calibration_.joints[servo];
      (*start)[servo] = range_.joints[servo].to_units(joint.to_device(science::robots::standing_position));
    }
  }
  driver_.enable(*start);
  pose_ = *start;
  on_ = true;
  return true;
}

void Session::prompt() {
  try {
    present();
  } catch (const DriverError& error) {
    out_ << error.what() << '\n';
  }
  out_ << chosen_ + 1 << " " << science::problems::servo_names()[chosen_] << " at " << number_text(device_now())
       << (on_ ? "> " : " (free)> ") << std::flush;
}

bool Session::obey(const Words& words) {
  const std::string& verb = words.front();
  if (const auto value = number(verb)) {
    go_to(is_relative(verb) ? device_now() + *value : *value);
  } else if (verb == "stand" || verb == "minimum" || verb == "maximum") {
    mark(verb);
  } else if (verb == "units") {
    mark_units(words);
  } else if (verb == "slew") {
    set_slew_rate(words);
  } else if (verb == "next" || verb == "back") {
    chosen_ = (chosen_ + (verb == "next" ? 1 : servos - 1)) % servos;
  } else if (verb == "joint" && words.size() > 1) {
    std::string name = words[1];
    for (std::size_t word = 2; word < words.size(); ++word) name += " " + words[word];
    choose(name);
  } else if (verb == "free") {
    let_go();
  } else if (verb == "hold") {
    hold_again();
  } else if (verb == "show") {
    show();
  } else if (verb == "save" && !can_be_saved()) {
    return true;
  } else if (verb == "save" || verb == "quit") {
    ending_ = verb == "save" ? Ending::save : Ending::quit;
    return false;
  } else {
    out_ << "'" << verb << "' is none of these:\n" << help;
  }
  return true;
}

bool Session::can_be_saved() {
  try {
    parse_calibration(to_yaml(calibration_), "this calibration");
    return true;
  } catch (const experiment::InvalidInput& error) {
    out_ << error.what() << '\n';
    return false;
  }
}

void Session::mark(const std::string& what) {
  present();
  const double device = std::round(device_now());
  if (what == "stand") {
    joint().centre = device;
    joint().offset = 0;
  } else {
    (what == "minimum" ? joint().minimum : joint().maximum) = device;
  }
  out_ << what << " is " << number_text(device) << '\n';
}

void Session::mark_units(const Words& words) {
  const auto units = words.size() == 2 ? number(words[1]) : std::nullopt;
  constexpr double standing = science::robots::standing_position;
  if (!units || *units < lowest_position || *units > highest_position || *units == standing) {
    out_ << "units takes a number in 0..30 but 10\n";
    return;
  }
  present();
  const double moved = device_now() - joint().centre - joint().offset;
  const double per_unit = moved / (*units - standing);
  if (std::abs(per_unit) < 1) {
    out_ << "that is only " << number_text(moved)
         << " from where the leg stands: move it further, or mark 'stand' first\n";
    return;
  }
  joint().per_unit = std::round(std::abs(per_unit) * 100) / 100;
  joint().direction = per_unit > 0 ? 1 : -1;
  out_ << "a unit is " << number_text(joint().per_unit) << (joint().direction > 0 ? "" : ", the other way round")
       << '\n';
}

void Session::set_slew_rate(const Words& words) {
  const auto rate = words.size() == 2 ? number(words[1]) : std::nullopt;
  if (!rate || *rate <= 0) {
    out_ << "slew takes a number above 0\n";
    return;
  }
  joint().slew_rate = *rate;
}

void Session::choose(const std::string& wanted) {
  const auto names = science::problems::servo_names();
  const auto given = number(wanted);
  for (std::size_t servo = 0; servo < servos; ++servo) {
    if (names[servo] != wanted && (!given || *given != static_cast<double>(servo + 1))) continue;
    chosen_ = servo;
    return;
  }
  out_ << "'" << wanted << "' is no joint; they are";
  for (std::size_t servo = 0; servo < servos; ++servo)
    out_ << (servo == 0 ? " " : ", ") << servo + 1 << " " << names[servo];
  out_ << '\n';
}

void Session::go_to(double device) {
  const Joint& limits = range_.joints[chosen_];
  if (device < limits.minimum || device > limits.maximum) {
    out_ << number_text(device) << " is not in " << number_text(limits.minimum) << ".." << number_text(limits.maximum)
         << '\n';
    return;
  }
  if (!on_) {
    out_ << "the servos are free: 'hold' them first\n";
    return;
  }
  const double seconds = std::abs(device - device_now()) / limits.slew_rate;
  pose_[chosen_] = limits.to_units(device);
  const std::chrono::microseconds duration(static_cast<std::int64_t>(seconds * 1e6) + 1000);
  driver_.move(pose_, duration);
  const auto until = std::chrono::steady_clock::now() + duration;
  while (std::chrono::steady_clock::now() < until) {
    if (interrupted_()) return driver_.hold();
    std::this_thread::sleep_for(look_interval);
    driver_.read();
  }
}

void Session::let_go() {
  driver_.release();
  on_ = false;
  if (!driver_.present_position()) out_ << "this device can't tell where a servo is that is moved by hand\n";
}

void Session::hold_again() {
  if (on_) return;
  if (!turn_on()) out_ << "the servos stay free\n";
}

/// Servos that are free may have been moved by hand. Those that are on are where they were sent: what a device measures
/// then includes how far the leg sags.
void Session::present() {
  if (!on_) pose_ = driver_.present_position().value_or(pose_);
}

double Session::device_now() const {
  return range_.joints[chosen_].to_device(pose_[chosen_]);
}

void Session::show() {
  out_ << to_yaml(calibration_);
}

}  // namespace lamprey::robot_bridge::calibrate
