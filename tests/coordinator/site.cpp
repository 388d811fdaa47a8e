#include "tests/coordinator/site.hpp"

#include "storage/results_reader.hpp"

#include <algorithm>
#include <atomic>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <unistd.h>
#include <utility>

namespace lamprey::tests {

namespace {

constexpr auto step_time = std::chrono::milliseconds{25};

std::filesystem::path fresh_directory() {
  static std::atomic<int> counter{0};
  auto path = std::filesystem::temp_directory_path() /
              ("lamprey-site-" + std::to_string(::getpid()) + "-" + std::to_string(counter++));
  std::filesystem::create_directories(path);
  return path;
}

}  // namespace

void SteppedExecutor::submit(std::vector<worker::Task> tasks) {
  for (auto& task : tasks) queue_.push_back(std::move(task));
}

std::vector<worker::FinishedTask> SteppedExecutor::take_finished() {
  std::vector<worker::FinishedTask> finished;
  const std::size_t count = std::min(jobs_per_step, queue_.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (before_job) before_job(queue_[i]);
    if (gives_back && gives_back(queue_[i])) {
      finished.push_back({queue_[i], {.identity = {}, .result = experiment::Interrupted{}}});
      continue;
    }
    computed.insert(queue_[i].job);
    const std::vector<experiment::Job> job{queue_[i].grid->job(queue_[i].job)};
    if (fails && fails(queue_[i])) {
      const auto identity = experiment::identity(job.front());
      finished.push_back({queue_[i], {identity, experiment::Failure{"it was told to"}}});
      continue;
    }
    auto results = engine_->run(job, {});
    finished.push_back({queue_[i], std::move(results.front())});
  }
  queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(count));
  return finished;
}

std::vector<messaging::RunningJob> SteppedExecutor::running() const {
  std::vector<messaging::RunningJob> jobs;
  for (const auto& task : queue_) jobs.push_back({task.sweep, task.job});
  return jobs;
}

void SteppedExecutor::drop(const experiment::Id128& database, std::uint64_t lease) {
  std::erase_if(queue_, [&](const auto& task) { return task.database == database && task.lease == lease; });
}

Site::Site() : directory_(fresh_directory()) {}

Site::~Site() {
  coordinator_.reset();
  workers_.clear();
  std::filesystem::remove_all(directory_);
}

void Site::start_coordinator() {
  coordinator_participant_ = bus.join("coordinator");
  coordinator_ = std::make_unique<coordinator::Coordinator>(*coordinator_participant_,
                                                            storage::ResultsStore(database().string(), {.vfs = vfs}),
                                                            signal_, coordinator_options, now);
}

void Site::kill_coordinator() {
  bus.kill("coordinator");
  coordinator_.reset();
  coordinator_participant_.reset();
}

Site::WorkerProcess& Site::start_worker() {
  auto process = std::make_unique<WorkerProcess>();
  process->executor = std::make_unique<SteppedExecutor>();
  process->executor->jobs_per_step = jobs_per_step;
  auto& executor = *process->executor;
  return start(std::move(process), executor);
}

Site::WorkerProcess& Site::start_worker(std::unique_ptr<worker::JobExecutor> own) {
  auto process = std::make_unique<WorkerProcess>();
  process->own_executor = std::move(own);
  auto& executor = *process->own_executor;
  return start(std::move(process), executor);
}

Site::WorkerProcess& Site::start(std::unique_ptr<WorkerProcess> process, worker::JobExecutor& executor) {
  process->incarnation = next_incarnation_++;
  process->name = "worker " + std::to_string(process->incarnation);
  process->participant = bus.join(process->name);
  worker::WorkerOptions options;
  options.incarnation = process->incarnation;
  options.host = "host";
  options.process = static_cast<std::uint32_t>(process->incarnation);
  options.build = "test";
  options.processor = "a processor";
  options.outbox = outbox_options;
  process->worker = std::make_unique<worker::Worker>(*process->participant, executor, signal_, options, now);
  return *workers_.emplace_back(std::move(process));
}

void Site::kill_worker(std::size_t index) {
  auto& process = *workers_.at(index);
  bus.kill(process.name);
  if (process.executor) computed_by_the_dead_ += process.executor->computed.size();
  process.worker.reset();
  process.participant.reset();
  workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
}

