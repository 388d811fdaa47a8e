#include "messaging/in_memory/bus.hpp"

#include "messaging/keys.hpp"
#include "messaging/limits.hpp"
#include "messaging/participant_of.hpp"
#include "messaging/qos.hpp"
#include "messaging/traffic_counters.hpp"
#include "messaging/tuning.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace lamprey::messaging::in_memory {
namespace detail {
namespace {

/// What the bus has to know of a topic; what its samples are only their writers and readers know.
struct Kind {
  std::string_view name;
  QosProfile profile;
  bool (*same_key)(const void*, const void*) = nullptr;  ///< of two samples; nullptr where the type has no keys
};

template <class Sample>
constexpr Kind kind_of() {
  Kind kind{.name = Topic<Sample>::name, .profile = Topic<Sample>::profile};
  if constexpr (Keyed<Sample>) {
    kind.same_key = [](const void* one, const void* other) {
      return key_of(*static_cast<const Sample*>(one)) == key_of(*static_cast<const Sample*>(other));
    };
  }
  return kind;
}

struct Entry {
  std::uint64_t ordinal;
  std::shared_ptr<const void> sample;  // of the topic's type
};
using Entries = std::deque<Entry>;

/// Appends and drops the oldest beyond `depth`, per key where the type has keys.
void keep_last(const Kind& kind, Entries& entries, const Entry& entry, std::size_t depth) {
  if (kind.same_key != nullptr) {
    const auto same_key = [&](const Entry& other) { return kind.same_key(other.sample.get(), entry.sample.get()); };
    if (static_cast<std::size_t>(std::ranges::count_if(entries, same_key)) >= depth) {
      entries.erase(std::ranges::find_if(entries, same_key));
    }
  } else if (entries.size() >= depth) {
    entries.pop_front();
  }
  entries.push_back(entry);
}

}  // namespace

/// A participant as the bus sees it.
struct Member {
  std::string name;
  discovery::Guid guid{};
  std::optional<discovery::Introduction> introduction{};
  bool connected = true;
  bool alive = true;
};

struct WriterEnd {
  std::size_t topic;
  std::shared_ptr<Member> member;
  Partition partition;
  bool open = true;
  Entries remembered;  // transient-local only
};

struct ReaderEnd {
  std::size_t topic;
  std::shared_ptr<Member> member;
  Partition partition;
  std::shared_ptr<Signal> signal;
  Entries untaken;
};

struct HeldSample {
  std::shared_ptr<WriterEnd> writer;
  Entry entry;
};

/// By their partitions' receivers: only ends of equal partitions meet, and a directed topic has as many as there are
/// programs.
template <class End>
using Ends = std::map<std::uint64_t, std::vector<std::shared_ptr<End>>>;

struct TopicState {
  Kind kind;
  std::uint64_t next_ordinal = 0;
  Ends<WriterEnd> writers;
  Ends<ReaderEnd> readers;
  std::map<std::uint64_t, HeldSample> held;  // by ordinal
};

template <class End>
void add_end(Ends<End>& ends, const std::shared_ptr<End>& end) {
  ends[end->partition.receiver].push_back(end);
}

template <class End>
void remove_end(Ends<End>& ends, const std::shared_ptr<End>& end) {
  const auto group = ends.find(end->partition.receiver);
  if (group == ends.end()) return;
  std::erase(group->second, end);
  if (group->second.empty()) ends.erase(group);
}

/// Those that may meet an end of that partition.
template <class End>
const std::vector<std::shared_ptr<End>>& group_of(const Ends<End>& ends, const Partition& partition) {
  static const std::vector<std::shared_ptr<End>> none;
  const auto group = ends.find(partition.receiver);
  return group == ends.end() ? none : group->second;
}

template <class End, class Each>
void for_each_end(const Ends<End>& ends, Each each) {
  for (const auto& [receiver, group] : ends) {
    for (const auto& end : group) each(end);
  }
}

/// Erases those of members that are dead, after `each` has seen them.
template <class End, class Each>
void erase_dead(Ends<End>& ends, Each each) {
  for (auto group = ends.begin(); group != ends.end();) {
    std::erase_if(group->second, [&](const auto& end) {
      if (end->member->alive) return false;
      each(*end);
      return true;
    });
    group = group->second.empty() ? ends.erase(group) : std::next(group);
  }
}

using AnySample = decltype(Envelope::sample);

/// In the order of the samples.
template <class... Samples>
std::array<TopicState, sizeof...(Samples)> topics_of(const std::variant<const Samples*...>&) {
  return {TopicState{kind_of<Samples>(), 0, {}, {}, {}}...};
}

template <class Sample>
constexpr std::size_t topic = AnySample(static_cast<const Sample*>(nullptr)).index();

class State {
 public:
  std::shared_ptr<Member> join(std::string name, std::optional<discovery::Introduction> introduction) {
    const std::lock_guard lock(mutex_);
    ++joined_;
    discovery::Guid guid{};  // the number is enough: no vendor's begin with a zero
    for (std::size_t i = 0; i < sizeof joined_; ++i)
      guid[guid.size() - 1 - i] = static_cast<std::uint8_t>(joined_ >> (8 * i));
    return members_.emplace_back(std::make_shared<Member>(
        Member{.name = std::move(name), .guid = guid, .introduction = std::move(introduction)}));
  }

