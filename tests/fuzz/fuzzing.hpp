#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

/// What the fuzzers have in common.
namespace lamprey::fuzzing {

/// Ends the program unless it holds: that is how a fuzzer learns of a fault.
inline void require(bool holds) {
  if (!holds) std::abort();
}

/// How often a body came to where the planted defect is. The files of a corpus never do (corpus_test.cpp): else the
/// fuzzer would be handed what it is to find.
inline int planted_bug_reached = 0;

/// A defect for the fuzzer to find, to show that it would find one like it: compiled in only where CMake says so
/// (NAME_planted), never into a program. Reads behind the end of a buffer, as a wrong length would.
#ifdef LAMPREY_PLANTED_BUG
inline constexpr bool planted = true;
#else
inline constexpr bool planted = false;
#endif
[[gnu::noinline]] inline void planted_bug() {
  ++planted_bug_reached;
  if constexpr (planted) {
    const std::vector<std::uint8_t> buffer(16);
    const volatile std::size_t length = buffer.size() + 1;
    const volatile std::uint8_t read = buffer.data()[length - 1];
    static_cast<void>(read);
  }
}

/// The planted defect is behind several conditions. Each that holds is a place of its own that the fuzzer sees it has
/// come to, however the compiler would join them: guessing all at once would take longer than anybody waits.
template <int Depth>
[[gnu::noinline]] inline bool reached(bool holds) {
  if (!holds) return false;
  if constexpr (planted) {
    [[maybe_unused]] static const int told = std::fprintf(stderr, "planted defect: condition %d holds\n", Depth);
  }
  return true;
}

/// Takes an input apart. Behind its end everything is zero.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : rest_(data, size) {}

  std::uint8_t octet() {
    const std::uint8_t value = rest_.empty() ? std::uint8_t{0} : rest_.front();
    if (!rest_.empty()) rest_ = rest_.subspan(1);
    return value;
  }
  std::uint32_t u16() {
    const std::uint32_t low = octet();
    return low | std::uint32_t{octet()} << 8;
  }
  /// At most so many octets; fewer at the end.
  std::span<const std::uint8_t> octets(std::size_t count) {
    const auto taken = rest_.first(count < rest_.size() ? count : rest_.size());
    rest_ = rest_.subspan(taken.size());
    return taken;
  }
  std::span<const std::uint8_t> rest() const { return rest_; }
  bool empty() const { return rest_.empty(); }

 private:
  std::span<const std::uint8_t> rest_;
};

}  // namespace lamprey::fuzzing
