#include "worker/outbox.hpp"

#include "messaging/fragmentation.hpp"

#include <algorithm>
#include <utility>

namespace lamprey::worker {

namespace {

constexpr int most_doublings = 3;
constexpr auto postponement = std::chrono::milliseconds{20};

}  // namespace

void Outbox::add(const Id128& database, const Id128& sweep, messaging::JobResult result, Clock::time_point now) {
  const Key key{database, sweep, result.job};
  if (results_.contains(key)) return;  // computed twice, the same by determinism
  Held held;
  held.bytes = messaging::wire_bytes(result);
  held.result = std::move(result);
  held.added = now;
  held.next = now;
  held_bytes_ += held.bytes;
  results_.emplace(key, std::move(held));
}

std::vector<messaging::ResultBatch> Outbox::due(Clock::time_point now, bool flush) {
  std::size_t waiting_bytes = 0;
  bool overdue = flush;
  for (const auto& [key, held] : results_) {
    if (held.next > now) continue;
    waiting_bytes += held.bytes;
    overdue = overdue || held.sendings > 0 || now - held.added >= options_.linger;
  }
  std::vector<messaging::ResultBatch> batches;
  if (waiting_bytes == 0 || (!overdue && waiting_bytes < messaging::maximum_sample_bytes)) return batches;

  std::size_t batch_bytes = 0;
  const auto place = [&](const Key& key, messaging::JobResult part, std::size_t bytes) {
    const bool fits = !batches.empty() && batches.back().origin.database == key.database &&
                      batches.back().sweep == key.sweep && batch_bytes + bytes <= messaging::maximum_sample_bytes;
    if (!fits) {
      batches.emplace_back();
      batches.back().origin.database = key.database;
      batches.back().sweep = key.sweep;
      batch_bytes = 0;
    }
    batch_bytes += bytes;
    batches.back().results.push_back(std::move(part));
  };
  for (auto& [key, held] : results_) {
    if (held.next > now) continue;
    const bool first = held.sendings == 0;
    std::size_t& in_flight = in_flight_bytes_[key.database];
    if (first && in_flight > 0 && in_flight + held.bytes > options_.most_bytes_in_flight) continue;
    if (first) in_flight += held.bytes;
    if (!first) ++sent_again_;
    held.next = now + patience(held.sendings++);
    if (held.bytes <= messaging::maximum_sample_bytes) {
      place(key, held.result, held.bytes);
    } else {
      for (auto& part : messaging::fragments(held.result)) {
        const std::size_t bytes = messaging::wire_bytes(part);
        place(key, std::move(part), bytes);
      }
    }
  }
  return batches;
}

Clock::duration Outbox::patience(int sendings) const {
  return options_.resend * (1 << std::min(sendings, most_doublings));
}

void Outbox::postpone(const messaging::ResultBatch& batch, Clock::time_point now) {
  for (const auto& result : batch.results) {
    const auto found = results_.find({batch.origin.database, batch.sweep, result.job});
    if (found == results_.end()) continue;
    found->second.next = now + postponement;
    found->second.sendings = 1;  // in flight, as far as its bytes go, but with the first patience again
  }
}

bool Outbox::acknowledge(const Id128& database, const messaging::Acknowledgement& answer) {
  const auto found = results_.find({database, answer.sweep, answer.job});
  if (found == results_.end() || found->second.result.digest != answer.digest) return false;
  held_bytes_ -= found->second.bytes;
  if (found->second.sendings > 0) in_flight_bytes_[database] -= found->second.bytes;
  results_.erase(found);
  return true;
}

void Outbox::resend_all(const Id128& database) {
  for (auto& [key, held] : results_) {
    if (key.database != database) continue;
    held.next = {};
    held.sendings = std::min(held.sendings, 1);
  }
}

bool Outbox::holds(const Id128& database, const Id128& sweep, std::uint64_t job) const {
  return results_.contains({database, sweep, job});
}

}  // namespace lamprey::worker
