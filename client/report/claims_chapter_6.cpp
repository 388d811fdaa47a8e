#include "client/report/claims.hpp"
#include "client/report/judgement.hpp"

#include <algorithm>
#include <map>
#include <vector>

/// Claims 8 and 9: the biped's networks under the II-RTEA and the genetic algorithm (6.2.2.4, 6.2.2.5, 6.2.2.7).
namespace lamprey::client::report {

namespace {

using statistics::Sample;
using statistics::welch_interval;

const char* const final_total = "final_total";
const char* const recurrent = "recurrent_pair";
const char* const feed_forward = "feed_forward_pair";

/// A row per network and mutation rate: n (jobs), and mean and mean of squares of final_total, of the gain from the
/// first total to the last, and of the largest single rise of the total in a job's trace.
std::string networks_sql(const Reading& reading) {
  const std::string condition = reading.condition();
  return "WITH chosen AS (\n"
         "  SELECT sweep, job, network, mutation_rate, initial_total, final_total\n"
         "  FROM result\n  WHERE " +
         condition +
         "),\nrise AS (\n"
         "  SELECT t.sweep, t.job,\n"
         "    t.total - lag(t.total, 1, c.initial_total) OVER (PARTITION BY t.sweep, t.job ORDER BY t.cycle) AS rise\n"
         "  FROM chosen AS c JOIN trace AS t ON t.sweep = c.sweep AND t.job = c.job),\n"
         "jump AS (SELECT sweep, job, max(rise) AS jump FROM rise GROUP BY sweep, job),\n"
         "whole AS (\n"
         "  SELECT c.*, c.final_total - c.initial_total AS gain, max(coalesce(j.jump, 0), 0) AS jump\n"
         "  FROM chosen AS c LEFT JOIN jump AS j ON j.sweep = c.sweep AND j.job = c.job)\n"
         "SELECT network, mutation_rate, count(*) AS n, sum(gain > 0) AS gained,\n"
         "  avg(final_total) AS final_total, avg(final_total * final_total) AS final_total_squared,\n"
         "  avg(gain) AS gain, avg(gain * gain) AS gain_squared, avg(jump) AS jump, avg(jump * jump) AS jump_squared\n"
         "FROM whole GROUP BY network, mutation_rate ORDER BY network, mutation_rate";
}

/// The rows of networks_sql by network and rate.
class Networks {
 public:
  explicit Networks(Rows rows) : rows_(std::move(rows)) {}

  std::optional<std::size_t> row(const std::string& network, double rate) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_.text(i, "network") == network && rows_.number(i, "mutation_rate") == rate) return i;
    }
    return std::nullopt;
  }
  /// An empty sample if there are no such jobs.
  Sample sample(const std::string& network, double rate, const std::string& column) const {
    const auto found = row(network, rate);
    return found ? sample_in(rows_, *found, column) : Sample{};
  }
  std::vector<double> rates(const std::string& network) const {
    std::vector<double> rates;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (const auto rate = rows_.number(i, "mutation_rate"); rate && rows_.text(i, "network") == network)
        rates.push_back(*rate);
    }
    return rates;
  }
  const Rows& rows() const { return rows_; }

 private:
  Rows rows_;
};

std::string percent(double rate) {
  return figure(rate) + " %";
}

/// Both samples as one.
Sample pooled(const Sample& a, const Sample& b) {
  if (a.size == 0) return b;
  if (b.size == 0) return a;
  const auto squares = [](const Sample& sample) {
    const auto n = static_cast<double>(sample.size);
    return sample.variance * (n - 1) + n * sample.mean * sample.mean;
  };
  const auto n = static_cast<double>(a.size + b.size);
  const double mean = (a.mean * static_cast<double>(a.size) + b.mean * static_cast<double>(b.size)) / n;
  return statistics::sample_of_moments(a.size + b.size, mean, (squares(a) + squares(b)) / n);
}

}  // namespace

std::vector<Part> assess_biped_real_time(const Evidence& evidence, const Reading& reading) {
  const auto sql = networks_sql(reading);
  const Networks networks(evidence.query(sql));
  std::vector<Part> parts;
  for (const double rate : {50.0, 75.0, 100.0}) {
    parts.push_back(
        part_of("jump at " + percent(rate) + ": recurrent - feed-forward", "above 0",
                "Climbs or jumps: a job's jump is the largest single rise of the total in its trace; Welch's "
                "95 % interval of the difference of the mean jumps lies above 0 (figs 6.30, 6.31).",
                sql));
    const auto interval = welch_interval(networks.sample(recurrent, rate, "jump"),
                                         networks.sample(feed_forward, rate, "jump"), confidence);
    parts.back().measured.push_back(above("largest_rise", interval, 0));
  }
  for (const double rate : {75.0, 100.0}) {
    parts.push_back(part_of("fitness at " + percent(rate) + ": feed-forward - recurrent", "above 0",
                            "Wins: Welch's 95 % interval of the difference of the mean final totals lies above 0.",
                            sql));
    const auto interval = welch_interval(networks.sample(feed_forward, rate, final_total),
                                         networks.sample(recurrent, rate, final_total), confidence);
    parts.back().measured.push_back(above(final_total, interval, 0));
  }
  parts.push_back(
      part_of("feed-forward at 25 %: jobs that gain", "none",
              "Gains nothing: at 25 % the final total of no feed-forward job is above its initial one; with "
              "Wilson's 95 % interval of the share.",
              sql));
  parts.back().unit = "%";
  if (const auto row = networks.row(feed_forward, 25)) {
    const auto gained = static_cast<std::uint64_t>(networks.rows().number(*row, "gained").value_or(0));
    const auto jobs = static_cast<std::uint64_t>(networks.rows().number(*row, "n").value_or(0));
    const auto share = in_per_cent(statistics::wilson_interval(gained, jobs, confidence));
    parts.back().measured.push_back(judged(final_total, share, gained == 0));
  }
  return parts;
}

