#pragma once

#include "client/coordinator_connection.hpp"
#include "storage/results_reader.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lamprey::client {

/// Some rows of the view `result`, in order of job; each value is a JSON literal.
struct ResultsPage {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
  std::optional<std::uint64_t> next_job;  ///< where the next page begins; nothing at the end
};

/// Reads the page that begins at the first job from that number on, with at most so many rows (maybe fewer).
using ResultsSource = std::function<ResultsPage(std::uint64_t first_job, std::uint64_t most)>;

/// Throws Failure (unknown_sweep) with the nearest name.
storage::Sweep require_sweep(const storage::ResultsReader& reader, const std::string& path,
                             const std::string& name_or_id);

ResultsSource results_of_database(const std::string& path, const std::string& sweep);
ResultsSource results_of_coordinator(CoordinatorConnection& connection, const std::string& sweep);

/// Hands over the first `limit` rows (0: all) page by page, rows cut to the limit; whether there were more.
bool read_results(const ResultsSource& source, std::uint64_t limit,
                  const std::function<void(const ResultsPage&)>& take);

}  // namespace lamprey::client
