#include "client/parameter_settings.hpp"

#include "client/failure.hpp"
#include "client/option_checks.hpp"
#include "experiment/sweep.hpp"
#include "experiment/typed_value.hpp"

#include <string_view>

namespace lamprey::client {

namespace {

std::string parameter_unknown(const std::string& name) {
  std::vector<std::string_view> known;
  for (const auto& parameter : experiment::registry()) known.push_back(parameter.name);
  return unknown_name("parameter", name, known);
}

std::string not_a_setting(const std::string& text) {
  return "'" + experiment::printable(text) + "' is not of the form PARAMETER=VALUE";
}

[[noreturn]] void refuse(std::vector<std::string> problems) {
  throw Failure(exit_usage, "invalid_input", std::move(problems));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> split_settings(const std::vector<std::string>& texts) {
  std::vector<std::pair<std::string, std::string>> settings;
  std::vector<std::string> problems;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) {
      problems.push_back(not_a_setting(text));
    } else {
      settings.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
  }
  if (!problems.empty()) refuse(std::move(problems));
  return settings;
}

experiment::Parameters parameters_of_settings(const std::vector<std::pair<std::string, std::string>>& settings) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : settings) texts.push_back(name + "=" + value);
  return parameters_of_settings(texts);
}

experiment::Parameters parameters_of_settings(const std::vector<std::string>& texts) {
  idl::SweepSpecification specification;
  specification.set_name("settings");
  specification.set_replicates(1);
  std::vector<std::string> problems;
  for (const auto& text : texts) {
    const auto equals = text.find('=');
    const std::string name = text.substr(0, equals);
    const auto* parameter = experiment::find_parameter(name);
    if (equals == std::string::npos) {
      problems.push_back(not_a_setting(text));
    } else if (parameter == nullptr) {
      problems.push_back(parameter_unknown(name));
    } else {
      auto* base = specification.add_base();
      base->set_parameter(name);
      *base->mutable_value() = experiment::value_of_text(parameter->kind, text.substr(equals + 1));
    }
  }
  for (const auto& problem : experiment::validate(specification)) {
    const auto& field = problem.field;
    problems.push_back((field.starts_with("base.") ? field.substr(5) : field) + ": " + problem.message);
  }
  if (!problems.empty()) refuse(std::move(problems));
  return experiment::SweepGrid(specification).job(0).parameters;
}

}  // namespace lamprey::client
