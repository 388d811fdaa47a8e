#include "robot_bridge/emulators/serve.hpp"

#include "messaging/program/exit_codes.hpp"
#include "robot_bridge/emulators/control.hpp"
#include "robot_bridge/emulators/control_socket.hpp"
#include "robot_bridge/emulators/pseudo_terminal.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <ctime>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <sched.h>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <system_error>

namespace lamprey::robot_bridge::emulators {
namespace {

namespace program = messaging::program;

/// What an operating system's driver would hold back for the line; a writer has to wait for more room.
constexpr std::size_t most_octets_waiting = 4096;

Time now() {
  return std::chrono::steady_clock::now().time_since_epoch();
}

/// SIGTERM and SIGINT as something to wait for.
Descriptor stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  if (::sigprocmask(SIG_BLOCK, &signals, nullptr) != 0)
    throw std::system_error(errno, std::generic_category(), "signals");
  Descriptor descriptor(::signalfd(-1, &signals, SFD_CLOEXEC));
  if (descriptor.get() < 0) throw std::system_error(errno, std::generic_category(), "signals");
  return descriptor;
}

std::ofstream open_for_writing(const std::string& option, const std::string& path) {
  std::ofstream file;
  if (path.empty()) return file;
  file.open(path);
  if (!file) throw std::invalid_argument(option + ": '" + path + "' can't be written");
  return file;
}

/// No other program keeps a real device from its work, and a servo that starts late is read before it has arrived.
/// Before the user's own timely threads, where the system allows it; at the mercy of its load else.
void be_as_timely_as_a_device() {
  // Timers at their own precision: by default the kernel is free to be 50 µs late, five octets at 1 Mbaud.
  ::prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  constexpr int priority = 60;
  const sched_param wanted{.sched_priority = priority};
  if (::sched_setscheduler(0, SCHED_FIFO, &wanted) != 0) {
    std::cerr << "this emulator is as timely as the machine's load allows: SCHED_FIFO is refused: "
              << std::strerror(errno) << '\n';
    return;
  }
  ::mlockall(MCL_CURRENT | MCL_FUTURE);
}

class Station {
 public:
  Station(const ProgramOptions& options, const std::string& device, const MakeController& make)
      : options_(options),
        stop_(stop_signals()),
        log_(open_for_writing("--log", options.log)),
        report_file_(open_for_writing("--report", options.report)),
        recorder_(options.log.empty() ? nullptr : &log_),
        controller_(make(recorder_, now())),
        line_(*controller_, options.baud, options.seed),
        actions_{[this] { unplug(); }, [this] { replug(); }, [this] { return report(); }} {
    if (!options.control.empty()) control_.emplace(options.control);
    terminal_.emplace(options.link, options.baud);
    std::cout << device << " emulator at " << options.link << " (" << terminal_->slave_name() << "), " << options.baud
              << " baud" << std::endl;
  }

  void run() {
    while (true) {
      pass_octets();
      const auto watched = wait();
      if (watched.front().revents != 0) break;
      if (terminal_) take_octets();
      if (control_) {
        control_->serve(watched, [this](std::string_view text) { return control(text, line_, actions_, now()); });
      }
    }
    write_report();
    log_.flush();
  }

 private:
  void pass_octets() {
    const auto octets = line_.run(now());
    if (!terminal_ || octets.empty()) return;
    line_.overrun(octets.size() - terminal_->write(octets));
  }

  void take_octets() {
    std::array<std::uint8_t, most_octets_waiting> buffer{};
    if (line_.waiting() >= buffer.size()) return;
    const auto octets = terminal_->read(std::span(buffer).first(buffer.size() - line_.waiting()));
    if (octets.empty()) return;
    if (terminal_->at_another_speed()) {
      line_.sent_at_another_speed(octets.size());
    } else {
      line_.sent(octets, now());
    }
  }

