#pragma once

#include "client/report/claim.hpp"

#include <optional>
#include <string>

/// The rules by which intervals become verdicts. Free functions; any thread.
namespace lamprey::client::report {

constexpr double confidence = 0.95;
/// Within it a difference counts as none, and a total as reached: this share of the expected total.
constexpr double margin_share = 0.05;
/// Of the intervals that equivalence is read from: two one-sided tests at 5 %.
constexpr double equivalence_confidence = 0.90;

using MaybeInterval = std::optional<statistics::Interval>;

/// The whole interval lies above the threshold.
Measured above(std::string judged_on, const MaybeInterval& interval, double threshold);
/// The whole interval lies below the threshold.
Measured below(std::string judged_on, const MaybeInterval& interval, double threshold);
/// The whole interval lies within ±margin.
Measured within(std::string judged_on, const MaybeInterval& interval, double margin);
/// Something else decides.
Measured judged(std::string judged_on, const MaybeInterval& interval, bool holds);

/// A decisive part without measurements yet, which is "not run".
Part part_of(std::string name, std::string expectation, std::string rule, const std::string& sql);

/// The first row that has these values; nothing if none has.
std::optional<std::size_t> find_row(const Rows& rows,
                                    const std::vector<std::pair<std::string_view, std::string_view>>& values);

/// n, mean and mean of squares in the columns `size`, `name` and `name_squared` of a row.
statistics::Sample sample_in(const Rows& rows, std::size_t row, const std::string& name, const std::string& size = "n");

/// "12.3", "-0.0451": at most so many significant digits.
std::string figure(double number, int digits = 4);
/// "12.3 [11.9, 12.7]", rounded so that half the width keeps two digits, but to no more than four; without width the
/// number alone; "-" for none.
std::string figure(const MaybeInterval& interval);

/// A share or a rate times 100.
MaybeInterval in_per_cent(MaybeInterval share);

}  // namespace lamprey::client::report
