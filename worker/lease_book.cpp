#include "worker/lease_book.hpp"

#include "experiment/sweep.hpp"

#include <algorithm>
#include <cmath>

namespace lamprey::worker {

namespace {

/// Ended leases that are remembered, so that a late repeat of one is not computed again.
constexpr std::size_t remembered = 4096;

}  // namespace

bool LeaseBook::grant(const messaging::Lease& message) {
  const Key key{message.origin.database, message.lease};
  if (leases_.contains(key) || ended_.contains(key)) return false;
  Lease lease;
  lease.epoch = message.origin.epoch;
  lease.arrival = ++arrivals_;
  lease.sweep = message.sweep;
  for (const auto& range : message.ranges) {
    if (range.first >= experiment::maximum_jobs || range.count > experiment::maximum_jobs - range.first) return false;
    lease.remaining.add(range.first, range.count);
  }
  if (lease.remaining.empty()) return false;
  if (std::isfinite(message.time_limit) && message.time_limit > 0) lease.time_limit = message.time_limit;
  if (lease.remaining.size() == 1) lease.checkpoint = message.checkpoint;
  lease.not_started = lease.remaining;
  leases_.emplace(key, std::move(lease));
  return true;
}

bool LeaseBook::revoke(const Key& key) {
  const auto found = leases_.find(key);
  if (found == leases_.end()) return false;
  // Started jobs go on and are sent: their answer, whatever it is, costs less than their computation.
  leases_.erase(found);
  remember(key);
  return true;
}

void LeaseBook::forget_sweep(const Id128& database, const Id128& sweep) {
  std::erase_if(leases_,
                [&](const auto& entry) { return entry.first.first == database && entry.second.sweep == sweep; });
}

std::vector<std::map<LeaseBook::Key, LeaseBook::Lease>::iterator> LeaseBook::by_arrival() {
  std::vector<std::map<Key, Lease>::iterator> order;
  for (auto it = leases_.begin(); it != leases_.end(); ++it) order.push_back(it);
  std::ranges::sort(order, {}, [](const auto& entry) { return entry->second.arrival; });
  return order;
}

void LeaseBook::settled(const Id128& database, const Id128& sweep, std::uint64_t job) {
  for (auto it = leases_.begin(); it != leases_.end(); ++it) {
    if (it->first.first != database || it->second.sweep != sweep || !it->second.remaining.take(job)) continue;
    it->second.not_started.take(job);
    if (it->second.remaining.empty()) {
      remember(it->first);
      leases_.erase(it);
    }
    return;
  }
}

std::vector<messaging::HeldLease> LeaseBook::held() const {
  std::vector<messaging::HeldLease> list;
  for (const auto& [key, lease] : leases_) {
    messaging::HeldLease held;
    held.database = key.first;
    held.epoch = lease.epoch;
    held.lease = key.second;
    held.sweep = lease.sweep;
    for (const auto& range : lease.remaining.ranges()) held.remaining.push_back({range.first, range.count});
    list.push_back(std::move(held));
  }
  return list;
}

void LeaseBook::remember(const Key& key) {
  if (!ended_.insert(key).second) return;
  ended_order_.push_back(key);
  if (ended_order_.size() <= remembered) return;
  ended_.erase(ended_order_.front());
  ended_order_.pop_front();
}

}  // namespace lamprey::worker