  /// Waits for octets, control lines, the next moment of the line, or the end. The first of what it returns is the end.
  std::vector<pollfd> wait() {
    std::vector<pollfd> watched{{stop_.get(), POLLIN, 0}};
    if (terminal_ && line_.waiting() < most_octets_waiting) watched.push_back({terminal_->descriptor(), POLLIN, 0});
    if (control_) control_->watch(watched);
    timespec timeout{};
    const auto next = line_.next();
    if (next) {
      const auto left = std::max(*next - now(), Time::zero());
      timeout.tv_sec = std::chrono::duration_cast<std::chrono::seconds>(left).count();
      timeout.tv_nsec = (left % std::chrono::seconds{1}).count();
    }
    const int ready = ::ppoll(watched.data(), watched.size(), next ? &timeout : nullptr, nullptr);
    if (ready < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "ppoll");
    return watched;
  }

  void unplug() {
    if (!terminal_) throw std::runtime_error("is not plugged in");
    terminal_.reset();
    line_.cut();
  }

  void replug() {
    if (terminal_) throw std::runtime_error("is plugged in");
    terminal_.emplace(options_.link, options_.baud);
  }

  nlohmann::json figures() const {
    auto figures = recorder_.report();
    figures.update(line_.report());
    return figures;
  }

  std::string report() {
    write_report();
    log_.flush();
    return figures().dump();
  }

  void write_report() {
    if (options_.report.empty()) return;
    report_file_.close();
    report_file_.open(options_.report, std::ios::trunc);
    report_file_ << figures().dump(2) << std::endl;
    if (!report_file_) throw std::runtime_error("the report '" + options_.report + "' can't be written");
  }

  const ProgramOptions& options_;
  Descriptor stop_;
  std::ofstream log_;
  std::ofstream report_file_;
  Recorder recorder_;
  std::unique_ptr<Controller> controller_;
  Line line_;
  ProgramActions actions_;
  std::optional<ControlSocket> control_;
  std::optional<PseudoTerminal> terminal_;
};

}  // namespace

void add_program_options(CLI::App& app, ProgramOptions& options) {
  constexpr unsigned slowest = 1200;
  constexpr unsigned fastest = 4'500'000;
  app.set_config("--configuration", "", "A file with options, a line NAME = VALUE each (without the dashes)");
  app.allow_config_extras(CLI::config_extras_mode::error);
  app.add_option("--link", options.link, "Where the device file shall appear")->required()->type_name("PATH");
  app.add_option("--baud", options.baud, "Speed of the line; a user at another speed is not understood")
      ->check(CLI::Range(slowest, fastest))
      ->capture_default_str()
      ->type_name("BAUD");
  app.add_flag("--quadruped", options.quadruped, "The eight servos and four feet of the simulator's quadruped");
  app.add_option("--foot", options.feet, "A foot's contact: INPUT=SERVO<=POSITION or >=; may be given several times")
      ->allow_extra_args(false)
      ->type_name("FOOT");
  app.add_option("--speed", options.speed, "Of servos at most, in units of position per second, or instant")
      ->type_name("SPEED");
  app.add_option("--control", options.control, "A Unix socket for control commands, or - for standard input")
      ->type_name("PATH");
  app.add_option("--report", options.report, "A file for what arrived, as JSON, written at the end and on demand")
      ->type_name("FILE");
  app.add_option("--log", options.log, "A CSV file with every accepted command and its time")->type_name("FILE");
  app.add_option("--seed", options.seed, "Of the noise")->capture_default_str()->type_name("N");
}

double servo_speed(const std::string& speed, double preset) {
  constexpr double slowest = 1;
  constexpr double fastest = 1e6;
  if (speed.empty()) return preset;
  if (speed == "instant") return std::numeric_limits<double>::infinity();
  double value = 0;
  const auto [end, error] = std::from_chars(speed.data(), speed.data() + speed.size(), value);
  if (error != std::errc{} || end != speed.data() + speed.size() || !(value >= slowest && value <= fastest)) {
    throw std::invalid_argument("--speed: '" + speed + "' is not in 1..1000000, or instant");
  }
  return value;
}

int serve(const ProgramOptions& options, const std::string& device, const MakeController& make) {
  be_as_timely_as_a_device();
  // Who asked by standard input may have gone before the answer.
  std::signal(SIGPIPE, SIG_IGN);
  Station(options, device, make).run();
  return program::exit_ok;
}

int run_program(const std::string& name, const std::function<int()>& run) {
  try {
    return run();
  } catch (const std::invalid_argument& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return program::exit_usage;
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << '\n';
    return program::exit_failure;
  }
}

}  // namespace lamprey::robot_bridge::emulators
