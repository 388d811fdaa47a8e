#pragma once

#include "messaging/traffic.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>

/// For those who implement the port.
namespace lamprey::messaging {

/// Counts for one topic; any thread.
class TopicCounters {
 public:
  explicit TopicCounters(std::string_view topic) : topic_(topic) {}

  void count_write(bool written) { (written ? written_ : refused_).fetch_add(1, std::memory_order_relaxed); }
  void count_read(std::size_t samples) { read_.fetch_add(samples, std::memory_order_relaxed); }

  TopicTraffic so_far() const { return {std::string(topic_), written_, refused_, read_}; }
  std::string_view topic() const { return topic_; }

 private:
  std::string_view topic_;  ///< of static duration (qos.hpp)
  std::atomic<std::uint64_t> written_ = 0;
  std::atomic<std::uint64_t> refused_ = 0;
  std::atomic<std::uint64_t> read_ = 0;
};

/// Of all topics of one participant. Any thread; what `of` hands out stays where it is.
class TrafficCounters {
 public:
  /// `topic`: of static duration.
  TopicCounters& of(std::string_view topic);

  /// In the order in which the topics were used first.
  Traffic so_far(const std::array<std::uint8_t, 16>& participant, std::uint64_t malformed) const;

 private:
  std::chrono::steady_clock::time_point joined_ = std::chrono::steady_clock::now();
  mutable std::mutex mutex_;
  std::deque<TopicCounters> topics_;
};

}  // namespace lamprey::messaging
