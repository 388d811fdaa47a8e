#include "tests/storage/support.hpp"

#include <algorithm>
#include <fstream>
#include <random>
#include <stdexcept>
#include <unistd.h>

namespace lamprey::storage::testing {

TemporaryDirectory::TemporaryDirectory() {
  std::string pattern = (std::filesystem::temp_directory_path() / "lamprey-storage-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make " + pattern);
  path_ = pattern;
}

TemporaryDirectory::~TemporaryDirectory() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

SweepCase sweep_case(const idl::SweepSpecification& specification, const std::string& source) {
  experiment::SweepGrid grid(specification);
  NewSweep what{.id = experiment::sweep_id(specification),
                .name = specification.name(),
                .specification = specification.SerializeAsString(),
                .source = source,
                .seed = specification.seed(),
                .replicates = specification.replicates(),
                .jobs = grid.jobs()};
  return {specification, std::move(grid), std::move(what)};
}

SweepCase operator_sweep(const std::string& name, std::uint32_t replicates) {
  idl::SweepSpecification specification;
  specification.set_name(name);
  specification.set_seed(2006);
  specification.set_replicates(replicates);
  auto* setting = specification.add_base();
  setting->set_parameter("required_distance");
  setting->mutable_value()->set_integer(50);
  auto* grid = specification.add_grids();
  const auto axis = [&](const std::string& parameter, const std::vector<std::string>& values) {
    auto* added = grid->add_axes();
    added->set_parameter(parameter);
    for (const auto& value : values) added->add_values()->set_text(value);
  };
  axis("mutation", {"all", "one", "some"});
  axis("steps", {"uniform", "normal", "one_fifth_rule"});
  axis("acceptance", {"simple", "annealing"});
  return sweep_case(specification, "name: " + name + "\n");
}

SweepCase robot_sweep(const std::string& name) {
  idl::SweepSpecification specification;
  specification.set_name(name);
  specification.set_seed(9);
  specification.set_replicates(1);
  auto* grid = specification.add_grids();
  const auto axis = [&](const std::string& parameter, const std::vector<std::string>& values) {
    auto* added = grid->add_axes();
    added->set_parameter(parameter);
    for (const auto& value : values) added->add_values()->set_text(value);
  };
  axis("robot", {"bridge", "quadruped"});
  axis("mutation", {"all", "one"});
  axis("acceptance", {"simple", "annealing"});
  return sweep_case(specification, "name: " + name + "\n");
}

RobotRecording made_up_recording(std::uint64_t number) {
  std::mt19937_64 random(number);
  const auto positions = [&](std::size_t rows) {
    std::vector<std::int32_t> made(rows * robot_servos);
    for (auto& position : made) position = static_cast<std::int32_t>(random() % 3100) - 50;
    return made;
  };
  const auto one_try = [&](std::uint32_t evaluation, std::uint32_t attempt, std::size_t rows, const std::string& why) {
    RobotTry made{.evaluation = evaluation,
                  .attempt = attempt,
                  .voided = why,
                  .measured = true,
                  .commanded = positions(rows),
                  .reported = positions(rows),
                  .feet_down = {}};
    for (std::size_t row = 0; row < rows; ++row) made.feet_down.push_back(static_cast<std::int32_t>(random() % 16));
    return made;
  };
  return {.robot = "lamprey-1",
          .token = 40 + number,
          .tries = {one_try(0, 0, 2, "step 2 came 31 ms late"), one_try(0, 1, 4, ""), one_try(1, 0, 4, "")}};
}

experiment::Outcome made_up_outcome(std::uint64_t number, std::uint32_t rows) {
  std::mt19937_64 random(number);
  const auto next = [&] { return static_cast<double>(random() % 100000) / 997.0; };
  const auto score = [&] {
    experiment::Score made{next(), next(), next(), 0};
    made.total = made.stability + 0.5 * made.distance + made.fuel;
    return made;
  };
  experiment::Outcome outcome;
  outcome.expected = {80, 60, 83, 193};
  outcome.initial = score();
  outcome.evolved = outcome.highest = outcome.final = outcome.initial;
  outcome.cycles = 10 * rows + 7;
  outcome.successes = rows / 2;
  outcome.success_rate = static_cast<double>(outcome.successes) / outcome.cycles;
  for (std::uint32_t row = 0; row < rows; ++row) {
    outcome.trace.push_back({10 * row + 3, score()});
    outcome.final = outcome.trace.back().score;
    if (outcome.final.total > outcome.highest.total) outcome.highest = outcome.final;
    if (row == rows / 2) outcome.evolved = outcome.final;
  }
  outcome.accepted = rows;
  return outcome;
}

EndedJob done_job(const SweepCase& sweep, std::int64_t row, std::uint64_t number, const experiment::Outcome& outcome) {
  const auto job = sweep.grid.job(number);
  EndedJob ended;
  ended.sweep = row;
  ended.job = number;
  ended.state = JobState::done;
  ended.identity = experiment::identity(job);
  ended.digest = experiment::outcome_digest(*ended.identity, outcome);
  ended.parameters = experiment::to_json(job.parameters);
  ended.seed = job.seed;
  ended.replicate = job.replicate;
  ended.outcome = outcome;
  ended.seconds = 0.004;
  ended.worker = 0xfedcba9876543210;
  return ended;
}

EndedJob done_job(const SweepCase& sweep, std::int64_t row, std::uint64_t number) {
  return done_job(sweep, row, number, made_up_outcome(number));
}

EndedJob ended_job(const SweepCase& sweep, std::int64_t row, std::uint64_t number, JobState state,
                   const std::string& reason) {
  EndedJob ended = done_job(sweep, row, number);
  ended.state = state;
  ended.digest.reset();
  ended.outcome.reset();
  ended.reason = reason;
  if (state == JobState::cancelled) {
    ended.identity.reset();
    ended.parameters.clear();
    ended.worker = 0;
    ended.seed = 0;
    ended.seconds = 0;
  }
  return ended;
}

Connection raw_connection(const std::string& path) {
  return {path, SQLITE_OPEN_READWRITE, ""};
}

std::vector<std::string> column_of(const ResultsReader& reader, const std::string& sql) {
  std::vector<std::string> values;
  for (const auto& row : reader.query(sql).rows) values.push_back(row.at(0));
  return values;
}

std::string value_of(const ResultsReader& reader, const std::string& sql) {
  const auto table = reader.query(sql);
  if (table.rows.size() != 1) throw std::runtime_error(std::to_string(table.rows.size()) + " rows: " + sql);
  return table.rows[0].at(0);
}

std::string bytes_of(const std::string& path) {
  if (!std::filesystem::is_regular_file(path)) return {};
  // At once: octet by octet this would be most of a test's time under a sanitizer.
  std::string bytes(std::filesystem::file_size(path), '\0');
  std::ifstream(path, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return bytes;
}

void write_bytes(const std::string& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

std::string text_of(const Verification& verification) {
  std::string text;
  for (const auto& found : verification.discrepancies) {
    text += found.sweep + (found.job ? " job " + std::to_string(*found.job) : "") + " " + found.column + ": " +
            found.text + "\n";
  }
  return text;
}

}  // namespace lamprey::storage::testing
