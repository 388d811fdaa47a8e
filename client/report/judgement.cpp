#include "client/report/judgement.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace lamprey::client::report {

std::string_view to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::does_not_hold:
      return "does not hold";
    case Verdict::not_run:
      break;
  }
  return "not run";
}

Measured judged(std::string judged_on, const MaybeInterval& interval, bool holds) {
  const Verdict verdict = holds ? Verdict::holds : Verdict::does_not_hold;
  return {std::move(judged_on), interval, interval ? verdict : Verdict::not_run};
}

Measured above(std::string judged_on, const MaybeInterval& interval, double threshold) {
  return judged(std::move(judged_on), interval, interval && interval->low > threshold);
}

Measured below(std::string judged_on, const MaybeInterval& interval, double threshold) {
  return judged(std::move(judged_on), interval, interval && interval->high < threshold);
}

Measured within(std::string judged_on, const MaybeInterval& interval, double margin) {
  return judged(std::move(judged_on), interval, interval && statistics::equivalent(*interval, margin));
}

Part part_of(std::string name, std::string expectation, std::string rule, const std::string& sql) {
  return {.name = std::move(name),
          .expectation = std::move(expectation),
          .rule = std::move(rule),
          .unit = {},
          .decisive = true,
          .sql = sql,
          .measured = {}};
}

std::optional<std::size_t> find_row(const Rows& rows,
                                    const std::vector<std::pair<std::string_view, std::string_view>>& values) {
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (std::ranges::all_of(values, [&](const auto& value) { return rows.text(row, value.first) == value.second; }))
      return row;
  }
  return std::nullopt;
}

statistics::Sample sample_in(const Rows& rows, std::size_t row, const std::string& name, const std::string& size) {
  const auto mean = rows.number(row, name);
  const auto squares = rows.number(row, name + "_squared");
  if (!mean || !squares) return {};
  return statistics::sample_of_moments(static_cast<std::uint64_t>(rows.number(row, size).value_or(0)), *mean, *squares);
}

std::string figure(double number, int digits) {
  std::array<char, 32> text{};
  const double shown = std::fabs(number) < 1e-12 ? 0 : number;  // what is left of differences of equal numbers
  const auto end = std::to_chars(text.data(), text.data() + text.size(), shown, std::chars_format::general, digits).ptr;
  return {text.data(), end};
}

namespace {

std::string with_decimals(double number, int decimals) {
  std::array<char, 400> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed, decimals).ptr;
  std::string result(text.data(), end);
  const bool is_zero = result.find_first_of("123456789") == std::string::npos;
  return is_zero && result.front() == '-' ? result.substr(1) : result;
}

}  // namespace

std::string figure(const MaybeInterval& interval) {
  if (!interval) return "-";
  const double width = interval->high - interval->low;
  if (!(width > 1e-12)) return figure(interval->estimate);
  const auto is_short = [](double number) { return std::fabs(number * 10 - std::round(number * 10)) < 1e-9; };
  if (is_short(interval->estimate) && is_short(interval->low) && is_short(interval->high)) {
    return figure(interval->estimate) + " [" + figure(interval->low) + ", " + figure(interval->high) + "]";
  }
  constexpr int most_digits = 4;  // more say nothing to people, however narrow the interval
  const double largest = std::max({std::fabs(interval->low), std::fabs(interval->high)});
  const auto exponent = [](double number) { return static_cast<int>(std::floor(std::log10(number))); };
  const int decimals = std::max(0, std::min(1 - exponent(width / 2), most_digits - 1 - exponent(largest)));
  const auto text = [&](double number) { return with_decimals(number, decimals); };
  return text(interval->estimate) + " [" + text(interval->low) + ", " + text(interval->high) + "]";
}

MaybeInterval in_per_cent(MaybeInterval share) {
  if (share) {
    for (double* value : {&share->estimate, &share->low, &share->high}) *value *= 100;
  }
  return share;
}

namespace {

/// Whether a measurement counts for the verdict on that column: it is of the column, or of none that the claim is
/// judged on.
bool counts(const Claim& claim, const Measured& measured, std::string_view judged_on) {
  return measured.judged_on == judged_on ||
         std::ranges::find(claim.judged_on, measured.judged_on) == claim.judged_on.end();
}

}  // namespace

Tally tally_on(const Claim& claim, const std::vector<Part>& parts, std::string_view judged_on) {
  Tally tally;
  for (const auto& part : parts) {
    if (!part.decisive) continue;
    if (part.measured.empty()) ++tally.not_run;
    for (const auto& measured : part.measured) {
      if (!counts(claim, measured, judged_on)) continue;
      if (measured.verdict == Verdict::holds) ++tally.hold;
      if (measured.verdict == Verdict::does_not_hold) ++tally.do_not_hold;
      if (measured.verdict == Verdict::not_run) ++tally.not_run;
    }
  }
  return tally;
}

Verdict verdict_on(const Claim& claim, const std::vector<Part>& parts, std::string_view judged_on) {
  const auto tally = tally_on(claim, parts, judged_on);
  if (tally.do_not_hold > 0) return Verdict::does_not_hold;
  return tally.hold > 0 && tally.not_run == 0 ? Verdict::holds : Verdict::not_run;
}

}  // namespace lamprey::client::report
