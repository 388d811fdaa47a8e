#include "messaging/in_memory/bus.hpp"

#include "messaging/keys.hpp"
#include "messaging/limits.hpp"
#include "messaging/participant_of.hpp"
#include "messaging/qos.hpp"
#include "messaging/tuning.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <tuple>
#include <utility>

namespace lamprey::messaging::in_memory {
namespace detail {
namespace {

template <class Sample>
struct Entry {
  std::uint64_t ordinal;
  std::shared_ptr<const Sample> sample;
};

template <class Sample>
using Entries = std::deque<Entry<Sample>>;

/// Appends and drops the oldest beyond `depth`, per key where the type has keys.
template <class Sample>
void keep_last(Entries<Sample>& entries, Entry<Sample> entry, std::size_t depth) {
  if constexpr (Keyed<Sample>) {
    const auto same_key = [&](const Entry<Sample>& other) { return key_of(*other.sample) == key_of(*entry.sample); };
    if (static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(), same_key)) >= depth) {
      entries.erase(std::find_if(entries.begin(), entries.end(), same_key));
    }
  } else if (entries.size() >= depth) {
    entries.pop_front();
  }
  entries.push_back(std::move(entry));
}

}  // namespace

/// A participant as the bus sees it.
struct Member {
  std::string name;
  bool connected = true;
  bool alive = true;
};

template <class Sample>
struct WriterEnd {
  std::shared_ptr<Member> member;
  Partition partition;
  bool open = true;
  Entries<Sample> remembered;  // transient-local only
};

template <class Sample>
struct ReaderEnd {
  std::shared_ptr<Member> member;
  Partition partition;
  std::shared_ptr<Signal> signal;
  Entries<Sample> untaken;
};

template <class Sample>
struct HeldSample {
  std::shared_ptr<WriterEnd<Sample>> writer;
  Entry<Sample> entry;
};

template <class Sample>
struct TopicState {
  std::uint64_t next_ordinal = 0;
  std::vector<std::shared_ptr<WriterEnd<Sample>>> writers;
  std::vector<std::shared_ptr<ReaderEnd<Sample>>> readers;
  std::map<std::uint64_t, HeldSample<Sample>> held;  // by ordinal
};

class State {
 public:
  std::shared_ptr<Member> join(std::string name) {
    const std::lock_guard lock(mutex_);
    return members_.emplace_back(std::make_shared<Member>(Member{.name = std::move(name)}));
  }

  void on_sample(std::function<Fate(const Envelope&)> decide) {
    const std::lock_guard lock(mutex_);
    decide_ = std::move(decide);
  }

  template <class Sample>
  std::shared_ptr<WriterEnd<Sample>> add_writer(std::shared_ptr<Member> member, Partition partition) {
    const std::lock_guard lock(mutex_);
    auto end = std::make_shared<WriterEnd<Sample>>();
    end->member = std::move(member);
    end->partition = partition;
    if (end->member->alive) topic<Sample>().writers.push_back(end);
    return end;
  }

  template <class Sample>
  std::shared_ptr<ReaderEnd<Sample>> add_reader(std::shared_ptr<Member> member, Partition partition,
                                                std::shared_ptr<Signal> signal) {
    const std::lock_guard lock(mutex_);
    auto end = std::make_shared<ReaderEnd<Sample>>();
    end->member = std::move(member);
    end->partition = partition;
    end->signal = std::move(signal);
    if (end->member->alive) {
      topic<Sample>().readers.push_back(end);
      recall(topic<Sample>(), *end, [](const WriterEnd<Sample>&) { return true; });
    }
    return end;
  }

  template <class Sample>
  void remove(const std::shared_ptr<WriterEnd<Sample>>& end) {
    const std::lock_guard lock(mutex_);
    end->open = false;
    std::erase(topic<Sample>().writers, end);
  }

  template <class Sample>
  void remove(const std::shared_ptr<ReaderEnd<Sample>>& end) {
    const std::lock_guard lock(mutex_);
    std::erase(topic<Sample>().readers, end);
  }

