#pragma once

#include "client/json.hpp"
#include "client/output/console.hpp"
#include "idl/client.pb.h"
#include "messaging/samples.hpp"

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace lamprey::client {

/// What a live view shows: the latest status, made fresher by the progress that the coordinator publishes, and the last
/// events. A value; knows no network and no clock.
class WatchState {
 public:
  /// At most so many of the newest events are kept.
  static constexpr std::size_t most_events = 8;

  void take(const idl::StatusReply& status);
  /// Progress of a sweep that the status knows; whether it changes anything.
  bool take(const messaging::SweepProgress& progress);
  void take(const idl::EventsReply& events);

  bool has_status() const { return has_status_; }
  /// The number of the newest event; 0 if there is none.
  std::uint64_t newest_event() const { return newest_event_; }

  const idl::StatusReply& status() const { return status_; }

  /// A picture as text. `note` is what to say beside the database; `rows` is what there is room for.
  std::string frame(const output::Console& console, const std::string& note, std::size_t rows) const;

  /// The same as a document of the command watch.
  Json json() const;

  /// A line for each sweep whose counts or state, and for each event, that is new since the last call; all sweeps at
  /// first, but no event that was there before.
  std::vector<std::string> new_lines(const output::Console& console, std::int64_t unix_milliseconds);

 private:
  idl::StatusReply status_;
  bool has_status_ = false;
  bool has_events_ = false;
  std::deque<idl::EventsReply::Event> events_;
  std::vector<idl::EventsReply::Event> untold_;
  std::uint64_t newest_event_ = 0;
  std::map<std::string, std::string> told_;  ///< by sweep's id; "" is the storage fault
};

}  // namespace lamprey::client
