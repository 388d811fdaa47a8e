#include "client/help.hpp"

#include "client/output/formatting.hpp"
#include "experiment/identifiers.hpp"
#include "messaging/program/build_info.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace lamprey::client {

namespace {

using Entry = std::pair<std::string, std::string>;

void print_heading(const output::Console& console, std::string_view heading) {
  console.out << '\n' << console.bold(heading) << '\n';
}

/// Names on the left, wrapped texts on the right.
void print_entries(const output::Console& console, const std::vector<Entry>& entries) {
  constexpr std::size_t indent = 2;
  constexpr std::size_t widest_name = 28;
  std::size_t name_width = 0;
  for (const auto& [name, text] : entries) {
    if (output::width(name) <= widest_name) name_width = std::max(name_width, output::width(name));
  }
  const std::size_t text_column = indent + name_width + 2;
  for (const auto& [name, text] : entries) {
    console.out << std::string(indent, ' ') << name;
    std::size_t column = indent + output::width(name);
    for (const auto& line : output::wrap(text, console.columns - std::min(text_column, console.columns / 2))) {
      if (column + 2 > text_column) {
        console.out << '\n';
        column = 0;
      }
      console.out << std::string(text_column - column, ' ') << line;
      column = text_column;
    }
    console.out << '\n';
  }
}

std::string option_name(const CLI::Option& option) {
  std::string name = option.get_name(false, true);
  for (std::size_t comma = 0; (comma = name.find(',', comma)) != std::string::npos; comma += 2)
    name.insert(comma + 1, " ");
  // CLI11 appends what validators say of themselves; the description says it better.
  const std::string type = option.get_type_name().substr(0, option.get_type_name().find(':'));
  return option.get_type_size() == 0 || type.empty() ? name : name + " " + type;
}

std::string option_text(const CLI::Option& option) {
  std::string text = option.get_description();
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  if (!option.get_default_str().empty()) text += " (default: " + option.get_default_str() + ")";
  if (option.get_required() && !option.get_positional()) text += " (required)";
  if (!option.get_envname().empty()) text += " [" + option.get_envname() + "]";
  return text;
}

std::string argument_name(const CLI::Option& option) {
  std::string name = option.get_single_name();
  if (option.get_items_expected_max() > 1) name += "...";
  return name;
}

}  // namespace

void print_overview(const output::Console& console) {
  console.out << "Lamprey runs experiments in the evolution of walking robots, on one machine or many.\n\n"
              << console.bold("Usage") << "\n  lamprey COMMAND [ARGUMENTS] [OPTIONS]\n";
  std::size_t name_width = 0;
  for (const auto& command : command_table()) name_width = std::max(name_width, command.name.size());
  std::string_view group;
  for (const auto& command : command_table()) {
    if (command.group != group) print_heading(console, command.group);
    group = command.group;
    console.out << "  " << command.name << std::string(name_width - command.name.size() + 2, ' ') << command.summary
                << '\n';
  }
  print_heading(console, "Examples");
  console.out << "  lamprey plan sweeps/quickstart.yaml\n"
                 "  lamprey run sweeps/quickstart.yaml --database results.db\n"
                 "  lamprey results quickstart --database results.db\n"
                 "\n'lamprey COMMAND --help' explains a command. Every command can answer in JSON: --format json.\n";
}

void print_help(const output::Console& console, const Command& command, const CLI::App& app) {
  std::vector<Entry> arguments;
  std::vector<Entry> options;
  std::string usage = "lamprey " + std::string(command.name);
  for (const auto* option : app.get_options()) {
    if (option->get_positional()) {
      const std::string name = argument_name(*option);
      usage += option->get_required() ? " " + name : " [" + name + "]";
      arguments.emplace_back(name, option_text(*option));
    } else {
      if (option->get_required()) usage += " " + option->get_name() + " " + option->get_type_name();
      options.emplace_back(option_name(*option), option_text(*option));
    }
  }
  options.emplace_back("-h, --help", "Print this help");
  for (const auto& line : output::wrap(app.get_description(), console.columns)) console.out << line << '\n';
  print_heading(console, "Usage");
  console.out << "  " << usage << " [OPTIONS]\n";
  if (!arguments.empty()) {
    print_heading(console, "Arguments");
    print_entries(console, arguments);
  }
  print_heading(console, "Options");
  print_entries(console, options);
  if (!app.get_footer().empty()) console.out << '\n' << app.get_footer() << '\n';
}

void print_version(const output::Console& console) {
  console.out << "lamprey " << messaging::program::build() << '\n'
              << "science version " << experiment::science_version << '\n';
}

}  // namespace lamprey::client
