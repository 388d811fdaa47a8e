#include "benchmarks/simulation/site.hpp"

#include "benchmarks/simulation/memory.hpp"
#include "experiment/sweep.hpp"

#include <algorithm>
#include <ctime>
#include <stdexcept>
#include <utility>

namespace lamprey::benchmarks {

namespace {

using namespace std::chrono_literals;
using messaging::in_memory::Envelope;
using messaging::in_memory::Fate;

constexpr auto resolution = 1ms;     // of the simulated clock
constexpr auto longest_wait = 25ms;  // as both programs' loops have it
constexpr auto patience = 1h;

double seconds(Clock::duration time) {
  return std::chrono::duration<double>(time).count();
}

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

}  // namespace

Site::Site(std::size_t workers, Clock::duration job_time, const std::string& database)
    : observer_(bus_.join("observer")),
      progress_(observer_->reader<messaging::SweepProgress>(nullptr)),
      participant_(bus_.join("coordinator")),
      coordinator_(std::make_unique<coordinator::Coordinator>(*participant_, storage::ResultsStore(database), signal_,
                                                              coordinator::CoordinatorOptions{}, now_)) {
  workers_.reserve(workers);
  for (std::size_t i = 0; i < workers; ++i) {
    workers_.push_back(make_worker(i + 1, job_time));
    // Nobody starts a thousand programs in one millisecond; and those that wait do not do so in step.
    workers_.back().due =
        now_ + Clock::duration{longest_wait} * static_cast<Clock::rep>(i) / static_cast<Clock::rep>(workers);
    workers_.back().has_mail = false;
  }
  bus_.on_sample([this](const Envelope& envelope) { return note(envelope); });
}

Site::SimulatedWorker Site::make_worker(std::uint64_t incarnation, Clock::duration job_time) {
  SimulatedWorker made;
  made.participant = bus_.join("worker " + std::to_string(incarnation));
  made.executor = std::make_unique<SimulatedExecutor>(*engine_, now_, job_time);
  worker::WorkerOptions options;
  options.incarnation = incarnation;
  options.host = "host" + std::to_string(incarnation);
  options.process = static_cast<std::uint32_t>(incarnation);
  options.build = "simulated";
  options.processor = "a simulated processor of some make";
  options.instruction_set = "none";
  made.worker = std::make_unique<worker::Worker>(*made.participant, *made.executor, nullptr, options, now_);
  return made;
}

Fate Site::note(const Envelope& envelope) {
  const auto now = coordinator_steps_ ? now_ + (Clock::now() - step_began_) : now_;
  if (const auto* batch = envelope.get<messaging::ResultBatch>()) latency_.note(*batch, now);
  if (const auto* lease = envelope.get<messaging::Lease>()) latency_.note(*lease, now);
  const auto receiver = envelope.partition.receiver;
  if (receiver > 0 && receiver <= workers_.size()) workers_[receiver - 1].has_mail = true;
  return Fate::deliver;
}

void Site::step_coordinator(Cost& cost) {
  const CountedAllocations counted;
  const double cpu = cpu_seconds();
  step_began_ = Clock::now();
  coordinator_steps_ = true;
  coordinator_->step(now_);
  coordinator_steps_ = false;
  const auto taken = Clock::now() - step_began_;
  now_ += taken;
  ++cost.steps;
  cost.cpu += cpu_seconds() - cpu;
  cost.wall += seconds(taken);
  cost.longest = std::max(cost.longest, seconds(taken));
}

void Site::tick(Cost& cost) {
  const auto began = now_;
  now_ += resolution;
  for (auto& each : workers_) {
    const auto end = each.executor->next_end();
    if (now_ < each.due && !each.has_mail && (!end || now_ < *end)) continue;
    each.has_mail = false;
    each.due = now_ + longest_wait;
    each.worker->step(now_);
  }
  if (signal_->wait_for(0ms) || now_ >= coordinator_due_) {
    step_coordinator(cost);
    coordinator_due_ = now_ + longest_wait;
  }
  cost.elapsed += seconds(now_ - began);
}

Cost Site::pass(Clock::duration time) {
  Cost cost;
  for (const auto until = now_ + time; now_ < until;) tick(cost);
  return cost;
}

Cost Site::submit(const std::string& sweep_file) {
  const auto client = bus_.join("client");
  const auto requests = client->writer<messaging::Request>();
  constexpr std::uint64_t asker = ~std::uint64_t{0};  // no worker's incarnation
  const auto replies = client->reader<messaging::Reply>(nullptr, messaging::Partition::of(asker));
  idl::Request request;
  *request.mutable_submit()->mutable_specification() = experiment::parse_sweep(sweep_file, "sweep").specification;
  messaging::Request sample{.origin = {}, .client = asker, .correlation = 1, .payload = {}};
  const auto bytes = request.SerializeAsString();
  sample.payload.assign(bytes.begin(), bytes.end());
  if (!requests->write(sample)) throw std::runtime_error("the sweep could not be sent");
  submitted_ = now_;
  const Cost cost = pass(longest_wait);
  const auto answers = replies->take();
  idl::Reply reply;
  const bool readable = answers.size() == 1 && reply.ParseFromArray(answers.front().payload.data(),
                                                                    static_cast<int>(answers.front().payload.size()));
  if (!readable || reply.has_error()) throw std::runtime_error("the sweep was refused: " + reply.ShortDebugString());
  return cost;
}

Cost Site::work(std::uint64_t jobs) {
  Cost cost;
  const auto until = now_ + patience;
  for (std::uint64_t done = 0; done < jobs;) {
    if (now_ > until) throw std::runtime_error("the sweep has not ended within an hour of simulated time");
    tick(cost);
    for (const auto& sample : progress_->take()) done = sample.done;
  }
  return cost;
}

double Site::share_computing() const {
  double busy = 0;
  for (const auto& each : workers_) busy += seconds(each.executor->busy());
  return busy / (seconds(now_ - submitted_) * static_cast<double>(workers_.size()));
}

}  // namespace lamprey::benchmarks
