#pragma once

#include "experiment/outcome.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::storage {

/// The column job.trace: `[[cycle,stability,distance,fuel,total],…]` without white space, `[]` if nothing was accepted.
/// Each number in the shortest form that reads back to the same one (std::to_chars), so that there is exactly one text
/// for a trace. The scores must be finite. Replaces what `text` holds and keeps its memory.
void write_trace(std::span<const experiment::AcceptedChange> trace, std::string& text);

/// The inverse; nothing if the text is not of that form. Accepts other spellings of the numbers: compare with what
/// write_trace makes of the answer to find them.
std::optional<std::vector<experiment::AcceptedChange>> read_trace(std::string_view text);

/// The column job.measures: `[["name",index,value],…]` in the same way. Names that no measure may have
/// (experiment::measures_fault) must not be among them.
void write_measures(std::span<const experiment::Measure> measures, std::string& text);

/// The inverse; nothing if the text is not of that form. Neither order nor names nor spellings of numbers are checked.
std::optional<std::vector<experiment::Measure>> read_measures(std::string_view text);

/// The shortest text that reads back to the same double.
std::string shortest_text(double value);

}  // namespace lamprey::storage