  /// Whom the member could meet.
  std::vector<discovery::Participant> others(const Member& who) const {
    const std::lock_guard lock(mutex_);
    std::vector<discovery::Participant> all;
    for (const auto& member : members_) {
      if (member.get() == &who || !member->connected || !who.connected || !who.alive) continue;
      all.push_back({member->guid, member->name, member->introduction});
    }
    return all;
  }

  void on_sample(std::function<Fate(const Envelope&)> decide) {
    const std::lock_guard lock(mutex_);
    decide_ = std::move(decide);
  }

  std::shared_ptr<WriterEnd> add_writer(std::size_t topic, std::shared_ptr<Member> member, Partition partition) {
    const std::lock_guard lock(mutex_);
    auto end = std::make_shared<WriterEnd>(WriterEnd{topic, std::move(member), partition, true, {}});
    if (end->member->alive) add_end(topics_[topic].writers, end);
    return end;
  }

  std::shared_ptr<ReaderEnd> add_reader(std::size_t topic, std::shared_ptr<Member> member, Partition partition,
                                        std::shared_ptr<Signal> signal) {
    const std::lock_guard lock(mutex_);
    auto end = std::make_shared<ReaderEnd>(ReaderEnd{topic, std::move(member), partition, std::move(signal), {}});
    if (end->member->alive) {
      add_end(topics_[topic].readers, end);
      recall(topics_[topic], *end, [](const WriterEnd&) { return true; });
    }
    return end;
  }

  void remove(const std::shared_ptr<WriterEnd>& end) {
    const std::lock_guard lock(mutex_);
    end->open = false;
    remove_end(topics_[end->topic].writers, end);
  }

  void remove(const std::shared_ptr<ReaderEnd>& end) {
    const std::lock_guard lock(mutex_);
    remove_end(topics_[end->topic].readers, end);
  }

  /// `sample` is what `copy` holds.
  WriteResult write(const std::shared_ptr<WriterEnd>& writer, std::shared_ptr<const void> copy, AnySample sample) {
    const std::lock_guard lock(mutex_);
    if (!writer->member->alive) return {};
    auto& topic = topics_[writer->topic];
    if (is_full(topic, *writer)) {
      return {WriteResult::Kind::full, "a reader of " + std::string(topic.kind.name) + " has not kept up"};
    }
    const Entry entry{topic.next_ordinal++, std::move(copy)};
    const auto decide = decide_;  // it may replace itself
    const Fate fate = !decide ? Fate::deliver
                              : decide(Envelope{.topic = topic.kind.name,
                                                .ordinal = entry.ordinal,
                                                .partition = writer->partition,
                                                .sender = writer->member->name,
                                                .sample = sample});
    switch (fate) {
      case Fate::drop:
        break;
      case Fate::hold:
        topic.held.emplace(entry.ordinal, HeldSample{writer, entry});
        break;
      case Fate::deliver:
        deliver(topic, *writer, entry, 1);
        break;
      case Fate::duplicate:
        deliver(topic, *writer, entry, 2);
        break;
    }
    return {};
  }

  Entries take(ReaderEnd& reader, std::size_t most) {
    const std::lock_guard lock(mutex_);
    const auto end = reader.untaken.begin() + static_cast<std::ptrdiff_t>(std::min(most, reader.untaken.size()));
    Entries taken(std::make_move_iterator(reader.untaken.begin()), std::make_move_iterator(end));
    reader.untaken.erase(reader.untaken.begin(), end);
    if (!reader.untaken.empty()) notify(reader);
    return taken;
  }

  std::vector<Held> held() const {
    const std::lock_guard lock(mutex_);
    std::vector<Held> all;
    for (const auto& topic : topics_) collect_held(topic, all);
    return all;
  }

