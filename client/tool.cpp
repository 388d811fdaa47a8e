#include "client/tool.hpp"

#include "client/failure.hpp"
#include "client/help.hpp"
#include "client/json.hpp"
#include "client/option_checks.hpp"
#include "client/storage_failure.hpp"
#include "experiment/problem.hpp"
#include "messaging/program/join_options.hpp"

#include <algorithm>
#include <exception>
#include <optional>

namespace lamprey::client {

namespace {

using Arguments = std::vector<std::string>;

/// Read before anything else is, so that a wrong command line is answered in the form that it asks for.
bool wants_json(const Arguments& arguments) {
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == "--format=json") return true;
    if (arguments[i] == "--format" && i + 1 < arguments.size() && arguments[i + 1] == "json") return true;
  }
  return false;
}

ExitCode report(const Failure& failure, bool json, const output::Console& console) {
  const bool interrupted = failure.exit_code() == exit_interrupted;
  for (const auto& message : failure.messages()) {
    console.err << "lamprey: " << (interrupted ? "" : console.red("error:") + " ") << message << '\n';
  }
  for (const auto& detail : failure.details()) console.err << "  " << detail << '\n';
  console.err.flush();
  if (json) {
    Json error = document("error");
    error["error"] = {{"code", failure.code()}, {"messages", failure.messages()}};
    if (!failure.details().empty()) error["error"]["details"] = failure.details();
    print(console, error);
  }
  return failure.exit_code();
}

const Command& find_command(const std::string& name) {
  const auto all = command_table();
  const auto found = std::ranges::find(all, name, &Command::name);
  if (found != all.end()) return *found;
  if (name.starts_with('-')) throw usage_failure("the command comes first, then its options: lamprey COMMAND " + name);
  std::vector<std::string_view> names;
  for (const auto& command : all) names.push_back(command.name);
  throw usage_failure(unknown_name("command", name, names));
}

/// Unknown options are found before the command line is read: what stands behind one would be taken for an argument.
void check_option_names(const CLI::App& app, const Arguments& arguments) {
  for (const auto& argument : arguments) {
    if (argument == "--") return;
    if (argument.size() < 2 || argument[0] != '-' || (argument[1] >= '0' && argument[1] <= '9')) continue;
    const std::string name = argument.substr(0, argument.find('='));
    if (app.get_option_no_throw(name) != nullptr) continue;
    std::vector<std::string> known;
    for (const auto* option : app.get_options()) {
      if (!option->get_positional()) known.push_back(option->get_name());
    }
    known.emplace_back("--help");
    throw usage_failure(unknown_name("option", name, {known.begin(), known.end()}));
  }
}

/// CLI11's errors in this tool's words.
[[noreturn]] void translate(const CLI::ParseError& error) {
  std::string message = error.what();
  const auto replace_front = [&](std::string_view front, const std::string& by) {
    if (message.starts_with(front)) message = by + message.substr(front.size());
  };
  replace_front("The following argument was not expected: ", "unexpected argument: ");
  replace_front("The following arguments were not expected: ", "unexpected arguments: ");
  if (const auto colon = message.find(": takes "); colon != std::string::npos) message.erase(colon, 1);
  if (const auto needs = message.find(": 1 required"); needs != std::string::npos)
    message = message.substr(0, needs) + " needs a value";
  throw usage_failure(message);
}

void parse(CLI::App& app, const Arguments& arguments) {
  check_option_names(app, arguments);
  try {
    app.parse(Arguments(arguments.rbegin(), arguments.rend()));  // CLI11 takes them from the back
  } catch (const messaging::program::BadConfiguration& error) {
    throw error.input();
  } catch (const CLI::ParseError& error) {
    translate(error);
  }
}

Format format_named(const std::string& name) {
  if (name == "json") return Format::json;
  if (name == "html") return Format::html;
  return name == "csv" ? Format::csv : Format::table;
}

bool asks_for_help(const Arguments& arguments) {
  const auto end = std::ranges::find(arguments, "--");
  return std::any_of(arguments.begin(), end,
                     [](const auto& argument) { return argument == "--help" || argument == "-h"; });
}

ExitCode run_command(const Command& command, const Arguments& arguments, const output::Console& console,
                     const Environment& environment) {
  CLI::App app(std::string(command.summary), "lamprey " + std::string(command.name));
  app.set_help_flag();
  const Action action = command.declare(app);
  std::string format(command.formats.front());
  const std::vector<std::string> formats(command.formats.begin(), command.formats.end());
  app.add_option("--format", format, "How to answer")
      ->type_name(output::joined(formats, "|"))
      ->check(one_of(command.formats))
      ->default_str(format);
  if (asks_for_help(arguments)) {
    print_help(console, command, app);
    return exit_ok;
  }
  try {
    parse(app, arguments);
  } catch (const Failure& failure) {
    throw usage_failure(std::string(command.name) + ": " + failure.what() + " (see lamprey " +
                        std::string(command.name) + " --help)");
  }
  return action({console, environment, format_named(format)});
}

ExitCode dispatch(const Arguments& arguments, const output::Console& console, const Environment& environment) {
  if (arguments.empty()) {
    print_overview(console);
    return exit_usage;
  }
  const std::string& first = arguments.front();
  const Arguments rest(arguments.begin() + 1, arguments.end());
  if (first == "--version" || first == "-V") {
    print_version(console);
    return exit_ok;
  }
  if (first == "--help" || first == "-h" || first == "help") {
    if (first == "help" && !rest.empty())
      return run_command(find_command(rest.front()), {"--help"}, console, environment);
    print_overview(console);
    return exit_ok;
  }
  return run_command(find_command(first), rest, console, environment);
}

Failure invalid_input(const experiment::InvalidInput& invalid) {
  std::vector<std::string> messages;
  for (const auto& problem : invalid.problems()) messages.push_back(problem.text());
  return {exit_usage, "invalid_input", std::move(messages)};
}

}  // namespace

ExitCode run_tool(const std::vector<std::string>& arguments, const output::Console& console,
                  const Environment& environment) {
  const bool json = wants_json(arguments);
  std::optional<Failure> failure;
  try {
    const ExitCode code = dispatch(arguments, console, environment);
    console.out.flush();
    if (console.out.good()) return code;
    failure = Failure(exit_failure, "output", "standard output cannot be written");
  } catch (const Failure& caught) {
    failure = caught;
  } catch (const experiment::InvalidInput& invalid) {
    failure = invalid_input(invalid);
  } catch (const storage::StorageError& error) {
    failure = storage_failure(error);
  } catch (const std::exception& error) {
    failure = Failure(exit_failure, "internal", error.what());
  }
  return report(*failure, json, console);
}

}  // namespace lamprey::client
