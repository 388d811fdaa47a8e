// Samples that no program of ours writes, sent by one that uses DDS directly: dropped, counted, and reported once.
#include "messaging/malformed_samples.hpp"

#include "messaging/cyclonedds/configuration.hpp"
#include "messaging/cyclonedds/wire.hpp"
#include "messaging/names.hpp"
#include "messaging/qos.hpp"
#include "tests/messaging/example_samples.hpp"

#include <algorithm>
#include <chrono>
#include <dds/dds.h>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <sstream>
#include <string>
#include <thread>

namespace lamprey::messaging {
namespace {

using testing::example;

constexpr std::chrono::seconds patience{60};

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// Collects what is logged while it lives.
class Log {
 public:
  Log() : before_(spdlog::default_logger()) {
    spdlog::set_default_logger(
        std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text_)));
  }
  ~Log() { spdlog::set_default_logger(before_); }
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;
  std::string text() const { return text_.str(); }

 private:
  std::shared_ptr<spdlog::logger> before_;
  std::ostringstream text_;
};

TEST(MalformedSamples, AreCountedAndReportedOncePerTopicAndSource) {
  const Log log;
  MalformedSamples malformed;
  for (int i = 0; i < 5; ++i) malformed.note("a/topic", "writer 1", "too long");
  malformed.note("a/topic", "writer 2", "too long");
  malformed.note("b/topic", "writer 1", "too long");
  EXPECT_EQ(malformed.count(), 7U);
  EXPECT_EQ(occurrences(log.text(), "malformed sample"), 3U) << log.text();
}

TEST(MalformedSamples, AFloodOfSourcesDoesNotFillTheLog) {
  const Log log;
  MalformedSamples malformed;
  for (int i = 0; i < 10'000; ++i) malformed.note("a/topic", std::to_string(i), "too long");
  EXPECT_EQ(malformed.count(), 10'000U);
  EXPECT_EQ(occurrences(log.text(), "malformed sample"), MalformedSamples::most_sources);
}

/// A program that is none of ours.
class Rogue {
 public:
  explicit Rogue(const JoinOptions& options) {
    constexpr dds_domainid_t inside = 250;
    domain_ = dds_create_domain(inside, cyclonedds::configuration(options, options.domain).c_str());
    const dds_entity_t participant = dds_create_participant(inside, nullptr, nullptr);
    dds_qos_t* qos = dds_create_qos();
    dds_qset_partition1(qos, partition_name(options.isolation, Partition::common()).c_str());
    const dds_entity_t publisher = dds_create_publisher(participant, qos, nullptr);
    dds_delete_qos(qos);
    qos = dds_create_qos();
    const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
    dds_qset_data_representation(qos, 1, &representation);
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
    dds_qset_liveliness(qos, DDS_LIVELINESS_AUTOMATIC, DDS_MSECS(2000));
    const std::string name(Topic<WorkerStatus>::name);
    const dds_entity_t topic =
        dds_create_topic(participant, &lamprey_wire_WorkerStatus_desc, name.c_str(), qos, nullptr);
    writer_ = dds_create_writer(publisher, topic, qos, nullptr);
    dds_delete_qos(qos);
  }
  ~Rogue() { dds_delete(domain_); }
  Rogue(const Rogue&) = delete;
  Rogue& operator=(const Rogue&) = delete;

  void write(const WorkerStatus& status) {
    cyclonedds::Arena arena;
    const auto wire = cyclonedds::to_wire(status, arena);
    ASSERT_EQ(dds_write(writer_, &wire), DDS_RETCODE_OK);
  }

 private:
  dds_entity_t domain_ = 0;
  dds_entity_t writer_ = 0;
};

class RogueWriter : public ::testing::TestWithParam<const char*> {};

TEST_P(RogueWriter, IsCountedAndWhatIsGoodStillArrives) {
  const Log log;
  std::random_device random;
  const JoinOptions options{.vendor = GetParam(),
                            .domain = 0,
                            .isolation = "rogue-" + std::to_string(random()) + std::to_string(random()),
                            .peers = {},
                            .loopback_only = true,
                            .introduction = {}};
  const auto participant = join(options);
  const auto signal = std::make_shared<Signal>();
  const auto reader = participant->reader<WorkerStatus>(signal);
  Rogue rogue(options);
  auto bad = example<WorkerStatus>(1);
  bad.labels.assign(1'000, "label");
  auto good = example<WorkerStatus>(2);
  std::vector<WorkerStatus> received;
  const auto until = std::chrono::steady_clock::now() + patience;
  while ((received.empty() || participant->malformed_samples() < 2) && std::chrono::steady_clock::now() < until) {
    rogue.write(bad);
    rogue.write(good);
    signal->wait_for(std::chrono::milliseconds{100});
    for (auto& sample : reader->take()) received.push_back(std::move(sample));
  }
  EXPECT_GE(participant->malformed_samples(), 2U);
  ASSERT_FALSE(received.empty());
  for (const auto& sample : received) EXPECT_EQ(sample, good);
  EXPECT_EQ(occurrences(log.text(), "labels: size 1000, at most 64"), 1U) << log.text();
}

INSTANTIATE_TEST_SUITE_P(Vendors, RogueWriter, ::testing::Values("cyclonedds", "fastdds"),
                         [](const auto& vendor) { return std::string(vendor.param); });

}  // namespace
}  // namespace lamprey::messaging
