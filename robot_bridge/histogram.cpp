#include "robot_bridge/histogram.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lamprey::robot_bridge {

void Histogram::add(std::chrono::nanoseconds duration) {
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(duration);
  const std::uint64_t microseconds = whole.count() < 0 ? 0 : static_cast<std::uint64_t>(whole.count());
  // Below 16 each value has a bucket; above, the four bits behind the leading one pick it.
  const auto width = static_cast<std::size_t>(std::bit_width(microseconds));
  const std::size_t shift = width > 5 ? width - 5 : 0;
  const std::size_t bucket = shift * steps + static_cast<std::size_t>(microseconds >> shift);
  ++buckets_[std::min(bucket, buckets_.size() - 1)];
  ++count_;
  largest_ = std::max(largest_, std::chrono::microseconds(microseconds));
}

std::chrono::microseconds Histogram::quantile(double share) const {
  const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
  std::uint64_t met = 0;
  for (std::size_t bucket = 0; bucket < buckets_.size(); ++bucket) {
    met += buckets_[bucket];
    if (met == 0 || met < wanted) continue;
    const std::size_t shift = bucket < 2 * steps ? 0 : bucket / steps - 1;
    const std::uint64_t upper = ((bucket - shift * steps + 1) << shift) - 1;
    return std::min(std::chrono::microseconds(upper), largest_);
  }
  return largest_;
}

}  // namespace lamprey::robot_bridge
