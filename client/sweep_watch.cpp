#include "client/sweep_watch.hpp"

#include "client/failure.hpp"
#include "client/output/formatting.hpp"

#include <utility>

namespace lamprey::client {

namespace {

constexpr std::chrono::milliseconds look_interval{50};

/// Longer silences are worth a word to the user.
constexpr std::chrono::seconds noticeable_silence{5};

}  // namespace

messaging::SweepProgress progress_of(const idl::SweepStatus& status, int workers) {
  messaging::SweepProgress progress;
  progress.sweep = experiment::id128_from_hex(status.id()).value_or(experiment::Id128{});
  progress.name = status.name();
  progress.state = status.state();
  const auto& counts = status.counts();
  progress.jobs = counts.jobs();
  progress.pending = counts.pending();
  progress.leased = counts.leased();
  progress.done = counts.done();
  progress.failed = counts.failed();
  progress.quarantined = counts.quarantined();
  progress.cancelled = counts.cancelled();
  progress.divergences = status.divergences();
  progress.jobs_per_second = status.jobs_per_second();
  if (status.has_seconds_left()) progress.seconds_left = status.seconds_left();
  progress.workers = static_cast<std::uint32_t>(workers);
  return progress;
}

bool has_ended(const std::string& state) {
  return state == "finished" || state == "cancelled";
}

SweepWatch::SweepWatch(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal,
                       CoordinatorClient& client, experiment::Id128 database, experiment::Id128 sweep,
                       Clock::time_point now)
    : client_(client),
      samples_(participant.reader<messaging::SweepProgress>(std::move(signal))),
      database_(database),
      sweep_(sweep),
      heard_(now) {}

void SweepWatch::hear(messaging::SweepProgress progress, Clock::time_point now) {
  heard_ = now;
  // An older word may come late, after the answer to a question; a sweep never goes on after its end.
  if (!ended()) latest_ = std::move(progress);
}

void SweepWatch::step(Clock::time_point now) {
  for (auto& sample : samples_->take()) {
    if (sample.sweep == sweep_ && sample.origin.database == database_) hear(std::move(sample), now);
  }
  if (ended()) return;
  if (!client_.waiting()) {
    if (silence(now) < patience) return;
    idl::Request request;
    request.mutable_status()->set_sweep(experiment::to_hex(sweep_));
    client_.begin(request, now);
  }
  const auto reply = client_.poll(now);
  if (!reply || client_.answered_by().database != database_) return;
  require_success(*reply);
  if (reply->status().sweeps_size() > 0) {
    hear(progress_of(reply->status().sweeps(0), reply->status().workers_size()), now);
  }
}

messaging::SweepProgress wait_for_end(CoordinatorConnection& connection, experiment::Id128 sweep,
                                      output::ProgressDisplay& display,
                                      const std::function<void(Clock::time_point)>& meanwhile) {
  SweepWatch watch(connection.participant(), connection.signal(), connection.client(),
                   connection.client().answered_by().database, sweep, Clock::now());
  bool was_silent = false;
  while (true) {
    const auto now = Clock::now();
    if (connection.interrupted()) throw interrupted_failure();
    if (meanwhile) meanwhile(now);
    watch.step(now);
    const auto& latest = watch.latest();
    const bool silent = watch.silence(now) >= noticeable_silence;
    if (latest) {
      const auto silence = std::chrono::duration_cast<std::chrono::seconds>(watch.silence(now));
      const std::string note =
          silent ? "  no word from the coordinator for " + output::duration(static_cast<double>(silence.count())) : "";
      display.show(output::progress_line(*latest) + note, now, watch.ended() || silent != was_silent);
    }
    was_silent = silent;
    if (watch.ended()) return *latest;
    connection.signal()->wait_for(look_interval);
  }
}

}  // namespace lamprey::client
