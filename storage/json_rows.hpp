#pragma once

#include "storage/results_reader.hpp"
#include "storage/statement.hpp"

#include <string>
#include <string_view>

namespace lamprey::storage {

/// All rows of the statement, each value as a JSON literal: numbers in shortest form, text in quotes, blobs as hex
/// text, null. Infinity, which JSON lacks, is null.
ResultsReader::Table read_table(Statement& statement);

}  // namespace lamprey::storage
