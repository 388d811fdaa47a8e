#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// How numbers, durations and text look to people. Free functions; any thread.
namespace lamprey::client::output {

/// 12345 as "12,345".
std::string with_thousands(std::uint64_t number);

/// The shortest text that reads back to the same double.
std::string shortest(double number);

/// At most six significant digits, without trailing zeros: for tables, where the last digits hide the first.
std::string rounded(double number);

/// "0.4 s", "12 s", "3 min 5 s", "2 h 10 min", "3 d 4 h"; for negative or not finite seconds "?".
std::string duration(double seconds);

/// "612 jobs/s", "2.5 jobs/s"; slow ones as "12 jobs/min" or "3 jobs/h".
std::string rate(double per_second);

/// "2026-01-31 12:00:00", of milliseconds since 1970, in universal time.
std::string date_and_time(std::int64_t unix_milliseconds);

/// "1 job", "12,345 jobs".
std::string counted(std::uint64_t number, std::string_view one, std::string_view several);

/// Columns that UTF-8 text takes on a terminal; every character counts as one (no wide ones are printed here), styles
/// (ESC [ … m) as none.
std::size_t width(std::string_view text);

/// The text cut to at most `columns` columns, ending in `ellipsis` if anything was cut; a style that it had begun ends
/// there.
std::string cut(std::string_view text, std::size_t columns, std::string_view ellipsis);

/// The text with a question mark for each control character, which a terminal would act on: for text from outside.
std::string without_controls(std::string_view text);

/// The words of the text in lines of at most `columns` columns (longer words stand alone).
std::vector<std::string> wrap(std::string_view text, std::size_t columns);

/// "a, b, c"; where that is wider than `columns` the middle is left out: "25, 26, …, 100".
std::string list_in_short(const std::vector<std::string>& items, std::size_t columns, std::string_view ellipsis);

/// The items with `separator` between them.
std::string joined(const std::vector<std::string>& items, std::string_view separator);

}  // namespace lamprey::client::output
