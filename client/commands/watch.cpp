#include "client/commands/commands.hpp"
#include "client/follow.hpp"
#include "client/json.hpp"
#include "client/output/formatting.hpp"
#include "client/output/live_screen.hpp"
#include "client/sweep_summary.hpp"
#include "client/sweep_watch.hpp"
#include "client/watch_state.hpp"

#include <chrono>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  bool once = false;
  ConnectionOptions connection;
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::int64_t unix_milliseconds() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
}

/// Asks for sweeps and workers, then for events, then pauses; shows what has changed in the form that is wanted.
class Watch {
 public:
  Watch(const Options& options, const Context& context, CoordinatorConnection& connection)
      : options_(options),
        context_(context),
        connection_(connection),
        samples_(connection.participant().reader<messaging::SweepProgress>(connection.signal())),
        screen_(context.console) {}

  ExitCode run() {
    try {
      follow(connection_, {.ask = [this] { return question(); },
                           .take = [this](const idl::Reply& reply) { return take(reply); },
                           .meanwhile = [this](auto, Clock::duration silence) { meanwhile(silence); }});
    } catch (const Failure& failure) {
      // This is how it is meant to end.
      if (!state_.has_status() || failure.exit_code() != exit_interrupted) throw;
      return exit_ok;
    }
    if (options_.once) show_once();
    return the_sweep() == nullptr || !has_ended(the_sweep()->state())
               ? exit_ok
               : exit_code_of(progress_of(*the_sweep(), state_.status().workers_size()));
  }

 private:
  idl::Request question() {
    idl::Request request;
    if (!events_next_) {
      request.mutable_status()->set_sweep(options_.sweep);
    } else {
      request.mutable_events()->set_sweep(options_.sweep);
      request.mutable_events()->set_after(state_.newest_event());
      if (state_.newest_event() == 0) request.mutable_events()->set_limit(WatchState::most_events);
    }
    return request;
  }

  std::optional<Clock::duration> take(const idl::Reply& reply) {
    constexpr std::chrono::seconds pause{1};
    if (!events_next_) {
      state_.take(reply.status());
      events_next_ = true;
      return Clock::duration{};
    }
    state_.take(reply.events());
    events_next_ = false;
    changed_ = true;
    if (options_.once) return std::nullopt;
    const bool over = the_sweep() != nullptr && has_ended(the_sweep()->state());
    if (!over) return pause;
    show("");
    return std::nullopt;
  }

  void meanwhile(Clock::duration silence) {
    for (const auto& sample : samples_->take()) {
      if (sample.origin.database == connection_.client().answered_by().database) {
        changed_ = state_.take(sample) || changed_;
      }
    }
    // Until events have been asked for the first picture would lack them.
    if (options_.once || !state_.has_status() || (events_next_ && !shown_)) return;
    constexpr std::chrono::seconds noticeable{5};
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(silence);
    const std::string note = seconds < noticeable ? ""
                                                  : "no word from the coordinator for " +
                                                        output::duration(static_cast<double>(seconds.count()));
    if (changed_ || note != note_) show(note);
  }

  void show(const std::string& note) {
    const auto& console = context_.console;
    if (context_.format == Format::json) {
      auto json = state_.json();
      if (changed_ && json != last_) print_line(console, json);
      last_ = std::move(json);
    } else if (console.out_is_terminal) {
      const auto size = output::terminal_size();
      screen_.draw(lines_of(state_.frame(console, note, size.rows)), size);
    } else {
      for (const auto& line : state_.new_lines(console, unix_milliseconds())) console.out << line << '\n';
      if (note != note_ && note_.empty()) console.out << note << '\n';
      console.out.flush();
    }
    note_ = note;
    changed_ = false;
    shown_ = true;
  }

  void show_once() {
    if (context_.format == Format::json) return print(context_.console, state_.json());
    context_.console.out << state_.frame(context_.console, "", context_.console.rows);
  }

  /// The one that is watched, if it is one.
  const idl::SweepStatus* the_sweep() const {
    const auto& sweeps = state_.status().sweeps();
    return options_.sweep.empty() || sweeps.empty() ? nullptr : &sweeps[0];
  }

  const Options& options_;
  const Context& context_;
  CoordinatorConnection& connection_;
  std::unique_ptr<messaging::Reader<messaging::SweepProgress>> samples_;
  output::LiveScreen screen_;
  WatchState state_;
  bool events_next_ = false;
  bool changed_ = false;
  bool shown_ = false;
  std::string note_;
  Json last_;
};

ExitCode watch(const Options& options, const Context& context) {
  CoordinatorConnection connection(context.environment, options.connection);
  return Watch(options, context, connection).run();
}

}  // namespace

Action declare_watch(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Shows sweeps, workers and the last events, and keeps the picture fresh until Ctrl-C; that of one sweep until "
      "the "
      "sweep has ended. Where the output is no terminal, a line is written for each change; with --format json a "
      "document a line.");
  app.add_option("SWEEP", options->sweep, "Only this sweep, by name or id");
  app.add_flag("--once", options->once, "Show it once");
  add_connection_options(app, options->connection);
  return [options](const Context& context) { return watch(*options, context); };
}

}  // namespace lamprey::client::commands
