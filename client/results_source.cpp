#include "client/results_source.hpp"

#include "client/failure.hpp"
#include "client/option_checks.hpp"

#include <algorithm>
#include <limits>
#include <memory>

namespace lamprey::client {

namespace {

constexpr std::uint64_t rows_per_page = 1000;

/// The number of the last row's job, plus one.
std::uint64_t after_last(const storage::ResultsReader::Table& table) {
  const auto column = std::ranges::find(table.columns, "job");
  return std::stoull(table.rows.back().at(static_cast<std::size_t>(column - table.columns.begin()))) + 1;
}

}  // namespace

storage::Sweep require_sweep(const storage::ResultsReader& reader, const std::string& path,
                             const std::string& name_or_id) {
  if (auto sweep = reader.find_sweep(name_or_id)) return std::move(*sweep);
  const auto sweeps = reader.sweeps();
  if (sweeps.empty()) throw Failure(exit_usage, "unknown_sweep", path + " has no sweeps yet");
  std::vector<std::string_view> names;
  for (const auto& sweep : sweeps) names.emplace_back(sweep.what.name);
  throw Failure(exit_usage, "unknown_sweep", path + ": " + unknown_name("sweep", name_or_id, names));
}

ResultsSource results_of_database(const std::string& path, const std::string& sweep) {
  const auto reader = std::make_shared<const storage::ResultsReader>(path);
  const std::string name = require_sweep(*reader, path, sweep).what.name;
  return [reader, name](std::uint64_t first_job, std::uint64_t most) {
    const std::uint64_t limit = std::min(most, rows_per_page);
    auto table = reader->results(name, first_job, limit);
    ResultsPage page;
    if (table.rows.size() == limit) page.next_job = after_last(table);
    page.columns = std::move(table.columns);
    page.rows = std::move(table.rows);
    return page;
  };
}

ResultsSource results_of_coordinator(CoordinatorConnection& connection, const std::string& sweep) {
  return [&connection, sweep](std::uint64_t first_job, std::uint64_t most) {
    idl::Request request;
    request.mutable_results()->set_sweep(sweep);
    request.mutable_results()->set_first_job(first_job);
    request.mutable_results()->set_limit(static_cast<std::uint32_t>(std::min(most, rows_per_page)));
    const auto reply = connection.ask_for_success(request);
    ResultsPage page;
    page.columns.assign(reply.results().columns().begin(), reply.results().columns().end());
    for (const auto& row : reply.results().rows()) {
      if (row.values_size() != reply.results().columns_size()) {
        throw Failure(exit_failure, "malformed", "the coordinator's reply has a row that does not fit its columns");
      }
      page.rows.emplace_back(row.values().begin(), row.values().end());
    }
    // A page that does not lead on would be asked for for ever.
    if (reply.results().has_next_job() && reply.results().next_job() > first_job) {
      page.next_job = reply.results().next_job();
    }
    return page;
  };
}

bool read_results(const ResultsSource& source, std::uint64_t limit,
                  const std::function<void(const ResultsPage&)>& take) {
  std::uint64_t left = limit == 0 ? std::numeric_limits<std::uint64_t>::max() - 1 : limit;
  std::uint64_t first_job = 0;
  while (true) {
    // One row more than is wanted tells whether there are more.
    ResultsPage page = source(first_job, left + 1);
    const bool more = page.rows.size() > left;
    if (more) page.rows.resize(left);
    left -= page.rows.size();
    take(page);
    if (more || !page.next_job) return more;
    first_job = *page.next_job;
  }
}

}  // namespace lamprey::client
