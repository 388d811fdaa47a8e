#pragma once

#include "client/output/console.hpp"
#include "experiment/outcome.hpp"
#include "experiment/parameters.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace lamprey::client {

using Json = nlohmann::ordered_json;

/// An empty document of the command: {"schema": "lamprey/<command>/<version>"}. The number rises when a field changes
/// its meaning or goes; new fields don't raise it.
Json document(std::string_view command, int version = 1);

/// The one document that a command writes, with a line end.
void print(const output::Console& console, const Json& document);

/// One of many documents, on a line of its own, written at once.
void print_line(const output::Console& console, const Json& document);

Json as_json(const experiment::Value& value);
Json as_json(const experiment::Score& score);

/// The parameters that apply, in the order of the registry.
Json as_json(const experiment::Parameters& parameters);

}  // namespace lamprey::client