void Site::advance(std::chrono::milliseconds time) {
  const auto until = now + time;
  while (now < until) {
    now += step_time;
    if (coordinator_) coordinator_->step(now);
    for (std::size_t i = 0; i < workers_.size();) {
      try {
        workers_[i]->worker->step(now);
        ++i;
      } catch (const SteppedExecutor::WorkerDied&) {
        kill_worker(i);
      }
    }
  }
}

bool Site::run_until(const std::function<bool()>& condition, std::chrono::seconds limit) {
  const auto until = now + limit;
  while (!condition()) {
    if (now >= until) return false;
    advance(step_time);
  }
  return true;
}

idl::Reply Site::ask(const idl::Request& request) {
  const std::uint64_t client = next_client_++;
  const auto participant = bus.join("client");
  const auto replies = participant->reader<messaging::Reply>(signal_, messaging::Partition::of(client));
  const auto requests = participant->writer<messaging::Request>();
  messaging::Request sample;
  sample.client = client;
  sample.correlation = 1;
  const auto bytes = request.SerializeAsString();
  sample.payload.assign(bytes.begin(), bytes.end());
  EXPECT_TRUE(static_cast<bool>(requests->write(sample)));
  std::vector<messaging::Reply> answers;
  EXPECT_TRUE(run_until([&] { return !(answers = replies->take()).empty(); }));
  idl::Reply reply;
  if (!answers.empty()) {
    EXPECT_TRUE(reply.ParseFromArray(answers.front().payload.data(), static_cast<int>(answers.front().payload.size())));
  }
  return reply;
}

void Site::submit(const std::string& yaml) {
  sweeps_.push_back(experiment::parse_sweep(yaml, "test.yaml"));
  idl::Request request;
  *request.mutable_submit()->mutable_specification() = sweeps_.back().specification;
  const auto reply = ask(request);
  ASSERT_TRUE(reply.has_submit()) << reply.DebugString();
}

std::uint64_t Site::number(const std::string& sql) {
  return std::stoull(storage::ResultsReader(database().string()).query(sql).rows.at(0).at(0));
}

void Site::write(const std::string& sql) {
  sqlite3* handle = nullptr;
  ASSERT_EQ(sqlite3_open(database().c_str(), &handle), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(handle, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(handle);
  sqlite3_close(handle);
}

std::uint64_t Site::rows(const std::string& where) {
  return number("SELECT count(*) FROM job WHERE " + where);
}

experiment::Id128 Site::database_id() const {
  return storage::ResultsReader(database().string()).database_id();
}

bool Site::ended() {
  return number("SELECT count(*) FROM sweep WHERE state IN ('running', 'cancelling')") == 0;
}

void Site::expect_complete() {
  const storage::ResultsReader reader(database().string());
  const auto engine = experiment::make_scalar_engine();
  std::uint64_t jobs = 0;
  for (const auto& file : sweeps_) {
    const experiment::SweepGrid grid(file.specification);
    const auto sweep = reader.find_sweep(file.specification.name());
    ASSERT_TRUE(sweep.has_value());
    EXPECT_EQ(sweep->state, storage::SweepState::finished);
    EXPECT_EQ(sweep->counts.done, grid.jobs());
    jobs += grid.jobs();
    for (std::uint64_t number = 0; number < grid.jobs(); ++number) {
      const auto stored = reader.job(sweep->row, number);
      ASSERT_TRUE(stored.has_value()) << "job " << number;
      const std::vector<experiment::Job> job{grid.job(number)};
      const auto result = engine->run(job, {});
      const auto& outcome = std::get<experiment::Outcome>(result.front().result);
      EXPECT_EQ(stored->digest, experiment::outcome_digest(result.front().identity, outcome)) << "job " << number;
    }
  }
  EXPECT_EQ(rows(), jobs);
  EXPECT_EQ(number("SELECT count(*) FROM divergence"), 0U);
}

std::size_t Site::computed() const {
  std::size_t count = computed_by_the_dead_;
  for (const auto& process : workers_) count += process->executor ? process->executor->computed.size() : 0;
  return count;
}

std::string small_sweep(const std::string& name, std::uint64_t jobs) {
  return "name: " + name +
         "\nseed: 7\nbase: {cycles: 3, mutation: all}\ngrids:\n  - {required_stability: [25, 50, 75, "
         "100]}\nreplicates: " +
         std::to_string(jobs / 4) + "\n";
}

}  // namespace lamprey::tests