  bool release(const Held& which) {
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(topics_, [&](auto& topic) { return release_one(topic, which); });
  }

  void disconnect(std::string_view name) {
    const std::lock_guard lock(mutex_);
    for (const auto& member : members_) {
      if (member->name == name) member->connected = false;
    }
  }

  void reconnect(std::string_view name) {
    const std::lock_guard lock(mutex_);
    std::set<const Member*> back;
    for (const auto& member : members_) {
      if (member->name != name || member->connected) continue;
      member->connected = true;
      back.insert(member.get());
    }
    for (auto& topic : topics_) {
      for_each_end(topic.readers, [&](const auto& reader) {
        const bool reader_is_back = back.contains(reader->member.get());
        recall(topic, *reader,
               [&](const auto& writer) { return reader_is_back != back.contains(writer.member.get()); });
      });
    }
  }

  void kill(std::string_view name) {
    const std::lock_guard lock(mutex_);
    for (const auto& member : members_) {
      if (member->name == name) member->alive = false;
    }
    for (auto& topic : topics_) {
      erase_dead(topic.writers, [](WriterEnd& writer) { writer.open = false; });
      erase_dead(topic.readers, [](ReaderEnd& reader) { reader.untaken.clear(); });
    }
    std::erase_if(members_, [](const auto& member) { return !member->alive; });
  }

  void leave(const std::shared_ptr<Member>& member) {
    const std::lock_guard lock(mutex_);
    std::erase(members_, member);
  }

 private:
  static bool meet(const WriterEnd& writer, const ReaderEnd& reader) {
    const bool same_program = writer.member == reader.member;
    return writer.partition == reader.partition && writer.member->alive && reader.member->alive &&
           (same_program || (writer.member->connected && reader.member->connected));
  }

  static bool is_full(const TopicState& topic, const WriterEnd& writer) {
    if (!topic.kind.profile.keep_all) return false;
    return std::ranges::any_of(group_of(topic.readers, writer.partition), [&](const auto& reader) {
      return meet(writer, *reader) && reader->untaken.size() >= topic.kind.profile.depth;
    });
  }

  static void notify(ReaderEnd& reader) {
    if (reader.signal) reader.signal->notify();
  }

  static void receive(const Kind& kind, ReaderEnd& reader, const Entry& entry) {
    keep_last(kind, reader.untaken, entry, kind.same_key != nullptr ? kind.profile.depth : kind.profile.untaken);
    notify(reader);
  }

  static void deliver(TopicState& topic, WriterEnd& writer, const Entry& entry, int times) {
    const QosProfile& profile = topic.kind.profile;
    if (profile.transient_local && writer.open) keep_last(topic.kind, writer.remembered, entry, profile.depth);
    for (const auto& reader : group_of(topic.readers, writer.partition)) {
      for (int i = 0; i < times && meet(writer, *reader); ++i) receive(topic.kind, *reader, entry);
    }
  }

  /// Gives the reader what the selected writers remember, in the order in which it was written.
  template <class Select>
  static void recall(TopicState& topic, ReaderEnd& reader, Select select) {
    Entries remembered;
    for (const auto& writer : group_of(topic.writers, reader.partition)) {
      if (!meet(*writer, reader) || !select(*writer)) continue;
      remembered.insert(remembered.end(), writer->remembered.begin(), writer->remembered.end());
    }
    std::sort(remembered.begin(), remembered.end(), [](const auto& a, const auto& b) { return a.ordinal < b.ordinal; });
    for (const auto& entry : remembered) receive(topic.kind, reader, entry);
  }

  static void collect_held(const TopicState& topic, std::vector<Held>& all) {
    for (const auto& [ordinal, held] : topic.held) all.push_back({std::string(topic.kind.name), ordinal});
  }

  static bool release_one(TopicState& topic, const Held& which) {
    if (which.topic != topic.kind.name) return false;
    auto node = topic.held.extract(which.ordinal);
    if (node.empty()) return false;
    deliver(topic, *node.mapped().writer, node.mapped().entry, 1);
    return true;
  }

  mutable std::recursive_mutex mutex_;  // recursive: a fate function may call the bus
  std::function<Fate(const Envelope&)> decide_;
  std::vector<std::shared_ptr<Member>> members_;
  std::uint64_t joined_ = 0;
  decltype(topics_of(AnySample{})) topics_ = topics_of(AnySample{});
};

}  // namespace detail

