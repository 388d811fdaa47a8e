#include "storage/trace_text.hpp"
#include "storage/verify_parts.hpp"

#include <algorithm>

namespace lamprey::storage {

namespace {

using experiment::Outcome;
using experiment::Score;

std::string text_of(const std::optional<experiment::Digest>& digest) {
  return digest ? experiment::to_hex(*digest) : "nothing";
}

std::string text_of(const Score& score) {
  return "(" + shortest_text(score.stability) + ", " + shortest_text(score.distance) + ", " +
         shortest_text(score.fuel) + ", " + shortest_text(score.total) + ")";
}

/// Checks of one row; each adds what it finds.
class JobCheck {
 public:
  JobCheck(const EndedJob& job, const std::string& sweep, std::vector<Discrepancy>& found)
      : job_(job), sweep_(sweep), found_(found) {}

  void add(std::string column, std::string text) const {
    found_.push_back({sweep_, job_.job, std::move(column), std::move(text)});
  }

  void against(const experiment::SweepGrid& grid) const {
    if (job_.job >= grid.jobs()) {
      return add("job", "stored " + std::to_string(job_.job) + ", but the sweep has " + std::to_string(grid.jobs()) +
                            " jobs only");
    }
    const auto expected = grid.job(job_.job);
    if (job_.identity || job_.state == JobState::done) {
      const auto identity = experiment::identity(expected);
      if (job_.identity != identity) {
        add("identity", stored_and_expected(text_of(job_.identity), experiment::to_hex(identity)));
      }
    }
    if (job_.parameters.empty() && job_.state == JobState::cancelled) return;
    const auto parameters = experiment::to_json(expected.parameters);
    if (job_.parameters != parameters) add("parameters", stored_and_expected(job_.parameters, parameters));
    whole("seed", job_.seed, expected.seed);
    whole("replicate", job_.replicate, expected.replicate);
  }

  void digest() const {
    if (!job_.outcome || !job_.identity) {
      if (job_.digest) add("digest", "stored for a job that is not done");
      return;
    }
    const auto expected = experiment::outcome_digest(*job_.identity, *job_.outcome);
    if (job_.digest != expected) add("digest", stored_and_expected(text_of(job_.digest), experiment::to_hex(expected)));
  }

  void outcome() const {
    if (!job_.outcome) return;
    const Outcome& outcome = *job_.outcome;
    const auto& trace = outcome.trace;
    whole("accepted", outcome.accepted, trace.size());
    const double rate = outcome.cycles == 0 ? 0 : static_cast<double>(outcome.successes) / outcome.cycles;
    if (outcome.success_rate != rate) {
      add("success_rate", stored_and_expected(shortest_text(outcome.success_rate), shortest_text(rate)));
    }
    scores();
    if (std::ranges::adjacent_find(trace, std::ranges::greater_equal{}, &experiment::AcceptedChange::cycle) !=
        trace.end()) {
      add("trace", "its cycles do not ascend");
    }
    if (!trace.empty() && trace.back().cycle >= outcome.cycles) add("trace", "it is longer than the run");
    if (const auto fault = experiment::measures_fault(outcome.measures); !fault.empty()) add("measures", fault);
  }

 private:
  /// Scores against the trace. After a change of the environment they are those of the latest one, whose first is that
  /// of the accepted state tried again, which is in no trace.
  void scores() const {
    const Outcome& outcome = *job_.outcome;
    const auto& trace = outcome.trace;
    const auto is_expected = [](const experiment::Measure& measure) {
      return measure.name == "environment_expected_total";
    };
    const auto latest = std::find_if(outcome.measures.rbegin(), outcome.measures.rend(), is_expected);
    if (latest != outcome.measures.rend()) {
      if (latest->value != outcome.expected.total) {
        add("expected_total", stored_and_expected(shortest_text(outcome.expected.total), shortest_text(latest->value)));
      }
      return;
    }
    const Score& last = trace.empty() ? outcome.initial : trace.back().score;
    if (outcome.final != last) add("final_total", stored_and_expected(text_of(outcome.final), text_of(last)));
    reached("evolved_total", outcome.evolved);
    reached("highest_total", outcome.highest);
    const auto higher =
        std::ranges::find_if(trace, [&](const auto& change) { return change.score.total > outcome.highest.total; });
    if (higher != trace.end()) {
      add("highest_total", "stored " + text_of(outcome.highest) + ", but cycle " + std::to_string(higher->cycle) +
                               " of the trace has " + text_of(higher->score));
    }
  }

  void whole(const char* column, std::uint64_t stored, std::uint64_t expected) const {
    if (stored != expected) add(column, stored_and_expected(std::to_string(stored), std::to_string(expected)));
  }

  /// Whether the system ever had the score.
  void reached(const char* column, const Score& score) const {
    const Outcome& outcome = *job_.outcome;
    if (score == outcome.initial ||
        std::ranges::find(outcome.trace, score, &experiment::AcceptedChange::score) != outcome.trace.end()) {
      return;
    }
    add(column, "stored " + text_of(score) + ", which is neither the initial score nor in the trace");
  }

  const EndedJob& job_;
  const std::string& sweep_;
  std::vector<Discrepancy>& found_;
};

}  // namespace

std::string stored_and_expected(const std::string& stored, const std::string& expected) {
  return "stored " + stored + ", expected " + expected;
}

void verify_job(const StoredJobRow& stored, const std::string& sweep_name, const experiment::SweepGrid* grid,
                std::vector<Discrepancy>& discrepancies) {
  const JobCheck check(stored.job, sweep_name, discrepancies);
  for (const auto& wrong : stored.malformed) check.add(wrong.column, wrong.text);
  if (grid != nullptr) check.against(*grid);
  check.digest();
  if (stored.malformed.empty()) check.outcome();
}

void verify_source(const EndedJob& job, const std::string& sweep_name, Statement& find,
                   std::vector<Discrepancy>& discrepancies) {
  const auto& source = *job.reused_from;
  find.with(source.sweep, source.job);
  if (find.step()) {
    const auto check = [&](const char* column, const auto& stored, const auto& expected) {
      if (stored == expected) return;
      discrepancies.push_back({sweep_name, job.job, column,
                               stored_and_expected(text_of(stored), text_of(expected)) + ", which job " +
                                   std::to_string(source.job) + " of the sweep with the key " +
                                   std::to_string(source.sweep) + " has, whose outcome this is"});
    };
    check("identity", job.identity, find.digest(0));
    check("digest", job.digest, find.digest(1));
  }
  find.reset();
}

}  // namespace lamprey::storage
