#pragma once

#include "messaging/in_memory/bus.hpp"
#include "messaging/port.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <ostream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

/// What the suite runs over: the in-memory bus, each vendor, and both mixed pairs.
namespace lamprey::messaging::conformance {

struct Pair {
  std::string name;
  std::string writer;  ///< vendor of the writing side
  std::string reader;
  bool network_settings = false;  ///< as for a network of machines, though it is one: see tuning.hpp
};
inline void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.writer << " to " << pair.reader;
}

std::vector<Pair> all_pairs();
/// Those over DDS.
std::vector<Pair> network_pairs();
/// The same, but met as a peer by address and not by loopback only.
std::vector<Pair> pairs_with_network_settings();

/// Generous, because the machine may be busy with other tests; nothing here asserts how long something takes.
inline constexpr std::chrono::seconds patience{150};

/// Two sides that nobody else can meet: an isolation of its own, on this machine only.
class World : public ::testing::TestWithParam<Pair> {
 public:
  World();

 protected:
  /// A participant of the writing or of the reading side; `isolation` is added to the test's own.
  std::unique_ptr<Participant> join_writer(const std::string& isolation = "");
  std::unique_ptr<Participant> join_reader(const std::string& isolation = "");

  JoinOptions options(const std::string& vendor, const std::string& isolation) const;

  std::map<std::string, in_memory::Bus> buses_;  // by isolation

 private:
  std::unique_ptr<Participant> make(const std::string& vendor, const std::string& isolation);

  std::string isolation_;
};

std::string pair_name(const ::testing::TestParamInfo<Pair>& parameter);

/// A reader and everything that it has received.
template <class Sample>
class Inbox {
 public:
  explicit Inbox(Participant& participant, Partition partition = Partition::common())
      : signal_(std::make_shared<Signal>()), reader_(participant.reader<Sample>(signal_, partition)) {}

  /// Takes until `enough` says so; false if it never did.
  bool take_until(const std::function<bool(const std::vector<Sample>&)>& enough) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!enough(samples)) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      take();
      if (!enough(samples)) signal_->wait_for(std::chrono::milliseconds(50));
    }
    return true;
  }
  bool take_until_size(std::size_t size) {
    return take_until([size](const auto& all) { return all.size() >= size; });
  }
  void take() {
    for (auto& sample : reader_->take()) samples.push_back(std::move(sample));
  }

  std::vector<Sample> samples;

 private:
  std::shared_ptr<Signal> signal_;
  std::unique_ptr<Reader<Sample>> reader_;
};

/// Writes, again as long as the writer is full; fails the test if it stays so or fails otherwise.
template <class Sample>
void write(Writer<Sample>& writer, const Sample& sample) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (;;) {
    const WriteResult result = writer.write(sample);
    if (result) return;
    ASSERT_EQ(result.kind, WriteResult::Kind::full) << result.error;
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "full for too long";
  }
}

/// Volatile samples that are written before both sides know each other are lost: repeats `marker` until the inbox has
/// one, and empties the inbox. Later on it may still get a repetition of the marker.
template <class Sample>
void meet(Writer<Sample>& writer, Inbox<Sample>& inbox, const Sample& marker) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (inbox.samples.empty()) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "writer and reader did not meet";
    write(writer, marker);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    inbox.take();
  }
  inbox.samples.clear();
}

}  // namespace lamprey::messaging::conformance
