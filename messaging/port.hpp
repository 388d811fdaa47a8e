#pragma once

#include "messaging/discovery/domain_view.hpp"
#include "messaging/samples.hpp"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

/// The port that everything above messaging is written against. in_memory/, fastdds/ and cyclonedds/ implement it;
/// nothing above may know which one it runs on.
namespace lamprey::messaging {

/// Why a write did not happen. A vendor's code and text are kept.
struct [[nodiscard]] WriteResult {
  enum class Kind : std::uint8_t {
    written,
    full,  ///< a reliable reader has not kept up; nothing was written, try again later
    failed,
  };
  Kind kind = Kind::written;
  std::string error;

  explicit operator bool() const { return kind == Kind::written; }
};

/// Wakes a program's loop when any of its readers has got samples. Notified from vendor threads; waited for by one
/// thread. A notification that comes before the wait is not lost.
class Signal {
 public:
  void notify();
  /// Until notified or `timeout` has passed; whether it was notified.
  bool wait_for(std::chrono::milliseconds timeout);

 private:
  std::mutex mutex_;
  std::condition_variable condition_;
  bool notified_ = false;
};

/// Writes samples of one topic. One thread at a time. write() never blocks for longer than 100 ms.
template <class Sample>
class Writer {
 public:
  virtual ~Writer() = default;
  virtual WriteResult write(const Sample& sample) = 0;
};

/// Holds the samples that arrived on one topic until they are taken: the last one of each key, or where there are no
/// keys up to 4096. Then, as the vendor can, a reliable writer is told that it is full, or the oldest sample is lost:
/// so take often, and let whoever gets no answer send again. One thread at a time.
template <class Sample>
class Reader {
 public:
  virtual ~Reader() = default;
  /// All samples that have arrived since the last call (up to `most`), in order per writer; never blocks.
  virtual std::vector<Sample> take(std::size_t most = 4096) = 0;
};

/// Whose samples meet: those of equal partitions. Directed topics (lease, acknowledgement, reply) have a partition per
/// receiver; `common` is shared by all programs of one isolation.
struct Partition {
  std::uint64_t receiver = 0;  ///< worker incarnation or client; 0: common

  static Partition common() { return {}; }
  static Partition of(std::uint64_t receiver) { return {receiver}; }
  bool operator==(const Partition&) const = default;
};

/// The part of the port for one topic; the sample's type names the topic and its quality of service (qos.hpp).
template <class Sample>
class TopicPort {
 public:
  virtual ~TopicPort() = default;
  virtual std::unique_ptr<Writer<Sample>> make_writer(std::type_identity<Sample>, Partition partition) = 0;
  virtual std::unique_ptr<Reader<Sample>> make_reader(std::type_identity<Sample>, Partition partition,
                                                      std::shared_ptr<Signal> signal) = 0;
};

template <class... Samples>
class TopicPorts : public TopicPort<Samples>... {
 public:
  using TopicPort<Samples>::make_writer...;
  using TopicPort<Samples>::make_reader...;
};

/// A program's membership of the DDS domain. Writers and readers must be destroyed before it.
/// make_writer and make_reader throw std::runtime_error with the vendor's reason; callable from any thread.
class Participant : public TopicPorts<WorkerStatus, SweepSpecification, Lease, ResultBatch, ResultAcknowledgement,
                                      Checkpoint, Request, Reply, SweepProgress, Traffic, RobotStatus, RobotRequest,
                                      RobotReply, ServoCommand, ServoState> {
 public:
  template <class Sample>
  std::unique_ptr<Writer<Sample>> writer(Partition partition = Partition::common()) {
    return this->make_writer(std::type_identity<Sample>{}, partition);
  }
  /// `signal` is notified whenever samples arrive (also for those that had arrived before the reader was made).
  template <class Sample>
  std::unique_ptr<Reader<Sample>> reader(std::shared_ptr<Signal> signal, Partition partition = Partition::common()) {
    return this->make_reader(std::type_identity<Sample>{}, partition, std::move(signal));
  }

  /// "fastdds", "cyclonedds" or "in_memory".
  virtual std::string vendor() const = 0;

  /// Samples that its readers have dropped since it joined, because no program of ours writes such. Any thread.
  virtual std::uint64_t malformed_samples() const = 0;

  /// What its writers and readers have exchanged since it joined. Any thread.
  virtual Traffic traffic() const = 0;

  /// Whom discovery has found in the domain, of whatever isolation and make; without this participant. One thread.
  virtual std::vector<discovery::Participant> others() = 0;
};

/// How a program joins; the command-line options of messaging/program/ fill it.
struct JoinOptions {
  std::string vendor = "cyclonedds";
  std::uint32_t domain = 0;
  std::string isolation = "lamprey";    ///< programs of different isolation never meet, on one host or network
  std::vector<std::string> peers = {};  ///< hosts to look for without multicast; empty: multicast
  /// Network interfaces, each by its name or IPv4 address (network_interfaces.hpp): no others are used, but for the
  /// loopback one between programs of this machine. Empty: as the vendor chooses.
  std::vector<std::string> interfaces = {};
  /// "HOST" or "HOST:PORT" (discovery/server_address.hpp): who has these is found by them alone. Fast DDS only, and
  /// not with peers. Empty: everybody finds everybody.
  std::vector<std::string> discovery_servers = {};
  /// This machine only: no multicast, no other interface. Peers, interfaces and discovery servers have no meaning then.
  bool loopback_only = false;
  /// One of many programs alike, a worker, that have nothing to tell each other: it announces itself to everybody who
  /// listens, and does not listen itself; who listens answers. So N of them cost discovery N instead of N² exchanges
  /// (docs/scale.md). Two such programs don't meet. Where it must be found by its address (a coordinator that names its
  /// host as a peer) it is. Of no effect with discovery servers, which tell each only of those that it needs.
  bool one_of_many = false;
  std::string configuration_file = {};  ///< that some of this is from (docs/formats/configuration.md); empty: none
  /// What everybody in the domain may know of the program; the isolation and the wire's version are added.
  discovery::Introduction introduction{};
};

/// The introduction with what joining adds.
discovery::Introduction introduction_of(const JoinOptions& options);

/// The same as the participant announces it.
std::string user_data_of(const JoinOptions& options);

/// Joining failed: no such vendor, a bad option, or the vendor's own reason.
class JoinError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Loads the vendor's library by name (next to the program or in ../lib) and joins. Throws JoinError naming
/// the vendor, the reason, and the vendors that exist.
std::unique_ptr<Participant> join(const JoinOptions& options);

}  // namespace lamprey::messaging
