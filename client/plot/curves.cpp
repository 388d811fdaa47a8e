#include "client/plot/curves.hpp"

#include "client/failure.hpp"
#include "client/output/formatting.hpp"

#include <algorithm>
#include <cmath>

namespace lamprey::client::plot {

namespace {

constexpr std::size_t samples = 200;

/// Each job's first row has no cycle; its steps follow. An outer join would do the same, but SQLite would take apart
/// the traces of all jobs of the database for it.
std::string courses_sql(const Reading& reading, const std::vector<std::string>& group_by, const std::string& condition,
                        bool with_variation) {
  std::string groups;
  std::string kept;
  for (const auto& column : group_by) {
    groups += column + ", ";
    kept += "c." + column + ", ";
  }
  const std::string job = groups + "sweep, job, cycles, initial_total, expected_total";
  return "WITH chosen AS (\n  SELECT " + job + " FROM result\n  WHERE " + reading.condition() +
         (condition.empty() ? "" : " AND " + condition) + ")\nSELECT " + job + ", NULL AS cycle, NULL AS total" +
         (with_variation ? ", NULL AS parameter_variation" : "") + " FROM chosen\nUNION ALL SELECT " + kept +
         "c.sweep, c.job, c.cycles, c.initial_total, c.expected_total, t.cycle, t.total" +
         (with_variation ? ", t.parameter_variation" : "") + "\nFROM chosen AS c JOIN " +
         (with_variation ? "variation" : "trace") + " AS t ON t.sweep = c.sweep AND t.job = c.job\nORDER BY " + groups +
         "sweep, job, cycle";
}

/// One job's steps.
struct Job {
  double cycles = 0;
  double initial = 0;
  double expected = 0;
  std::vector<double> at;
  std::vector<double> total;
  std::vector<double> variation;
};

void add(Course& course, const Job& job) {
  if (course.cycles.empty()) {
    const auto count = std::min<double>(samples, job.cycles);
    for (double i = 0; i <= count; ++i) course.cycles.push_back(std::round(job.cycles * i / std::max(count, 1.0)));
    course.total.assign(course.cycles.size(), 0);
    course.variation.assign(course.cycles.size(), 0);
  }
  ++course.jobs;
  course.expected += job.expected;
  std::size_t next = 0;
  for (std::size_t i = 0; i < course.cycles.size(); ++i) {
    while (next < job.at.size() && job.at[next] < course.cycles[i]) ++next;  // cycle c has ended c + 1 cycles in
    course.total[i] += next == 0 ? job.initial : job.total[next - 1];
    course.variation[i] += next == 0 ? 0 : job.variation[next - 1];
  }
}

void finish(Course& course, bool with_variation) {
  const auto jobs = static_cast<double>(course.jobs);
  course.expected /= jobs;
  for (double& value : course.total) value /= jobs;
  for (double& value : course.variation) value /= jobs;
  if (!with_variation) course.variation.clear();
}

void check_number_of_jobs(const Evidence& evidence, const Reading& reading, const std::string& condition) {
  const auto rows = evidence.query("SELECT count(*) AS jobs FROM result WHERE " + reading.condition() +
                                   (condition.empty() ? "" : " AND " + condition));
  const double jobs = rows.number(0, "jobs").value_or(0);
  if (jobs <= static_cast<double>(most_jobs_of_courses)) return;
  throw Failure(exit_usage, "too_many_jobs",
                output::counted(static_cast<std::uint64_t>(jobs), "job", "jobs") + " are more than the " +
                    output::with_thousands(most_jobs_of_courses) +
                    " whose traces are averaged; choose with --jobs or PARAMETER=VALUE");
}

}  // namespace

std::vector<Course> courses(const Evidence& evidence, const Reading& reading, const std::vector<std::string>& group_by,
                            const std::string& condition, bool with_variation) {
  check_number_of_jobs(evidence, reading, condition);
  const auto rows = evidence.query(courses_sql(reading, group_by, condition, with_variation));
  std::vector<Course> all;
  for (std::size_t row = 0; row < rows.size();) {
    const auto sweep = rows.text(row, "sweep");
    const auto number = rows.text(row, "job");
    Job job{.cycles = rows.number(row, "cycles").value_or(0),
            .initial = rows.number(row, "initial_total").value_or(0),
            .expected = rows.number(row, "expected_total").value_or(0),
            .at = {},
            .total = {},
            .variation = {}};
    std::vector<std::string> group;
    for (const auto& column : group_by) group.push_back(rows.text(row, column));
    for (; row < rows.size() && rows.text(row, "job") == number && rows.text(row, "sweep") == sweep; ++row) {
      const auto cycle = rows.number(row, "cycle");
      if (!cycle) continue;
      job.at.push_back(*cycle);
      job.total.push_back(rows.number(row, "total").value_or(0));
      job.variation.push_back(with_variation ? rows.number(row, "parameter_variation").value_or(0) : 0);
    }
    if (all.empty() || all.back().group != group) all.push_back({.group = std::move(group)});
    add(all.back(), job);
  }
  for (auto& course : all) finish(course, with_variation);
  return all;
}

}  // namespace lamprey::client::plot
