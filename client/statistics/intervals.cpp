#include "client/statistics/intervals.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace lamprey::client::statistics {

namespace {

double upper_probability(double confidence) {
  return 0.5 + confidence / 2;
}

Interval around(double estimate, double half_width, double confidence, std::uint64_t size) {
  return {estimate, estimate - half_width, estimate + half_width, confidence, size};
}

}  // namespace

Sample sample_of(std::span<const double> values) {
  Sample sample{.size = values.size()};
  if (values.empty()) return sample;
  for (const double value : values) sample.mean += value;
  sample.mean /= static_cast<double>(values.size());
  if (values.size() < 2) return sample;
  for (const double value : values) sample.variance += (value - sample.mean) * (value - sample.mean);
  sample.variance /= static_cast<double>(values.size() - 1);
  return sample;
}

Sample sample_of_moments(std::uint64_t size, double mean, double mean_of_squares) {
  Sample sample{.size = size, .mean = mean};
  if (size < 2) return sample;
  const auto n = static_cast<double>(size);
  sample.variance = std::max(0.0, mean_of_squares - mean * mean) * n / (n - 1);
  return sample;
}

double student_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

std::optional<Interval> mean_interval(const Sample& sample, double confidence) {
  if (sample.size < 2) return std::nullopt;
  const auto n = static_cast<double>(sample.size);
  const double half_width = student_quantile(upper_probability(confidence), n - 1) * std::sqrt(sample.variance / n);
  return around(sample.mean, half_width, confidence, sample.size);
}

std::optional<Interval> welch_interval(const Sample& first, const Sample& second, double confidence) {
  if (first.size < 2 || second.size < 2) return std::nullopt;
  const auto first_size = static_cast<double>(first.size);
  const auto second_size = static_cast<double>(second.size);
  const double first_part = first.variance / first_size;
  const double second_part = second.variance / second_size;
  const double difference = first.mean - second.mean;
  const std::uint64_t size = first.size + second.size;
  const double variance = first_part + second_part;
  if (variance == 0) return around(difference, 0, confidence, size);
  const double degrees_of_freedom =
      variance * variance /
      (first_part * first_part / (first_size - 1) + second_part * second_part / (second_size - 1));
  const double half_width = student_quantile(upper_probability(confidence), degrees_of_freedom) * std::sqrt(variance);
  return around(difference, half_width, confidence, size);
}

std::optional<Interval> wilson_interval(std::uint64_t successes, std::uint64_t trials, double confidence) {
  if (trials == 0) return std::nullopt;
  const auto n = static_cast<double>(trials);
  const double share = static_cast<double>(successes) / n;
  const double z = boost::math::quantile(boost::math::normal(), upper_probability(confidence));
  const double centre = (share + z * z / (2 * n)) / (1 + z * z / n);
  const double half_width = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return Interval{share, std::max(0.0, centre - half_width), std::min(1.0, centre + half_width), confidence, trials};
}

std::optional<PlaneSlopes> plane_slopes(std::span<const Cell> cells, double confidence) {
  std::uint64_t size = 0;
  Cell sum;
  for (const auto& cell : cells) {
    const auto weight = static_cast<double>(cell.values.size);
    size += cell.values.size;
    sum.x += weight * cell.x;
    sum.y += weight * cell.y;
    sum.values.mean += weight * cell.values.mean;
  }
  if (size < 4) return std::nullopt;
  const auto n = static_cast<double>(size);
  const Cell mean{sum.x / n, sum.y / n, {.size = size, .mean = sum.values.mean / n, .variance = 0}};
  double xx = 0;
  double xy = 0;
  double yy = 0;
  double x_value = 0;
  double y_value = 0;
  for (const auto& cell : cells) {
    const auto weight = static_cast<double>(cell.values.size);
    const double x = cell.x - mean.x;
    const double y = cell.y - mean.y;
    xx += weight * x * x;
    xy += weight * x * y;
    yy += weight * y * y;
    x_value += weight * x * (cell.values.mean - mean.values.mean);
    y_value += weight * y * (cell.values.mean - mean.values.mean);
  }
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-12 * xx * yy)) return std::nullopt;
  const double x_slope = (x_value * yy - y_value * xy) / determinant;
  const double y_slope = (y_value * xx - x_value * xy) / determinant;
  double residual = 0;
  for (const auto& cell : cells) {
    const double rest = cell.values.mean - mean.values.mean - x_slope * (cell.x - mean.x) - y_slope * (cell.y - mean.y);
    const auto weight = static_cast<double>(cell.values.size);
    residual += weight * rest * rest + cell.values.variance * std::max(0.0, weight - 1);
  }
  const double variance = residual / (n - 3);
  const double t = student_quantile(upper_probability(confidence), n - 3);
  return PlaneSlopes{around(x_slope, t * std::sqrt(variance * yy / determinant), confidence, size),
                     around(y_slope, t * std::sqrt(variance * xx / determinant), confidence, size)};
}

bool equivalent(const Interval& interval, double margin) {
  // Nothing but zeros is equal by any margin, also by one that is a share of zero.
  if (interval.low == 0 && interval.high == 0) return true;
  return interval.low > -margin && interval.high < margin;
}

}  // namespace lamprey::client::statistics
