#include "storage/sweep_row.hpp"
#include "storage/verify_parts.hpp"

namespace lamprey::storage {

namespace {

/// Checks of one sweep's columns; each adds what it finds.
class SweepCheck {
 public:
  SweepCheck(const Sweep& sweep, std::vector<Discrepancy>& found) : sweep_(sweep), found_(found) {}

  void equal(const char* column, const std::string& stored, const std::string& expected) const {
    if (stored != expected) add(column, stored_and_expected(stored, expected));
  }
  void equal(const char* column, std::uint64_t stored, std::uint64_t expected) const {
    equal(column, std::to_string(stored), std::to_string(expected));
  }
  void add(const char* column, const std::string& text) const {
    found_.push_back({sweep_.what.name, std::nullopt, column, text});
  }

  std::optional<experiment::SweepGrid> specification() const {
    idl::SweepSpecification specification;
    if (!specification.ParseFromString(sweep_.what.specification)) {
      add("specification", "the stored bytes are not a sweep specification");
      return std::nullopt;
    }
    try {
      experiment::SweepGrid grid(specification);
      equal("id", experiment::to_hex(sweep_.what.id), experiment::to_hex(experiment::sweep_id(specification)));
      // The stored name may be a later one than the specification's; the checksum vouches for it.
      equal("seed", sweep_.what.seed, specification.seed());
      equal("replicates", sweep_.what.replicates, grid.replicates());
      equal("jobs", sweep_.what.jobs, grid.jobs());
      return grid;
    } catch (const experiment::InvalidInput& error) {
      add("specification", std::string("the stored one is invalid: ") + error.what());
      return std::nullopt;
    }
  }

  void checksum(const Connection& connection) const {
    Statement read(connection, "SELECT checksum FROM sweep WHERE sweep = ?");
    read.bind(1, sweep_.row);
    const auto expected = sweep_checksum(sweep_.what, sweep_.science_version);
    if (!read.step() || read.digest(0) != expected) {
      add("checksum", "it is not that of name, specification, source and the other columns: expected " +
                          experiment::to_hex(expected));
    }
  }

  void counters(const Connection& connection) const {
    JobCounts rows;
    Statement count(connection,
                    "SELECT count(*) FILTER (WHERE state = 'done'), count(*) FILTER (WHERE state = 'failed'), "
                    "count(*) FILTER (WHERE state = 'quarantined'), count(*) FILTER (WHERE state = 'cancelled'), "
                    "count(reused_from_job) FROM job WHERE sweep = ?");
    count.bind(1, sweep_.row);
    if (count.step()) {
      rows = {count.bits(0), count.bits(1), count.bits(2), count.bits(3)};
      equal("reused", sweep_.reused, count.bits(4));
    }
    equal("done", sweep_.counts.done, rows.done);
    equal("failed", sweep_.counts.failed, rows.failed);
    equal("quarantined", sweep_.counts.quarantined, rows.quarantined);
    equal("cancelled", sweep_.counts.cancelled, rows.cancelled);

    Statement divergences(connection, "SELECT count(*) FROM divergence WHERE sweep = ?");
    divergences.bind(1, sweep_.row);
    if (divergences.step()) equal("divergences", sweep_.divergences, divergences.bits(0));

    if (sweep_.state == SweepState::deleting) return;  // its audits go first
    Statement audited(connection, "SELECT count(DISTINCT job) FROM audit_job JOIN audit USING (audit) WHERE sweep = ?");
    audited.bind(1, sweep_.row);
    if (audited.step()) equal("audited", sweep_.audited, audited.bits(0));
  }

  void state() const {
    const bool ended = sweep_.state == SweepState::finished || sweep_.state == SweepState::cancelled ||
                       sweep_.state == SweepState::deleting;
    if (ended != sweep_.ended_unix_milliseconds.has_value()) {
      add("ended", ended ? "nothing is stored although the sweep has ended" : "stored although the sweep goes on");
    }
    if (!ended && sweep_.counts.ended() == sweep_.what.jobs) {
      add("state", "stored " + to_text(sweep_.state) + " although all jobs have ended");
    }
    if (sweep_.state == SweepState::finished && sweep_.counts.ended() != sweep_.what.jobs) {
      add("state", "stored finished although only " + std::to_string(sweep_.counts.ended()) + " of " +
                       std::to_string(sweep_.what.jobs) + " jobs have ended");
    }
  }

 private:
  const Sweep& sweep_;
  std::vector<Discrepancy>& found_;
};

}  // namespace

std::optional<experiment::SweepGrid> verify_sweep(const Connection& connection, const Sweep& sweep,
                                                  std::vector<Discrepancy>& discrepancies) {
  const SweepCheck check(sweep, discrepancies);
  auto grid = check.specification();
  check.equal("science_version", sweep.science_version, experiment::science_version);
  check.checksum(connection);
  check.counters(connection);
  check.state();
  return grid;
}

}  // namespace lamprey::storage
