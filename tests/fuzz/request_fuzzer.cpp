// Any requests of clients, one after the other, to a coordinator with a database of its own: each gets exactly one
// reply that a client can read, nothing ends it, and the database agrees with itself afterwards.
// The input: for each request two octets of length, then the octets of idl::Request.
#include "coordinator/coordinator.hpp"
#include "messaging/in_memory/bus.hpp"
#include "storage/results_reader.hpp"
#include "tests/fuzz/fuzzing.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <spdlog/spdlog.h>
#include <string>
#include <unistd.h>

namespace {

using namespace lamprey;
using coordinator::Clock;
using fuzzing::require;

constexpr std::uint64_t client = 5;
constexpr int most_requests = 6;

/// In memory where the machine has such a file system: the disk's pace isn't what is looked at.
std::filesystem::path folder() {
  const std::filesystem::path memory = "/dev/shm";
  const auto parent = ::access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path();
  return parent / ("lamprey-request-fuzzer-" + std::to_string(::getpid()));
}

/// A new, empty database is made once and copied: making one takes longer than most inputs.
class EmptyDatabase {
 public:
  EmptyDatabase() : folder_(folder()) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    const storage::ResultsStore made(path());
  }
  ~EmptyDatabase() { std::filesystem::remove_all(folder_); }
  std::string path() const { return (folder_ / "empty.db").string(); }
  const std::filesystem::path& folder_of() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

const EmptyDatabase& empty_database() {
  static const EmptyDatabase empty;
  return empty;
}

class Site {
 public:
  Site() {
    const auto& empty = empty_database();
    folder_ = empty.folder_of() / "site";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    std::filesystem::copy_file(empty.path(), database());
    writer_ = participant_->writer<messaging::Request>();
    reader_ =
        participant_->reader<messaging::Reply>(std::make_shared<messaging::Signal>(), messaging::Partition::of(client));
    coordinator_ = std::make_unique<coordinator::Coordinator>(*coordinators_, storage::ResultsStore(database()),
                                                              std::make_shared<messaging::Signal>(),
                                                              coordinator::CoordinatorOptions{}, now_);
  }
  ~Site() {
    coordinator_.reset();
    std::filesystem::remove_all(folder_);
  }

  std::string database() const { return (folder_ / "fuzz.db").string(); }

  idl::Reply ask(std::span<const std::uint8_t> payload) {
    messaging::Request sample;
    sample.client = client;
    sample.correlation = ++correlation_;
    sample.payload.assign(payload.begin(), payload.end());
    require(static_cast<bool>(writer_->write(sample)));
    step();
    const auto replies = reader_->take();
    require(replies.size() == 1 && replies.front().correlation == correlation_);
    idl::Reply reply;
    require(reply.ParseFromArray(replies.front().payload.data(), static_cast<int>(replies.front().payload.size())));
    require(reply.kind_case() != idl::Reply::KIND_NOT_SET);
    return reply;
  }

  void step() { coordinator_->step(now_ += std::chrono::milliseconds{25}); }
  void stop() {
    coordinator_->finish(now_);
    coordinator_.reset();
  }

 private:
  std::filesystem::path folder_;
  messaging::in_memory::Bus bus_;
  Clock::time_point now_{std::chrono::hours{1}};
  std::unique_ptr<messaging::Participant> coordinators_ = bus_.join("coordinator");
  std::unique_ptr<messaging::Participant> participant_ = bus_.join("client");
  std::unique_ptr<messaging::Writer<messaging::Request>> writer_;
  std::unique_ptr<messaging::Reader<messaging::Reply>> reader_;
  std::unique_ptr<coordinator::Coordinator> coordinator_;
  std::uint64_t correlation_ = 0;
};

/// Nothing of what is looked at is in the logs.
[[maybe_unused]] const bool silent = [] {
  spdlog::set_level(spdlog::level::off);
  return true;
}();

/// The sweep that a request names, of whatever kind it is.
std::string sweep_of(const idl::Request& request) {
  const auto* const kind =
      request.GetReflection()->GetOneofFieldDescriptor(request, request.GetDescriptor()->oneof_decl(0));
  if (kind == nullptr) return {};
  const auto& message = request.GetReflection()->GetMessage(request, kind);
  const auto* const sweep = message.GetDescriptor()->FindFieldByName("sweep");
  return sweep == nullptr ? std::string() : message.GetReflection()->GetString(message, sweep);
}

void look_for_planted_bug(std::span<const std::uint8_t> payload) {
  idl::Request request;
  if (!request.ParseFromArray(payload.data(), static_cast<int>(payload.size()))) return;
  const auto sweep = sweep_of(request);
  if (!fuzzing::reached<1>(sweep.size() == 1)) return;
  if (fuzzing::reached<2>(sweep[0] > 'y' || (sweep[0] > ' ' && sweep[0] < 'a'))) fuzzing::planted_bug();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::Input input(data, size);
  if (size < 3) return 0;
  // Without a sweep nothing changes, and the next input may have the same coordinator.
  empty_database();  // made first, so that it and what it has made outlive the site
  static std::unique_ptr<Site> site;
  if (site == nullptr) site = std::make_unique<Site>();
  bool submitted = false;
  for (int i = 0; i < most_requests && !input.empty(); ++i) {
    const auto length = input.u16();
    const auto payload = input.octets(length);
    submitted |= site->ask(payload).has_submit();
    look_for_planted_bug(payload);
  }
  if (!submitted) return 0;
  for (int i = 0; i < 4; ++i) site->step();
  site->stop();
  require(storage::verify(site->database()).discrepancies.empty());
  site.reset();
  return 0;
}
