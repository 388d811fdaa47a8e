#include "experiment/axis_sample.hpp"

#include "experiment/identifiers.hpp"
#include "experiment/typed_value.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace lamprey::experiment {

namespace {

/// Even shares of 1, one after the other.
class Draws {
 public:
  Draws(std::uint64_t seed, std::string_view parameter)
      : text_("lamprey-sample/1\nseed=" + std::to_string(seed) + "\nparameter=" + std::string(parameter) + "\ndraw=") {}

  double next() {
    constexpr int bits = 53;
    const std::uint64_t word = leading_128_bits(sha256(text_ + std::to_string(count_++) + "\n")).high;
    return std::ldexp(static_cast<double>(word >> (64 - bits)), -bits);
  }

  std::uint64_t count() const { return count_; }

 private:
  std::string text_;
  std::uint64_t count_ = 0;
};

std::optional<std::vector<Value>> whole_sample(Draws draws, std::uint64_t count, std::int64_t from, std::int64_t to) {
  const std::int64_t available = to - from + 1;
  const auto wanted = static_cast<std::int64_t>(count);
  if (wanted > available) return std::nullopt;
  std::set<std::int64_t> chosen;
  for (std::int64_t last = available - wanted; last < available; ++last) {
    const auto candidate = static_cast<std::int64_t>(draws.next() * static_cast<double>(last + 1));
    if (!chosen.insert(candidate).second) chosen.insert(last);
  }
  std::vector<Value> values;
  for (const std::int64_t offset : chosen) values.emplace_back(from + offset);
  return values;
}

std::optional<std::vector<Value>> real_sample(Draws draws, std::uint64_t count, double from, double to) {
  // A range that has the values but hardly more would take for ever; nobody samples such a one.
  const std::uint64_t most_draws = 2 * count + 1000;
  std::set<double> chosen;
  while (chosen.size() < count) {
    if (draws.count() == most_draws) return std::nullopt;
    const double value = rounded_to_15_digits(from + draws.next() * (to - from));
    chosen.insert(std::clamp(value, from, to));
  }
  return std::vector<Value>(chosen.begin(), chosen.end());
}

}  // namespace

std::optional<std::vector<Value>> axis_sample(const Parameter& parameter, std::uint64_t seed, std::uint64_t count,
                                              const Value& from, const Value& to) {
  const Draws draws(seed, parameter.name);
  if (const auto* first = std::get_if<std::int64_t>(&from)) {
    return whole_sample(draws, count, *first, std::get<std::int64_t>(to));
  }
  return real_sample(draws, count, std::get<double>(from), std::get<double>(to));
}

}  // namespace lamprey::experiment
