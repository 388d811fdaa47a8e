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
/// Of a measure without its name: the name's length and end, index, value.
constexpr std::size_t measure_head_bytes = 32;
/// Of a sample, for the batch's own head and the protocol's.
constexpr std::size_t reserved_bytes = 512;
/// Beyond it a fragmented result is nothing a worker of ours sends.
constexpr std::uint32_t most_fragments = 16384;

std::size_t wire_bytes(const experiment::Measure& measure) {
  return measure_head_bytes + measure.name.size();
}

bool possible(const JobResult& fragment) {
  return fragment.fragments >= 1 && fragment.fragments <= most_fragments && fragment.fragment < fragment.fragments;
}

/// Whether both can be parts of one result. Jobs that failed have no digest; what tells their attempts apart is the
/// lease.
bool agree(const JobResult& a, const JobResult& b) {
  return a.fragments == b.fragments && a.digest == b.digest && a.identity == b.identity && a.kind == b.kind &&
         a.lease == b.lease;
}

}  // namespace

std::size_t wire_bytes(const JobResult& result) {
  std::size_t bytes =
      result_head_bytes + result.reason.size() + result.recording.size() + change_bytes * result.outcome.trace.size();
  for (const auto& measure : result.outcome.measures) bytes += wire_bytes(measure);
  return bytes;
}

std::vector<JobResult> fragments(const JobResult& whole) {
  JobResult head = whole;
  head.outcome.trace.clear();
  head.outcome.measures.clear();
  head.recording.clear();
  head.reason.resize(std::min(head.reason.size(), maximum_reason_bytes));
  const std::size_t capacity = maximum_sample_bytes - reserved_bytes - wire_bytes(head);

  std::vector<JobResult> parts{head};
  std::size_t used = 0;
  const auto part_for = [&](std::size_t bytes) -> JobResult& {
    if (used + bytes > capacity) {
      parts.push_back(head);
      used = 0;
    }
    used += bytes;
    return parts.back();
  };
  for (const auto& change : whole.outcome.trace) part_for(change_bytes).outcome.trace.push_back(change);
  for (const auto& measure : whole.outcome.measures) part_for(wire_bytes(measure)).outcome.measures.push_back(measure);
  for (std::size_t begin = 0; begin < whole.recording.size();) {
    if (used == capacity) {
      parts.push_back(head);
      used = 0;
    }
    const std::size_t end = std::min(whole.recording.size(), begin + capacity - used);
    part_for(end - begin)
        .recording.assign(whole.recording.begin() + static_cast<std::ptrdiff_t>(begin),
                          whole.recording.begin() + static_cast<std::ptrdiff_t>(end));
    begin = end;
  }

  for (std::size_t part = 0; part < parts.size(); ++part) {
    parts[part].fragment = static_cast<std::uint32_t>(part);
    parts[part].fragments = static_cast<std::uint32_t>(parts.size());
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
  while (held_bytes_ > most_bytes_ && partial_.size() > 1) drop_oldest();
  return std::nullopt;
}

JobResult Assembler::take(Partials::iterator position) {
  auto& parts = position->second.parts;
  JobResult whole = std::move(parts.begin()->second);
  whole.fragments = 1;
  const auto append = [](auto& all, const auto& slice) { all.insert(all.end(), slice.begin(), slice.end()); };
  for (auto part = std::next(parts.begin()); part != parts.end(); ++part) {
    append(whole.outcome.trace, part->second.outcome.trace);
    append(whole.outcome.measures, part->second.outcome.measures);
    append(whole.recording, part->second.recording);
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
