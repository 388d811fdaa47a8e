#pragma once

#include "messaging/samples.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace lamprey::worker {

using experiment::Id128;
using Clock = std::chrono::steady_clock;

struct OutboxOptions {
  Clock::duration linger = std::chrono::milliseconds{50};   ///< small results wait so long for company
  Clock::duration resend = std::chrono::seconds{2};         ///< without an answer; doubles up to 16 s
  std::size_t most_bytes_in_flight = std::size_t{8} << 20;  ///< sent to one coordinator, not answered
  std::size_t most_bytes = std::size_t{256} << 20;          ///< held altogether; then nothing new is computed
};

/// Results from their computation to their terminal answer: batched, sent, sent again. Nothing is dropped but by an
/// answer. Not thread-safe.
class Outbox {
 public:
  explicit Outbox(OutboxOptions options = {}) : options_(options) {}

  void add(const Id128& database, const Id128& sweep, messaging::JobResult result, Clock::time_point now);

  /// Samples that should be written now (origin.database and sweep set; the rest of the origin is the caller's).
  /// `flush`: do not linger.
  std::vector<messaging::ResultBatch> due(Clock::time_point now, bool flush);

  /// The batch could not be written (the reader does not keep up): its results are due again soon.
  void postpone(const messaging::ResultBatch& batch, Clock::time_point now);

  /// Whether the answer was for a result held here: then it is forgotten.
  bool acknowledge(const Id128& database, const messaging::Acknowledgement& answer);

  /// Everything that was sent to that database is due again: its coordinator has started anew, or has not heard this
  /// worker for a while, and may not have got it.
  void resend_all(const Id128& database);

  /// Whether the job's result is held (a lease that names it again need not be computed again).
  bool holds(const Id128& database, const Id128& sweep, std::uint64_t job) const;

  std::size_t held() const { return results_.size(); }
  /// How many results were due again for want of an answer, each time it happened.
  std::uint64_t sent_again() const { return sent_again_; }
  std::size_t held_bytes() const { return held_bytes_; }
  bool full() const { return held_bytes_ >= options_.most_bytes; }

 private:
  struct Key {
    Id128 database;
    Id128 sweep;
    std::uint64_t job = 0;
    auto operator<=>(const Key&) const = default;
  };
  struct Held {
    messaging::JobResult result;
    std::size_t bytes = 0;
    Clock::time_point added;
    Clock::time_point next;  ///< earliest time of the next sending
    int sendings = 0;
  };
  Clock::duration patience(int sendings) const;

  OutboxOptions options_;
  std::map<Key, Held> results_;
  std::size_t held_bytes_ = 0;
  std::uint64_t sent_again_ = 0;
  std::map<Id128, std::size_t> in_flight_bytes_;  ///< by database: one that is away must not hold up the others
};

}  // namespace lamprey::worker
