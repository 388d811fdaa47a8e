#pragma once

#include <cstdint>
#include <map>
#include <vector>

namespace lamprey::experiment {

/// A set of job numbers, held as disjoint ranges: `pending` and `leased` are sets of this kind, so that a sweep of any
/// size costs memory only for its gaps. A value type.
class JobRanges {
 public:
  struct Range {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    bool operator==(const Range&) const = default;
  };

  JobRanges() = default;
  JobRanges(std::uint64_t first, std::uint64_t count) { add(first, count); }

  bool empty() const { return ranges_.empty(); }
  std::uint64_t size() const { return size_; }
  bool contains(std::uint64_t job) const;

  void add(std::uint64_t first, std::uint64_t count);
  void add(const JobRanges& other);
  void remove(std::uint64_t first, std::uint64_t count);
  void remove(const JobRanges& other);

  /// Whether the job was in the set; it no longer is.
  bool take(std::uint64_t job);

  /// Removes and returns up to `count` of the lowest numbers.
  JobRanges take_lowest(std::uint64_t count);

  JobRanges intersection(const JobRanges& other) const;

  /// In ascending order.
  std::vector<Range> ranges() const;

  bool operator==(const JobRanges&) const = default;

 private:
  std::map<std::uint64_t, std::uint64_t> ranges_;  ///< first → one past the last; disjoint, not touching
  std::uint64_t size_ = 0;
};

}  // namespace lamprey::experiment
