#include "coordinator/reuse_scan.hpp"

#include "experiment/models.hpp"

#include <cstring>
#include <utility>

namespace lamprey::coordinator {

namespace {

// Of one step: some milliseconds each.
constexpr std::uint64_t identities_per_step = 5'000;
constexpr std::uint64_t jobs_per_step = 1'000;

}  // namespace

ReuseScan::ReuseScan(const storage::Sweep& sweep, std::shared_ptr<const experiment::SweepGrid> grid,
                     experiment::JobRanges open_jobs)
    : sweep_(sweep), grid_(std::move(grid)), open_jobs_(std::move(open_jobs)) {}

bool ReuseScan::worth_while(const storage::ResultsStore& store, const storage::Sweep& sweep) {
  return !sweep.what.fresh && !store.identities(sweep.what.seed, sweep.row, {}, 1).empty();
}

std::size_t ReuseScan::Hash::operator()(const experiment::Digest& digest) const {
  std::size_t value = 0;
  std::memcpy(&value, digest.data(), sizeof value);  // a digest is as good a hash as any
  return value;
}

ReuseScan::Found ReuseScan::step(const storage::ResultsStore& store) {
  if (!all_read_) {
    read_identities(store);
    return {};
  }
  Found found;
  experiment::JobRanges left = open_jobs_;
  for (const auto& range : left.take_lowest(jobs_per_step).ranges()) {
    for (std::uint64_t number = range.first; number < range.first + range.count; ++number) {
      if (auto row = reused(store, grid_->job(number))) {
        found.rows.push_back(std::move(*row));
      } else {
        found.to_compute.add(number, 1);
      }
    }
  }
  open_jobs_ = std::move(left);
  found.finished = open_jobs_.empty();
  return found;
}

void ReuseScan::read_identities(const storage::ResultsStore& store) {
  const auto page = store.identities(sweep_.what.seed, sweep_.row, place_, identities_per_step);
  for (const auto& stored : page) known_.try_emplace(stored.identity, stored.place);
  all_read_ = page.size() < identities_per_step;
  if (!page.empty()) place_ = page.back().place;
}

std::optional<storage::EndedJob> ReuseScan::reused(const storage::ResultsStore& store,
                                                   const experiment::Job& job) const {
  if (experiment::repeatability(job.parameters) != experiment::Repeatability::bitwise) return std::nullopt;
  const auto identity = experiment::identity(job);
  const auto known = known_.find(identity);
  if (known == known_.end()) return std::nullopt;
  const auto& [sweep, number, begun] = known->second;
  auto row = store.read_job(sweep, number);
  // What is copied must be what it claims to be: a damaged row is computed again instead.
  const bool sound = row && row->outcome && row->digest && row->identity == identity &&
                     experiment::outcome_digest(identity, *row->outcome) == *row->digest;
  if (!sound) return std::nullopt;
  row->sweep = sweep_.row;
  row->job = job.number;
  row->attempt = 1;
  row->queue_seconds = row->waited_seconds = 0;
  row->reused_from = storage::EndedJob::Source{sweep, number};
  return row;
}

}  // namespace lamprey::coordinator