  template <class Sample>
  WriteResult write(const std::shared_ptr<WriterEnd<Sample>>& writer, const Sample& sample) {
    const std::lock_guard lock(mutex_);
    if (!writer->member->alive) return {};
    if (auto violation = limit_violation(sample)) {
      return {WriteResult::Kind::failed, "cannot write to " + std::string(Topic<Sample>::name) + ": " + *violation};
    }
    auto& topic = this->topic<Sample>();
    if (is_full(topic, *writer)) {
      return {WriteResult::Kind::full, "a reader of " + std::string(Topic<Sample>::name) + " has not kept up"};
    }
    Entry<Sample> entry{topic.next_ordinal++, std::make_shared<const Sample>(sample)};
    const auto decide = decide_;  // it may replace itself
    const Fate fate = !decide ? Fate::deliver
                              : decide(Envelope{.topic = Topic<Sample>::name,
                                                .ordinal = entry.ordinal,
                                                .partition = writer->partition,
                                                .sender = writer->member->name,
                                                .sample = entry.sample.get()});
    switch (fate) {
      case Fate::drop:
        break;
      case Fate::hold:
        topic.held.emplace(entry.ordinal, HeldSample<Sample>{writer, std::move(entry)});
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

  template <class Sample>
  std::vector<Sample> take(ReaderEnd<Sample>& reader, std::size_t most) {
    const std::lock_guard lock(mutex_);
    std::vector<Sample> samples;
    const std::size_t count = std::min(most, reader.untaken.size());
    samples.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      samples.push_back(*reader.untaken.front().sample);
      reader.untaken.pop_front();
    }
    if (!reader.untaken.empty()) notify(reader);
    return samples;
  }

  std::vector<Held> held() const {
    const std::lock_guard lock(mutex_);
    std::vector<Held> all;
    for_each_topic([&](const auto& topic) { collect_held(topic, all); });
    return all;
  }

  bool release(const Held& which) {
    const std::lock_guard lock(mutex_);
    bool released = false;
    for_each_topic([&](auto& topic) { released = released || release_one(topic, which); });
    return released;
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
    for_each_topic([&](auto& topic) {
      for (const auto& reader : topic.readers) {
        const bool reader_is_back = back.contains(reader->member.get());
        recall(topic, *reader,
               [&](const auto& writer) { return reader_is_back != back.contains(writer.member.get()); });
      }
    });
  }

  void kill(std::string_view name) {
    const std::lock_guard lock(mutex_);
    for (const auto& member : members_) {
      if (member->name == name) member->alive = false;
    }
    const auto is_dead = [](const auto& end) { return !end->member->alive; };
    for_each_topic([&](auto& topic) {
      for (const auto& writer : topic.writers) writer->open = writer->open && writer->member->alive;
      for (const auto& reader : topic.readers) {
        if (is_dead(reader)) reader->untaken.clear();
      }
      std::erase_if(topic.writers, is_dead);
      std::erase_if(topic.readers, is_dead);
    });
    std::erase_if(members_, [](const auto& member) { return !member->alive; });
  }

  void leave(const std::shared_ptr<Member>& member) {
    const std::lock_guard lock(mutex_);
    std::erase(members_, member);
  }

 private:
  template <class Sample>
  TopicState<Sample>& topic() {
    return std::get<TopicState<Sample>>(topics_);
  }

  template <class Function>
  void for_each_topic(Function function) {
    std::apply([&](auto&... topic) { (function(topic), ...); }, topics_);
  }
  template <class Function>
  void for_each_topic(Function function) const {
    std::apply([&](const auto&... topic) { (function(topic), ...); }, topics_);
  }

  template <class Sample>
  static bool meet(const WriterEnd<Sample>& writer, const ReaderEnd<Sample>& reader) {
    const bool same_program = writer.member == reader.member;
    return writer.partition == reader.partition && writer.member->alive && reader.member->alive &&
           (same_program || (writer.member->connected && reader.member->connected));
  }

  template <class Sample>
  static bool is_full(const TopicState<Sample>& topic, const WriterEnd<Sample>& writer) {
    if (!Topic<Sample>::profile.keep_all) return false;
    return std::any_of(topic.readers.begin(), topic.readers.end(), [&](const auto& reader) {
      return meet(writer, *reader) && reader->untaken.size() >= Topic<Sample>::profile.depth;
    });
  }

  template <class Sample>
  static void notify(ReaderEnd<Sample>& reader) {
    if (reader.signal) reader.signal->notify();
  }

  template <class Sample>
  static void receive(ReaderEnd<Sample>& reader, const Entry<Sample>& entry) {
    const std::size_t depth = Keyed<Sample> ? Topic<Sample>::profile.depth : std::size_t{maximum_untaken};
    keep_last(reader.untaken, entry, depth);
    notify(reader);
  }

  template <class Sample>
  static void deliver(TopicState<Sample>& topic, WriterEnd<Sample>& writer, const Entry<Sample>& entry, int times) {
    if (Topic<Sample>::profile.transient_local && writer.open) {
      keep_last(writer.remembered, entry, Topic<Sample>::profile.depth);
    }
    for (const auto& reader : topic.readers) {
      for (int i = 0; i < times && meet(writer, *reader); ++i) receive(*reader, entry);
    }
  }

  /// Gives the reader what the selected writers remember, in the order in which it was written.
  template <class Sample, class Select>
  static void recall(TopicState<Sample>& topic, ReaderEnd<Sample>& reader, Select select) {
    Entries<Sample> remembered;
    for (const auto& writer : topic.writers) {
      if (!meet(*writer, reader) || !select(*writer)) continue;
      remembered.insert(remembered.end(), writer->remembered.begin(), writer->remembered.end());
    }
    std::sort(remembered.begin(), remembered.end(), [](const auto& a, const auto& b) { return a.ordinal < b.ordinal; });
    for (const auto& entry : remembered) receive(reader, entry);
  }

  template <class Sample>
  static void collect_held(const TopicState<Sample>& topic, std::vector<Held>& all) {
    for (const auto& [ordinal, held] : topic.held) all.push_back({std::string(Topic<Sample>::name), ordinal});
  }

  template <class Sample>
  static bool release_one(TopicState<Sample>& topic, const Held& which) {
    if (which.topic != Topic<Sample>::name) return false;
    auto node = topic.held.extract(which.ordinal);
    if (node.empty()) return false;
    deliver(topic, *node.mapped().writer, node.mapped().entry, 1);
    return true;
  }

  mutable std::recursive_mutex mutex_;  // recursive: a fate function may call the bus
  std::function<Fate(const Envelope&)> decide_;
  std::vector<std::shared_ptr<Member>> members_;
  std::tuple<TopicState<WorkerStatus>, TopicState<SweepSpecification>, TopicState<Lease>, TopicState<ResultBatch>,
             TopicState<ResultAcknowledgement>, TopicState<Request>, TopicState<Reply>, TopicState<SweepProgress>>
      topics_;
};

}  // namespace detail

