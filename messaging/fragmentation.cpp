#include "messaging/fragmentation.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace lamprey::messaging {
namespace {

// CDR sizes after idl/lamprey.idl, rounded up for alignment.
constexpr std::size_t result_head_bytes = 384;
constexpr std::size_t change_bytes = sizeof(std::uint32_t) + 4 * sizeof(double);
/// Of a sample, for the batch's own head and the protocol's.
constexpr std::size_t reserved_bytes = 512;
/// Beyond it a fragmented trace is nothing a worker of ours sends.
constexpr std::uint32_t most_fragments = 16384;

bool possible(const JobResult& fragment) {
  return fragment.fragments >= 1 && fragment.fragments <= most_fragments && fragment.fragment < fragment.fragments;
}

/// Whether both can be parts of one result.
bool agree(const JobResult& a, const JobResult& b) {
  return a.fragments == b.fragments && a.digest == b.digest && a.identity == b.identity && a.kind == b.kind;
}

}  // namespace

std::size_t wire_bytes(const JobResult& result) {
  return result_head_bytes + result.reason.size() + change_bytes * result.outcome.trace.size();
}

std::vector<JobResult> fragments(const JobResult& whole) {
  JobResult head = whole;
  head.outcome.trace.clear();
  head.reason.resize(std::min(head.reason.size(), maximum_reason_bytes));
  const std::size_t rows = whole.outcome.trace.size();
  const std::size_t rows_per_fragment = (maximum_sample_bytes - reserved_bytes - wire_bytes(head)) / change_bytes;
  const std::size_t count = std::max<std::size_t>(1, (rows + rows_per_fragment - 1) / rows_per_fragment);
  head.fragments = static_cast<std::uint32_t>(count);

  std::vector<JobResult> parts(count, head);
  for (std::size_t part = 0; part < count; ++part) {
    const auto first = std::next(whole.outcome.trace.begin(), static_cast<std::ptrdiff_t>(part * rows_per_fragment));
    const std::size_t size = std::min(rows_per_fragment, rows - part * rows_per_fragment);
    parts[part].fragment = static_cast<std::uint32_t>(part);
    parts[part].outcome.trace.assign(first, std::next(first, static_cast<std::ptrdiff_t>(size)));
  }
  return parts;
}

std::optional<JobResult> Assembler::add(std::uint64_t worker, const Id128& sweep, JobResult fragment) {
  if (!possible(fragment)) return std::nullopt;
  const Key key{worker, sweep, fragment.job};
  if (fragment.fragments == 1) {
    if (const auto old = partial_.find(key); old != partial_.end()) drop(old);
    return fragment;
  }
  if (wire_bytes(fragment) > maximum_sample_bytes) return std::nullopt;

  auto position = partial_.find(key);
  if (position != partial_.end() && !agree(position->second.parts.begin()->second, fragment)) {
    drop(position);
    position = partial_.end();
  }
  if (position == partial_.end())
    position = partial_.emplace(key, Partial{.parts = {}, .bytes = 0, .age = next_age_++}).first;

  Partial& partial = position->second;
  const std::size_t bytes = wire_bytes(fragment);
  const std::uint32_t count = fragment.fragments;
  if (!partial.parts.emplace(fragment.fragment, std::move(fragment)).second) return std::nullopt;
  partial.bytes += bytes;
  held_bytes_ += bytes;
  if (partial.parts.size() == count) return take(position);
  // One result may be longer than the bound; it must still be able to end.
  while (held_bytes_ > most_bytes_ && partial_.size() > 1) drop_oldest();
  return std::nullopt;
}

JobResult Assembler::take(Partials::iterator position) {
  auto& parts = position->second.parts;
  JobResult whole = std::move(parts.begin()->second);
  whole.fragments = 1;
  auto& trace = whole.outcome.trace;
  for (auto part = std::next(parts.begin()); part != parts.end(); ++part) {
    const auto& slice = part->second.outcome.trace;
    trace.insert(trace.end(), slice.begin(), slice.end());
  }
  drop(position);
  return whole;
}

void Assembler::drop(Partials::iterator position) {
  held_bytes_ -= position->second.bytes;
  partial_.erase(position);
}

void Assembler::drop_oldest() {
  drop(std::min_element(partial_.begin(), partial_.end(),
                        [](const auto& a, const auto& b) { return a.second.age < b.second.age; }));
}

}  // namespace lamprey::messaging
