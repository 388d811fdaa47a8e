#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace lamprey::experiment {

/// One thing that is wrong with what a user (or the network) gave: where, what, and what would be right.
struct Problem {
  std::string field;    ///< path within the specification, such as grids[1].steps[0]; empty if none
  std::string message;  ///< names the value, the allowed range or names, and the nearest known name
  std::string file;     ///< empty where there is no file
  int line = 0;         ///< 1-based; 0 where there is none
  int column = 0;       ///< 1-based; 0 where there is none

  /// "sweeps/a.yaml:7:12: grids[1].steps[0]: …" with the parts that are known.
  std::string text() const;
};

/// Reading stops after this many problems: an input that has more is no slip, and may be hostile.
inline constexpr std::size_t maximum_problems = 100;

/// Invalid input, found before anything was changed. what() is the text of all problems, a line each.
class InvalidInput : public std::runtime_error {
 public:
  explicit InvalidInput(std::vector<Problem> problems);
  explicit InvalidInput(Problem problem) : InvalidInput(std::vector<Problem>{std::move(problem)}) {}

  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::vector<Problem> problems_;
};

/// Whether a field is `holder` or a part of it: grids[1].steps[0] is within grids[1].steps, grids[1] and grids.
bool is_within(std::string_view field, std::string_view holder);

/// Collects what is wrong with one specification: each problem once, and at most maximum_problems of them.
class Findings {
 public:
  /// `given`: problems met while the specification was read.
  explicit Findings(std::vector<Problem> given) : problems_(std::move(given)), given_(problems_.size()) {}

  /// Adds a problem, unless a given one is about the same field or about one that holds it: whoever could not read a
  /// field has said why.
  void add(std::string field, std::string message);

  /// Whether nothing more will be added.
  bool full() const { return problems_.size() >= maximum_problems; }

  /// Whether any problem is about the field or about a part of it.
  bool any_within(std::string_view field) const;

  std::vector<Problem> take() { return std::move(problems_); }

 private:
  std::vector<Problem> problems_;
  std::size_t given_;
};

/// The known name nearest to `name` by edit distance, or empty if none is near enough to be a slip of the finger.
std::string nearest_name(std::string_view name, const std::vector<std::string_view>& known);

/// "; did you mean 'to'?" if a known name is near, else empty.
std::string nearest_hint(std::string_view name, const std::vector<std::string_view>& known);

/// Where `text` first has a byte that is not UTF-8, or a control character other than tab and line ends; npos if
/// nowhere. Such text is refused: protobuf and SQLite's readers can't carry it, terminals would act on it.
std::size_t first_unreadable(std::string_view text);

/// Text from outside made fit for a message: bytes that are no UTF-8 and control characters as \xNN, at most some
/// sixty bytes and then "...".
std::string printable(std::string_view text);

}  // namespace lamprey::experiment
