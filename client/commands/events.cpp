#include "client/views/events.hpp"

#include "client/commands/commands.hpp"
#include "client/follow.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace lamprey::client::commands {

namespace {

struct Options {
  std::string sweep;
  bool follow = false;
  std::optional<std::uint64_t> after;
  std::uint32_t limit = 20;
  ConnectionOptions connection;
};

/// Writes events as they come: a line each, or documents of those that are new.
class EventsOutput {
 public:
  EventsOutput(const Context& context, bool follow) : context_(context), follow_(follow) {}

  void add(const idl::EventsReply& reply) {
    for (const auto& event : reply.events()) {
      if (context_.format == Format::json) {
        events_.push_back(views::event_json(event));
      } else {
        context_.console.out << views::event_line(context_.console, event) << '\n';
      }
    }
    any_ = any_ || reply.events_size() > 0;
    if (follow_ && !events_.empty()) {
      print_line(context_.console, document_of_events());
      events_ = Json::array();
    }
    context_.console.out.flush();
  }

  void finish() {
    if (follow_) return;
    if (context_.format == Format::json) return print(context_.console, document_of_events());
    if (!any_) context_.console.out << "No events.\n";
  }

 private:
  Json document_of_events() const {
    Json json = document("events");
    json["events"] = events_;
    return json;
  }

  const Context& context_;
  bool follow_;
  bool any_ = false;
  Json events_ = Json::array();
};

ExitCode events(const Options& options, const Context& context) {
  constexpr std::chrono::milliseconds pause{500};
  CoordinatorConnection connection(context.environment, options.connection);
  EventsOutput output(context, options.follow);
  std::uint64_t after = options.after.value_or(0);
  std::uint64_t wanted = options.limit == 0 ? std::numeric_limits<std::uint32_t>::max() : options.limit;
  const auto ask = [&] {
    idl::Request request;
    auto& question = *request.mutable_events();
    question.set_sweep(options.sweep);
    question.set_after(after);
    // While following all new ones are wanted; the limit is for those that there were before.
    const bool limited = wanted < std::numeric_limits<std::uint32_t>::max();
    question.set_limit(limited ? static_cast<std::uint32_t>(wanted) : 0);
    return request;
  };
  const bool all_pages = options.after.has_value();
  const auto take = [&](const idl::Reply& reply) -> std::optional<Clock::duration> {
    output.add(reply.events());
    const auto count = static_cast<std::uint64_t>(reply.events().events_size());
    for (const auto& event : reply.events().events()) after = std::max(after, event.event());
    if (options.follow) {
      wanted = std::numeric_limits<std::uint32_t>::max();
      return count > 0 ? Clock::duration{} : Clock::duration{pause};
    }
    wanted -= std::min(count, wanted);
    if (!all_pages || count == 0 || wanted == 0) return std::nullopt;
    return Clock::duration{};
  };
  try {
    follow(connection, {.ask = ask, .take = take});
  } catch (const Failure& failure) {
    // Following ends in no other way.
    if (!options.follow || failure.exit_code() != exit_interrupted) throw;
  }
  output.finish();
  return exit_ok;
}

}  // namespace

Action declare_events(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.description(
      "Shows what has happened, oldest first: workers that came and went, leases that were lost, jobs that were "
      "quarantined, divergences, and what people wished. Times are universal (UTC).");
  app.add_option("SWEEP", options->sweep, "Only events of this sweep, by name or id");
  app.add_flag("--follow", options->follow, "Show new ones as they come, until Ctrl-C");
  app.add_option("--after", options->after, "Only events with higher numbers (see --format json), all of them")
      ->type_name("N")
      ->check(whole_number(0, std::numeric_limits<std::uint64_t>::max()));
  auto* limit =
      app.add_option("--limit", options->limit, "The newest N; 0: as many as fit (default: 20; with --after all)")
          ->type_name("N")
          ->check(whole_number(0, 1'000'000));
  add_connection_options(app, options->connection);
  return [options, limit](const Context& context) {
    if (options->after && limit->count() == 0) options->limit = 0;
    return events(*options, context);
  };
}

}  // namespace lamprey::client::commands
