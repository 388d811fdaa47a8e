#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace lamprey::science::saving {

// States as octets, field by field, and back. Each state that lives on has one function
//
//   void fields(auto& archive, saving::Of<State> auto& state)
//
// that names its fields in their order; a Writer writes them, a Reader reads and checks them. Numbers are
// little-endian, of their own width, without padding: octets of one machine are those of any. Names and ranges are not
// written; a Reader's errors and checks have them.

/// Octets that are no state: too few of them, or an impossible value.
class Invalid : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `T`, to be read, or const, to be written.
template <typename State, typename T>
concept Of = std::same_as<std::remove_const_t<State>, T>;

template <typename Number>
concept Whole = std::integral<Number> && !std::same_as<Number, bool>;

class Writer {
 public:
  template <Whole Number>
  void whole(std::string_view /*name*/, Number value, std::type_identity_t<Number> /*minimum*/,
             std::type_identity_t<Number> /*maximum*/) {
    append(static_cast<std::make_unsigned_t<Number>>(value));
  }
  void flag(std::string_view /*name*/, bool value) { octets_.push_back(value ? 1 : 0); }
  void real(std::string_view /*name*/, double value) { append(std::bit_cast<std::uint64_t>(value)); }

  std::vector<std::uint8_t> take() && { return std::move(octets_); }

 private:
  template <std::unsigned_integral Word>
  void append(Word word) {
    for (std::size_t octet = 0; octet < sizeof word; ++octet) {
      octets_.push_back(static_cast<std::uint8_t>(word >> (8 * octet)));
    }
  }

  std::vector<std::uint8_t> octets_;
};

/// Every call throws Invalid, naming the field, for what is not there or out of its range; reals must be finite.
class Reader {
 public:
  /// The octets must outlive it.
  explicit Reader(std::span<const std::uint8_t> octets) : octets_(octets) {}

  template <Whole Number>
  void whole(std::string_view name, Number& value, std::type_identity_t<Number> minimum,
             std::type_identity_t<Number> maximum) {
    const auto read = static_cast<Number>(word<std::make_unsigned_t<Number>>(name));
    if (read < minimum || read > maximum) {
      out_of_range(name, static_cast<std::int64_t>(read), static_cast<std::int64_t>(minimum),
                   static_cast<std::int64_t>(maximum));
    }
    value = read;
  }
  void flag(std::string_view name, bool& value) {
    std::uint8_t read = 0;
    whole(name, read, 0, 1);
    value = read == 1;
  }
  void real(std::string_view name, double& value) {
    value = std::bit_cast<double>(word<std::uint64_t>(name));
    if (!std::isfinite(value)) not_finite(name);
  }

  /// Throws if there is more.
  void end() const;

 private:
  template <std::unsigned_integral Word>
  Word word(std::string_view name) {
    if (octets_.size() < sizeof(Word)) too_short(name);
    Word result = 0;
    for (std::size_t octet = 0; octet < sizeof result; ++octet) {
      result = static_cast<Word>(result | static_cast<Word>(Word{octets_[octet]} << (8 * octet)));
    }
    octets_ = octets_.subspan(sizeof result);
    return result;
  }

  [[noreturn]] static void too_short(std::string_view name);
  [[noreturn]] static void not_finite(std::string_view name);
  [[noreturn]] static void out_of_range(std::string_view name, std::int64_t value, std::int64_t minimum,
                                        std::int64_t maximum);

  std::span<const std::uint8_t> octets_;
};

/// A real that is within its range too. Throws Invalid when it is read and is not.
void real_within(Writer& archive, std::string_view name, double value, double minimum, double maximum);
void real_within(Reader& archive, std::string_view name, double& value, double minimum, double maximum);

/// All numbers of an array, each within the range.
template <typename Archive, typename Numbers, typename Number = typename Numbers::value_type>
void wholes(Archive& archive, std::string_view name, Numbers& numbers, std::type_identity_t<Number> minimum,
            std::type_identity_t<Number> maximum) {
  for (auto& number : numbers) archive.whole(name, number, minimum, maximum);
}

/// All flags of an array.
void flags(auto& archive, std::string_view name, auto& values) {
  for (auto& value : values) archive.flag(name, value);
}

/// All reals of an array or vector, as many as there are.
void reals(auto& archive, std::string_view name, auto& numbers) {
  for (auto& number : numbers) archive.real(name, number);
}

/// A vector of reals with its length, at most `longest`, each within the range.
void counted_reals(auto& archive, std::string_view name, Of<std::vector<double>> auto& numbers, std::uint32_t longest,
                   double minimum, double maximum) {
  auto count = static_cast<std::uint32_t>(numbers.size());
  archive.whole(name, count, 0, longest);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(numbers)>>) {
    numbers.clear();
    // Grows as octets are there for it: a count alone must not fill the memory.
    for (std::uint32_t i = 0; i < count; ++i) {
      real_within(archive, name, numbers.emplace_back(), minimum, maximum);
    }
  } else {
    for (const double number : numbers) real_within(archive, name, number, minimum, maximum);
  }
}

}  // namespace lamprey::science::saving