namespace {

template <class Sample>
class BusWriter final : public Writer<Sample> {
 public:
  BusWriter(std::shared_ptr<detail::State> state, std::shared_ptr<detail::WriterEnd> end,
            std::shared_ptr<TopicCounters> counters)
      : counters_(std::move(counters)), state_(std::move(state)), end_(std::move(end)) {}
  ~BusWriter() override { state_->remove(end_); }
  BusWriter(const BusWriter&) = delete;
  BusWriter& operator=(const BusWriter&) = delete;

  WriteResult write(const Sample& sample) override {
    if (auto violation = limit_violation(sample)) {
      return {WriteResult::Kind::failed, "cannot write to " + std::string(Topic<Sample>::name) + ": " + *violation};
    }
    const auto copy = std::make_shared<const Sample>(sample);
    auto result = state_->write(end_, copy, copy.get());
    counters_->count_write(static_cast<bool>(result));
    return result;
  }

 private:
  std::shared_ptr<TopicCounters> counters_;
  std::shared_ptr<detail::State> state_;
  std::shared_ptr<detail::WriterEnd> end_;
};

template <class Sample>
class BusReader final : public Reader<Sample> {
 public:
  BusReader(std::shared_ptr<detail::State> state, std::shared_ptr<detail::ReaderEnd> end,
            std::shared_ptr<TopicCounters> counters)
      : counters_(std::move(counters)), state_(std::move(state)), end_(std::move(end)) {}
  ~BusReader() override { state_->remove(end_); }
  BusReader(const BusReader&) = delete;
  BusReader& operator=(const BusReader&) = delete;

  std::vector<Sample> take(std::size_t most) override {
    std::vector<Sample> samples;
    for (const auto& entry : state_->take(*end_, most)) {
      samples.push_back(*static_cast<const Sample*>(entry.sample.get()));
    }
    counters_->count_read(samples.size());
    return samples;
  }

 private:
  std::shared_ptr<TopicCounters> counters_;
  std::shared_ptr<detail::State> state_;
  std::shared_ptr<detail::ReaderEnd> end_;
};

class BusParticipant final : public ParticipantOf<BusParticipant> {
 public:
  BusParticipant(std::shared_ptr<detail::State> state, std::string name,
                 std::optional<discovery::Introduction> introduction)
      : state_(std::move(state)), member_(state_->join(std::move(name), std::move(introduction))) {}
  ~BusParticipant() override { state_->leave(member_); }
  BusParticipant(const BusParticipant&) = delete;
  BusParticipant& operator=(const BusParticipant&) = delete;

  template <class Sample>
  std::unique_ptr<Writer<Sample>> open_writer(Partition partition) {
    return std::make_unique<BusWriter<Sample>>(state_, state_->add_writer(detail::topic<Sample>, member_, partition),
                                               counters_of<Sample>());
  }
  template <class Sample>
  std::unique_ptr<Reader<Sample>> open_reader(Partition partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<BusReader<Sample>>(
        state_, state_->add_reader(detail::topic<Sample>, member_, partition, std::move(signal)),
        counters_of<Sample>());
  }
  std::string vendor() const override { return "in_memory"; }
  std::uint64_t malformed_samples() const override { return 0; }
  Traffic traffic() const override { return counters_->so_far(member_->guid, 0); }
  std::vector<discovery::Participant> others() override { return state_->others(*member_); }

 private:
  /// Writers and readers may outlive the participant.
  template <class Sample>
  std::shared_ptr<TopicCounters> counters_of() {
    return {counters_, &counters_->of(Topic<Sample>::name)};
  }

  std::shared_ptr<TrafficCounters> counters_ = std::make_shared<TrafficCounters>();
  std::shared_ptr<detail::State> state_;
  std::shared_ptr<detail::Member> member_;
};

}  // namespace

Bus::Bus() : state_(std::make_shared<detail::State>()) {}

std::unique_ptr<Participant> Bus::join(std::string name, std::optional<discovery::Introduction> introduction) {
  return std::make_unique<BusParticipant>(state_, std::move(name), std::move(introduction));
}
void Bus::on_sample(std::function<Fate(const Envelope&)> decide) {
  state_->on_sample(std::move(decide));
}
std::vector<Held> Bus::held() const {
  return state_->held();
}
bool Bus::release(const Held& held) {
  return state_->release(held);
}
void Bus::release_all() {
  for (const auto& held : state_->held()) state_->release(held);
}
void Bus::disconnect(std::string_view participant) {
  state_->disconnect(participant);
}
void Bus::reconnect(std::string_view participant) {
  state_->reconnect(participant);
}
void Bus::kill(std::string_view participant) {
  state_->kill(participant);
}

}  // namespace lamprey::messaging::in_memory
