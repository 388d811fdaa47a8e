#pragma once

#include "client/output/console.hpp"

#include <string>
#include <vector>

/// How rows of JSON literals look to people and to spreadsheets.
namespace lamprey::client::output {

/// Text without its quotes, null as nothing; other literals as they are.
std::string plain(const std::string& literal);

/// The same with numbers rounded for reading.
std::string readable(const std::string& literal);

/// A line of comma-separated values (RFC 4180, but the line ends in \n): quoted only where needed.
std::string csv_line(const std::vector<std::string>& values);

struct ResultRows {
  const std::vector<std::string>& columns;
  const std::vector<std::vector<std::string>>& rows;
};

/// Prints the columns `shown` (positions in `columns`), numbers right-aligned. While that is wider than the console,
/// the columns named in `give_way` are left out, the first one first; the answer names those that were.
std::vector<std::string> print_results(const Console& console, const ResultRows& results,
                                       std::vector<std::size_t> shown, const std::vector<std::string>& give_way);

}  // namespace lamprey::client::output
