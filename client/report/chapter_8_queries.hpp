#pragma once

#include "client/evidence.hpp"

#include <string>
#include <vector>

/// Queries on the grid of chapter 8. Each is plain SQL that anyone can run on the database.
namespace lamprey::client::report {

/// The totals that claims on fitness are judged on, and the rate of successes.
extern const std::vector<std::string> fitness_columns;  ///< evolved_total, highest_total
extern const std::vector<std::string> grid_axes;        ///< mutation technique, and the columns of fig. 8.1

/// A comparison within cells: jobs that agree in all axes that are not compared.
struct Pairing {
  std::vector<std::string> kept;  ///< a row of the answer per combination of these
  std::string first;              ///< SQL conditions: which jobs of a cell are compared, first − second
  std::string second;
  std::vector<std::string> differing;  ///< the axes in which jobs of a cell need not agree
  std::string among = {};              ///< further condition on all jobs
};

/// Rows with the kept columns, n (cells), expected and success_level (means over both), and for evolved_total,
/// highest_total and success_rate the mean of the differences and of their squares (…_squared).
std::string pairing_sql(const Reading& reading, const Pairing& pairing);

/// Rows with the kept columns, n (jobs), expected, and means and means of squares of evolved_total, highest_total,
/// success_rate, and of evolved_total_reached and highest_total_reached: the total less the expected one.
std::string averages_sql(const Reading& reading, const std::vector<std::string>& kept, const std::string& among);

/// "a, b, c".
std::string column_list(const std::vector<std::string>& columns);

}  // namespace lamprey::client::report
