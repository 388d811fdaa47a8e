#pragma once

#include "client/coordinator_connection.hpp"
#include "client/output/progress.hpp"
#include "messaging/samples.hpp"

#include <functional>
#include <optional>
#include <string>

namespace lamprey::client {

/// A status as if it had come as progress.
messaging::SweepProgress progress_of(const idl::SweepStatus& status, int workers);

/// Whether a sweep in that state has nothing left to do.
bool has_ended(const std::string& state);

/// Follows one sweep of one database: by the progress that the coordinator publishes, and where none comes by asking.
/// So neither a lost sample nor a coordinator that starts anew is missed. One thread.
class SweepWatch {
 public:
  /// After this long without a word the coordinator is asked.
  static constexpr std::chrono::seconds patience{2};

  SweepWatch(messaging::Participant& participant, std::shared_ptr<messaging::Signal> signal, CoordinatorClient& client,
             experiment::Id128 database, experiment::Id128 sweep, Clock::time_point now);

  /// Takes what has arrived and asks where that is due. Throws the Failure that the coordinator's answer stands for.
  void step(Clock::time_point now);

  /// The latest word; nothing at first.
  const std::optional<messaging::SweepProgress>& latest() const { return latest_; }
  bool ended() const { return latest_ && has_ended(latest_->state); }

  /// How long there has been no word.
  Clock::duration silence(Clock::time_point now) const { return now - heard_; }

 private:
  void hear(messaging::SweepProgress progress, Clock::time_point now);

  CoordinatorClient& client_;
  std::unique_ptr<messaging::Reader<messaging::SweepProgress>> samples_;
  experiment::Id128 database_;
  experiment::Id128 sweep_;
  std::optional<messaging::SweepProgress> latest_;
  Clock::time_point heard_;
};

/// Shows the sweep's progress until it has ended; its last word. `meanwhile` is called many times a second and ends the
/// wait by throwing. Throws interrupted_failure().
messaging::SweepProgress wait_for_end(CoordinatorConnection& connection, experiment::Id128 sweep,
                                      output::ProgressDisplay& display,
                                      const std::function<void(Clock::time_point)>& meanwhile = {});

}  // namespace lamprey::client
