#pragma once

#include "experiment/parameters.hpp"

#include <string>
#include <utility>
#include <vector>

namespace lamprey::client {

/// "name=value" in two. Throws Failure (invalid_input) naming every text that isn't of that form.
std::vector<std::pair<std::string, std::string>> split_settings(const std::vector<std::string>& texts);

/// All parameters, those of the "name=value" texts set; they go through the same validator as a sweep file's base.
/// Throws Failure (invalid_input), a message for everything that is wrong.
experiment::Parameters parameters_of_settings(const std::vector<std::string>& texts);

/// The same of settings that were split.
experiment::Parameters parameters_of_settings(const std::vector<std::pair<std::string, std::string>>& settings);

}  // namespace lamprey::client
