#include "experiment/outcome.hpp"

#include <bit>
#include <concepts>
#include <string_view>

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

}  // namespace

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
  return sha256(text.bytes());
}

}  // namespace lamprey::experiment
