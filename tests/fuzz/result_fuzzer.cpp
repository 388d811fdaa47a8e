// Whatever results a worker claims to have: the coordinator's judgement of each is a row or a reason, and what it lets
// through is in order; cut into fragments, delayed, repeated and mixed up, they come together as they were.
#include "coordinator/open_sweep.hpp"
#include "experiment/models.hpp"
#include "messaging/fragmentation.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace {

using namespace lamprey;
using fuzzing::Input;
using fuzzing::require;

constexpr std::uint64_t worker = 7;

const coordinator::OpenSweep& sweep() {
  static const coordinator::OpenSweep open = [] {
    const auto file = experiment::parse_sweep(
        "name: fuzz\nseed: 1\nbase: {cycles: 6}\ngrids:\n  - {required_fuel: [25, 100], mutation: [all, one]}\n", "");
    coordinator::OpenSweep sweep;
    sweep.grid = std::make_shared<const experiment::SweepGrid>(file.specification);
    sweep.stored.row = 1;
    sweep.stored.what.jobs = sweep.grid->jobs();
    sweep.stored.science_version = experiment::science_version;
    return sweep;
  }();
  return open;
}

/// Small numbers mostly, for those are the ones that can be right.
double real(Input& input) {
  const std::uint8_t kind = input.octet();
  if (kind < 250) return kind;
  std::uint64_t bits = 0;
  for (const auto octet : input.octets(8)) bits = bits << 8 | octet;
  return std::bit_cast<double>(bits);
}

experiment::Score score(Input& input) {
  experiment::Score score;
  score.stability = real(input);
  score.distance = real(input);
  score.fuel = real(input);
  score.total = real(input);
  return score;
}

experiment::Outcome outcome(Input& input) {
  experiment::Outcome outcome;
  for (auto* part : {&outcome.expected, &outcome.initial, &outcome.evolved, &outcome.highest, &outcome.final}) {
    *part = score(input);
  }
  outcome.cycles = input.octet();
  outcome.accepted = input.octet();
  outcome.successes = input.octet();
  outcome.success_rate = real(input);
  // The rows of a large trace are all alike, so that small inputs can be long results.
  const std::uint32_t rows = input.octet() < 250 ? input.octet() : input.u16() % 4096;
  const auto row = score(input);
  for (std::uint32_t i = 0; i < rows; ++i) {
    const std::uint32_t step = i < 8 ? input.octet() : 1;
    outcome.trace.push_back({(i == 0 ? 0 : outcome.trace.back().cycle) + step, row});
  }
  const std::uint32_t measures = input.octet() % 8;
  for (std::uint32_t i = 0; i < measures; ++i) {
    const auto name = input.octets(input.octet() % 80);
    const std::uint32_t index = input.octet();
    outcome.measures.push_back({std::string(name.begin(), name.end()), index, real(input)});
  }
  return outcome;
}

messaging::JobResult result(Input& input) {
  messaging::JobResult result;
  const std::uint8_t claims = input.octet();
  result.job = (claims & 1U) != 0 ? input.u16() : input.octet() % 4U;
  result.kind = (claims & 2U) != 0 ? messaging::ResultKind::failed : messaging::ResultKind::done;
  result.seconds = real(input);
  result.waited = real(input);
  const auto reason = input.octets(input.octet());
  result.reason.assign(reason.begin(), reason.end());
  result.outcome = outcome(input);
  // Nobody guesses a SHA-256: most inputs get those that are right.
  if ((claims & 4U) == 0 && result.job < sweep().stored.what.jobs) {
    result.identity = experiment::identity(sweep().grid->job(result.job));
  }
  if ((claims & 8U) == 0) result.digest = experiment::outcome_digest(result.identity, result.outcome);
  return result;
}

void look_at(const messaging::JobResult& result, std::uint32_t version) {
  messaging::Origin origin;
  origin.worker = worker;
  origin.science_version = version;
  const auto judgement = coordinator::judge(sweep(), origin, result);
  require(judgement.row.has_value() == judgement.refusal.empty());
  if (!judgement.row) return;
  const auto& row = *judgement.row;
  require(version == experiment::science_version && row.job == result.job && row.worker == worker);
  require(row.seconds >= 0 && std::isfinite(row.seconds));
  if (row.state == storage::JobState::failed) return;
  require(row.state == storage::JobState::done && row.digest == result.digest && row.outcome.has_value());
  require(experiment::measures_fault(result.outcome.measures).empty());
  require(result.outcome.accepted == result.outcome.trace.size());
  if (!fuzzing::reached<1>(!result.outcome.trace.empty())) return;
  const auto& outcome = result.outcome;
  const double highest = std::max({row.seconds, outcome.expected.total, outcome.initial.total, outcome.evolved.total,
                                   outcome.highest.total, outcome.final.total});
  if (fuzzing::reached<2>(highest > 200)) fuzzing::planted_bug();
}

/// NaN differs from itself, so octets are compared.
bool same(const messaging::JobResult& one, const messaging::JobResult& other) {
  return one.job == other.job && one.digest == other.digest && one.identity == other.identity &&
         experiment::outcome_digest(one.identity, one.outcome) ==
             experiment::outcome_digest(other.identity, other.outcome);
}

/// The order and the repeats are the input's.
void look_at_fragments(const messaging::JobResult& whole, Input& input) {
  auto parts = messaging::fragments(whole);
  messaging::Assembler assembler(std::size_t{1} << 20);
  const experiment::Id128 id{1, 2};
  std::vector<bool> sent(parts.size());
  std::size_t left = parts.size();
  bool complete = false;
  const auto send = [&](std::size_t at) {
    const bool is_new = !sent[at];
    sent[at] = true;
    left -= is_new ? 1 : 0;
    const auto assembled = assembler.add(worker, id, parts[at]);
    if (!assembled) return;
    require(left == 0 && same(*assembled, whole));
    complete = true;
  };
  for (int repeats = 0; repeats < 8 && !input.empty() && left > 1; ++repeats) send(input.octet() % parts.size());
  for (std::size_t at = parts.size(); at-- > 0;) {
    if (!sent[at]) send(at);
  }
  require(complete && assembler.held_bytes() == 0);
}

/// Fragments that nobody has cut: whatever they say, the assembler stays within its bound, but for a single result.
void look_at_forged_fragments(const messaging::JobResult& whole, Input& input) {
  constexpr std::size_t bound = 16 * 1024;
  messaging::Assembler assembler(bound);
  for (int i = 0; i < 16 && !input.empty(); ++i) {
    messaging::JobResult fragment = whole;
    fragment.fragment = input.octet();
    fragment.fragments = input.octet();
    fragment.job = input.octet() % 3U;
    fragment.digest[0] = input.octet() % 2U;
    static_cast<void>(assembler.add(worker, {1, 2}, std::move(fragment)));
    require(assembler.held_bytes() <= bound || assembler.incomplete() == 1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  const std::uint32_t version = input.octet() == 0xff ? 0 : experiment::science_version;
  const auto one = result(input);
  look_at(one, version);
  look_at_fragments(one, input);
  look_at_forged_fragments(one, input);
  return 0;
}
