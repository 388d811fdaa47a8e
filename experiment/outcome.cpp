#include "experiment/outcome.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <concepts>
#include <string_view>
#include <tuple>

namespace lamprey::experiment {

namespace {

/// Bytes in the order of docs/formats/digest.md; numbers are little-endian on every machine.
class ByteText {
 public:
  void append(std::string_view text) { bytes_.insert(bytes_.end(), text.begin(), text.end()); }
  void append(const Digest& digest) { bytes_.insert(bytes_.end(), digest.begin(), digest.end()); }
  void append(double value) { append(std::bit_cast<std::uint64_t>(value)); }
  void append(const Score& score) {
    append(score.stability);
    append(score.distance);
    append(score.fuel);
    append(score.total);
  }
  template <std::unsigned_integral Word>
  void append(Word word) {
    for (std::size_t byte = 0; byte < sizeof word; ++byte) {
      bytes_.push_back(static_cast<std::uint8_t>(word >> (8 * byte)));
    }
  }

  void reserve(std::size_t size) { bytes_.reserve(size); }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

bool is_measure_name(std::string_view name) {
  return !name.empty() && name.size() <= maximum_measure_name &&
         std::ranges::all_of(name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

}  // namespace

std::string measures_fault(std::span<const Measure> measures) {
  const Measure* previous = nullptr;
  for (const Measure& measure : measures) {
    if (!is_measure_name(measure.name)) {
      return "the name of a measure is not 1 to " + std::to_string(maximum_measure_name) + " of a-z, 0-9 and _";
    }
    const std::string which = "the measure " + measure.name + " " + std::to_string(measure.index);
    if (!std::isfinite(measure.value)) return which + " is not a finite number";
    if (measure.value == 0 && std::signbit(measure.value)) return which + " is a negative zero";
    if (previous != nullptr && std::tie(previous->name, previous->index) >= std::tie(measure.name, measure.index)) {
      return which + " comes twice or is out of order";
    }
    previous = &measure;
  }
  return {};
}

Digest outcome_digest(const Digest& identity, const Outcome& outcome) {
  constexpr std::size_t fixed_size = 18 + 32 + 5 * 32 + 3 * 4 + 8;
  constexpr std::size_t row_size = 4 + 32;

  ByteText text;
  text.reserve(fixed_size + row_size * outcome.trace.size());
  text.append(std::string_view("lamprey-outcome/1\n"));
  text.append(identity);
  text.append(outcome.expected);
  text.append(outcome.initial);
  text.append(outcome.evolved);
  text.append(outcome.highest);
  text.append(outcome.final);
  text.append(outcome.cycles);
  text.append(outcome.accepted);
  text.append(outcome.successes);
  text.append(outcome.success_rate);
  for (const AcceptedChange& change : outcome.trace) {
    text.append(change.cycle);
    text.append(change.score);
  }
  // Only where there are any: digests of jobs without are older than measures.
  if (!outcome.measures.empty()) text.append(static_cast<std::uint32_t>(outcome.measures.size()));
  for (const Measure& measure : outcome.measures) {
    text.append(static_cast<std::uint32_t>(measure.name.size()));
    text.append(std::string_view(measure.name));
    text.append(measure.index);
    text.append(measure.value);
  }
  return sha256(text.bytes());
}

}  // namespace lamprey::experiment
