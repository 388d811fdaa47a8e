#pragma once

#include "client/evidence.hpp"

#include <cstddef>
#include <string>
#include <vector>

/// Mean courses of jobs over their cycles.
namespace lamprey::client::plot {

/// What jobs of a group had on average when a cycle had ended.
struct Course {
  std::vector<std::string> group = {};  ///< values of the columns grouped by, as people read them
  std::size_t jobs = 0;
  double expected = 0;  ///< mean expected total
  std::vector<double> cycles = {};
  std::vector<double> total = {};
  std::vector<double> variation = {};  ///< of the parameters; empty where it was not recorded
};

/// Jobs whose courses are averaged at most: each has its whole trace read.
inline constexpr std::size_t most_jobs_of_courses = 5000;

/// The course of every group of the reading's jobs, in the order of the groups' values, at some 200 evenly spaced
/// cycles; between accepted changes a total stays. `condition` (SQL) narrows the jobs; it may be empty. Throws Failure
/// (too_many_jobs).
std::vector<Course> courses(const Evidence& evidence, const Reading& reading, const std::vector<std::string>& group_by,
                            const std::string& condition, bool with_variation);

}  // namespace lamprey::client::plot
