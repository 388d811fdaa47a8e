#include "experiment/job_ranges.hpp"

#include <algorithm>
#include <iterator>

namespace lamprey::experiment {

bool JobRanges::contains(std::uint64_t job) const {
  auto next = ranges_.upper_bound(job);
  return next != ranges_.begin() && job < std::prev(next)->second;
}

void JobRanges::add(std::uint64_t first, std::uint64_t count) {
  if (count == 0) return;
  std::uint64_t begin = first;
  std::uint64_t end = first + count;
  // Swallow every range that overlaps or touches [begin, end).
  auto it = ranges_.upper_bound(begin);
  if (it != ranges_.begin() && std::prev(it)->second >= begin) --it;
  while (it != ranges_.end() && it->first <= end) {
    begin = std::min(begin, it->first);
    end = std::max(end, it->second);
    size_ -= it->second - it->first;
    it = ranges_.erase(it);
  }
  ranges_.emplace_hint(it, begin, end);
  size_ += end - begin;
}

void JobRanges::add(const JobRanges& other) {
  for (const auto& [first, end] : other.ranges_) add(first, end - first);
}

void JobRanges::remove(std::uint64_t first, std::uint64_t count) {
  if (count == 0) return;
  const std::uint64_t end = first + count;
  auto it = ranges_.upper_bound(first);
  if (it != ranges_.begin() && std::prev(it)->second > first) --it;
  while (it != ranges_.end() && it->first < end) {
    const auto [range_first, range_end] = *it;
    it = ranges_.erase(it);
    size_ -= range_end - range_first;
    if (range_first < first) {
      ranges_.emplace_hint(it, range_first, first);
      size_ += first - range_first;
    }
    if (range_end > end) {
      ranges_.emplace_hint(it, end, range_end);
      size_ += range_end - end;
    }
  }
}

void JobRanges::remove(const JobRanges& other) {
  for (const auto& [first, end] : other.ranges_) remove(first, end - first);
}

bool JobRanges::take(std::uint64_t job) {
  if (!contains(job)) return false;
  remove(job, 1);
  return true;
}

JobRanges JobRanges::take_lowest(std::uint64_t count) {
  JobRanges taken;
  while (taken.size_ < count && !ranges_.empty()) {
    const auto [first, end] = *ranges_.begin();
    const std::uint64_t part = std::min(end - first, count - taken.size_);
    taken.add(first, part);
    remove(first, part);
  }
  return taken;
}

JobRanges JobRanges::intersection(const JobRanges& other) const {
  JobRanges both;
  auto a = ranges_.begin();
  auto b = other.ranges_.begin();
  while (a != ranges_.end() && b != other.ranges_.end()) {
    const std::uint64_t first = std::max(a->first, b->first);
    const std::uint64_t end = std::min(a->second, b->second);
    if (first < end) both.add(first, end - first);
    if (a->second < b->second) {
      ++a;
    } else {
      ++b;
    }
  }
  return both;
}

std::vector<JobRanges::Range> JobRanges::ranges() const {
  std::vector<Range> list;
  list.reserve(ranges_.size());
  for (const auto& [first, end] : ranges_) list.push_back({first, end - first});
  return list;
}

}  // namespace lamprey::experiment
