#pragma once

#include "experiment/field_reader.hpp"

#include <span>
#include <string_view>

namespace lamprey::experiment {

/// The fields of a sweep file that say how it is run: priority, stop_when, needs and so on.
std::span<const std::string_view> execution_fields();

/// Reads one of them, whose place has been noted. What has the wrong shape is refused; what is out of range is left for
/// the validator to find, wherever that is possible.
void read_execution_field(const YamlEntry& entry, FieldReader& fields, idl::Execution& execution);

}  // namespace lamprey::experiment