namespace {

/// Which rate is best, and from which to which rate none can be told from it.
Part best_rate(const Networks& networks, const std::string& network, const std::string& name, const std::string& sql) {
  Part part =
      part_of(name + ": best mutation rate", "62.5 to 87.5 %",
              "Best mutation rate near 75 %: the rate with the highest mean final total is 62.5, 75 or 87.5 %; in "
              "brackets the rates whose mean Welch's 95 % interval cannot tell from the best.",
              sql);
  part.unit = "%";
  const auto rates = networks.rates(network);
  if (!std::ranges::binary_search(rates, 12.5) || rates.size() < 8) return part;
  const auto mean = [&](double rate) { return networks.sample(network, rate, final_total).mean; };
  const double best = *std::ranges::max_element(rates, {}, mean);
  statistics::Interval interval{best, best, best, confidence, 0};
  for (const double rate : rates) {
    const auto sample = networks.sample(network, rate, final_total);
    interval.size += sample.size;
    const auto behind = welch_interval(networks.sample(network, best, final_total), sample, confidence);
    if (!behind || behind->low > 0) continue;
    interval.low = std::min(interval.low, rate);
    interval.high = std::max(interval.high, rate);
  }
  part.measured.push_back(judged(final_total, interval, best >= 62.5 && best <= 87.5));
  return part;
}

Part jumps_at_low_rates(const Networks& networks, const std::string& network, const std::string& name,
                        const std::string& sql) {
  Part part =
      part_of(name + ": jump at 25, 50 % - at 75, 100 %", "above 0",
              "Jumps at low rates (6.2.2.4, of the feed-forward network): Welch's 95 % interval of the difference "
              "of the mean largest rises, rates 25 and 50 % less 75 and 100 %, lies above 0. The recurrent network "
              "is shown beside and judges nothing.",
              sql);
  const auto both = [&](double a, double b) {
    return pooled(networks.sample(network, a, "jump"), networks.sample(network, b, "jump"));
  };
  part.measured.push_back(above("largest_rise", welch_interval(both(25, 50), both(75, 100), confidence), 0));
  return part;
}

}  // namespace

std::vector<Part> assess_biped_population(const Evidence& evidence, const Reading& reading) {
  // Four rates are in both sweeps: each part takes its jobs from one, lest they count twice.
  Reading performance = reading;
  performance.sweeps = {"figure-6-25"};
  Reading all_rates = reading;
  all_rates.sweeps = {"figure-6-27"};
  const auto sql = networks_sql(performance);
  const auto rates_sql = networks_sql(all_rates);
  const Networks networks(evidence.query(sql));
  const Networks at_all_rates(evidence.query(rates_sql));
  std::vector<Part> parts;
  for (const double rate : {25.0, 50.0, 75.0, 100.0}) {
    const bool ahead = rate != 25;
    parts.push_back(part_of("fitness at " + percent(rate) + ": recurrent - feed-forward",
                            ahead ? "above 0" : "not above 0",
                            "Slightly ahead except at 25 %: Welch's 95 % interval of the difference of the mean final "
                            "totals lies above 0 at 50, 75 and 100 %, and not at 25 %.",
                            sql));
    const auto interval = welch_interval(networks.sample(recurrent, rate, final_total),
                                         networks.sample(feed_forward, rate, final_total), confidence);
    parts.back().measured.push_back(ahead ? above(final_total, interval, 0)
                                          : judged(final_total, interval, interval && interval->low <= 0));
  }
  parts.push_back(jumps_at_low_rates(networks, feed_forward, "feed-forward", sql));
  parts.push_back(jumps_at_low_rates(networks, recurrent, "recurrent", sql));
  parts.back().decisive = false;
  for (const auto& [network, name] : {std::pair{feed_forward, "feed-forward"}, std::pair{recurrent, "recurrent"}}) {
    parts.push_back(best_rate(at_all_rates, network, name, rates_sql));
    parts.push_back(
        part_of(std::string(name) + ": fitness at 75 % - at 100 %", "above 0",
                "Falls beyond 75 % (6.2.2.5): Welch's 95 % interval of the difference of the mean final totals "
                "lies above 0.",
                rates_sql));
    const auto interval = welch_interval(at_all_rates.sample(network, 75, final_total),
                                         at_all_rates.sample(network, 100, final_total), confidence);
    parts.back().measured.push_back(above(final_total, interval, 0));
  }
  return parts;
}

}  // namespace lamprey::client::report
