#pragma once

#include <cstdint>
#include <optional>
#include <span>

/// Confidence intervals that findings rest on. Free functions; any thread. Two-sided; `confidence` is in 0..1 (0.95).
namespace lamprey::client::statistics {

/// What an interval of a mean needs to know of its values.
struct Sample {
  std::uint64_t size = 0;
  double mean = 0;
  double variance = 0;  ///< of the population, estimated: with n − 1; 0 for fewer than two values
};

Sample sample_of(std::span<const double> values);

/// From what SQL can sum up: the number of values, their mean and the mean of their squares. Exact enough where the
/// mean is not millions of times larger than the standard deviation.
Sample sample_of_moments(std::uint64_t size, double mean, double mean_of_squares);

struct Interval {
  double estimate = 0;
  double low = 0;
  double high = 0;
  double confidence = 0.95;
  std::uint64_t size = 0;  ///< values behind it
};

/// The value that Student's t with so many degrees of freedom stays below with that probability (0 < p < 1).
double student_quantile(double probability, double degrees_of_freedom);

/// Student's interval of the mean; of paired differences it is the paired t interval. Nothing for fewer than two
/// values.
std::optional<Interval> mean_interval(const Sample& sample, double confidence);

/// Welch's interval of the difference of two means, first − second: the variances may differ, with the degrees of
/// freedom of Welch and Satterthwaite. Nothing if a sample has fewer than two values.
std::optional<Interval> welch_interval(const Sample& first, const Sample& second, double confidence);

/// Wilson's score interval of a share, in 0..1; fit for shares of 0 and 1 too. Nothing if there are no trials.
std::optional<Interval> wilson_interval(std::uint64_t successes, std::uint64_t trials, double confidence);

/// Values that were measured at one place of a plane.
struct Cell {
  double x = 0;
  double y = 0;
  Sample values;
};

/// The slopes of the plane value = a + b x + c y that fits all values best (least squares), each with its t interval of
/// n − 3 degrees of freedom. Where only means count, each cell's sample is one value.
struct PlaneSlopes {
  Interval x;
  Interval y;
};

/// Nothing for fewer than four values, or where the cells lie on a line in (x, y).
std::optional<PlaneSlopes> plane_slopes(std::span<const Cell> cells, double confidence);

/// Two one-sided tests: at the level 1 − p the difference is smaller than the margin either way if and only if the
/// interval of confidence 1 − 2 (1 − p) lies within ±margin; so pass a 90 % interval for a test at 5 %.
bool equivalent(const Interval& interval, double margin);

}  // namespace lamprey::client::statistics