namespace {

template <class Sample>
class BusWriter final : public Writer<Sample> {
 public:
  BusWriter(std::shared_ptr<detail::State> state, std::shared_ptr<detail::WriterEnd<Sample>> end)
      : state_(std::move(state)), end_(std::move(end)) {}
  ~BusWriter() override { state_->remove(end_); }
  BusWriter(const BusWriter&) = delete;
  BusWriter& operator=(const BusWriter&) = delete;

  WriteResult write(const Sample& sample) override { return state_->write(end_, sample); }

 private:
  std::shared_ptr<detail::State> state_;
  std::shared_ptr<detail::WriterEnd<Sample>> end_;
};

template <class Sample>
class BusReader final : public Reader<Sample> {
 public:
  BusReader(std::shared_ptr<detail::State> state, std::shared_ptr<detail::ReaderEnd<Sample>> end)
      : state_(std::move(state)), end_(std::move(end)) {}
  ~BusReader() override { state_->remove(end_); }
  BusReader(const BusReader&) = delete;
  BusReader& operator=(const BusReader&) = delete;

  std::vector<Sample> take(std::size_t most) override { return state_->take(*end_, most); }

 private:
  std::shared_ptr<detail::State> state_;
  std::shared_ptr<detail::ReaderEnd<Sample>> end_;
};

class BusParticipant final : public ParticipantOf<BusParticipant> {
 public:
  BusParticipant(std::shared_ptr<detail::State> state, std::string name)
      : state_(std::move(state)), member_(state_->join(std::move(name))) {}
  ~BusParticipant() override { state_->leave(member_); }
  BusParticipant(const BusParticipant&) = delete;
  BusParticipant& operator=(const BusParticipant&) = delete;

  template <class Sample>
  std::unique_ptr<Writer<Sample>> open_writer(Partition partition) {
    return std::make_unique<BusWriter<Sample>>(state_, state_->add_writer<Sample>(member_, partition));
  }
  template <class Sample>
  std::unique_ptr<Reader<Sample>> open_reader(Partition partition, std::shared_ptr<Signal> signal) {
    return std::make_unique<BusReader<Sample>>(state_,
                                               state_->add_reader<Sample>(member_, partition, std::move(signal)));
  }
  std::string vendor() const override { return "in_memory"; }

 private:
  std::shared_ptr<detail::State> state_;
  std::shared_ptr<detail::Member> member_;
};

}  // namespace

Bus::Bus() : state_(std::make_shared<detail::State>()) {}

std::unique_ptr<Participant> Bus::join(std::string name) {
  return std::make_unique<BusParticipant>(state_, std::move(name));
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
