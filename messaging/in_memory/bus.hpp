#pragma once

#include "messaging/port.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// A DDS domain within one process, for tests and single-process experiments: the port's promises without a network,
/// and faults on demand. Nothing runs by itself — a write puts the sample into the readers before it returns — so a
/// single thread that steps its programs in turn always sees the same history.
///
/// As the vendors do: equal partitions meet; a late reader gets what transient-local writers remember (the last
/// `depth` samples, per key where there are keys); readers of keyed topics keep the last sample per key, others all
/// (up to 4096, then the oldest goes); a keep-all writer is told `full` while some reader holds `depth` untaken
/// samples.
namespace lamprey::messaging::in_memory {

enum class Fate : std::uint8_t {
  deliver,
  drop,       ///< as if it had never been written: no reader gets it, present or future
  duplicate,  ///< every reader gets it twice
  hold,       ///< nobody gets it until it is released, maybe after younger samples
};

/// A sample on its way; valid during the call only.
struct Envelope {
  std::string_view topic;
  std::uint64_t ordinal;  ///< 0-based, over all samples of the topic on this bus
  Partition partition;
  std::string_view sender;  ///< the participant's name
  std::variant<const WorkerStatus*, const SweepSpecification*, const Lease*, const ResultBatch*,
               const ResultAcknowledgement*, const Checkpoint*, const Request*, const Reply*, const SweepProgress*,
               const Traffic*, const RobotStatus*, const RobotRequest*, const RobotReply*, const ServoCommand*,
               const ServoState*>
      sample;

  /// The sample, or nullptr if it is of another type.
  template <class Sample>
  const Sample* get() const {
    const auto* const* held = std::get_if<const Sample*>(&sample);
    return held == nullptr ? nullptr : *held;
  }
};

/// A sample that is being held.
struct Held {
  std::string topic;
  std::uint64_t ordinal = 0;
  bool operator==(const Held&) const = default;
};

namespace detail {
class State;
}

/// Callable from any thread. Participants, writers and readers keep the bus alive and may outlive this object.
class Bus {
 public:
  Bus();

  /// `name` is the sender in envelopes and what the faults below address; several participants may share one.
  /// `introduction`: what others are told of it.
  std::unique_ptr<Participant> join(std::string name = "participant",
                                    std::optional<discovery::Introduction> introduction = std::nullopt);

  /// Decides the fate of every sample that is written from now on, on the writer's thread and before anybody gets it;
  /// an empty function delivers. It may call the bus, but must not write or take.
  void on_sample(std::function<Fate(const Envelope&)> decide);

  /// In the order in which they were written.
  std::vector<Held> held() const;
  /// Delivers a held sample as if it were written now, without asking for its fate again. False if none such is held.
  bool release(const Held& held);
  /// In the order in which they were written.
  void release_all();

  /// From now on the participant's samples reach nobody and none reach it; its writes still succeed. A writer that is
  /// waited for is not `full` on account of a disconnected reader. Samples that its readers had received remain.
  void disconnect(std::string_view participant);
  /// What transient-local writers remember is exchanged anew, in both directions, as after a rediscovery: samples that
  /// had been received before come again. Everything else that was written meanwhile is lost.
  void reconnect(std::string_view participant);

  /// As SIGKILL: the participant's writers, with what they remember, and its readers vanish. What the dead program
  /// still calls has no effect (writes report success); its objects are destroyed as usual.
  void kill(std::string_view participant);

 private:
  std::shared_ptr<detail::State> state_;
};

}  // namespace lamprey::messaging::in_memory
