#pragma once

#include "experiment/field_reader.hpp"

#include <optional>
#include <string>

namespace lamprey::experiment {

/// Reads the field `environment` of a sweep file, a list of changes such as {at: 500, required_distance: 25}, into the
/// text of a schedule; nothing after it has been noted what is wrong with it.
std::optional<std::string> read_environment(const YamlNode& node, FieldReader& fields);

}  // namespace lamprey::experiment
