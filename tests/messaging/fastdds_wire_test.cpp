#include "messaging/fastdds/type_support.hpp"
#include "messaging/fastdds/wire.hpp"
#include "tests/messaging/example_samples.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>
#include <gtest/gtest.h>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace lamprey::messaging::fastdds {
namespace {

using Payload = eprosima::fastrtps::rtps::SerializedPayload_t;

template <class Sample>
std::vector<std::uint8_t> serialised(const Sample& sample) {
  GuardedType<Sample> type(std::make_shared<MalformedSamples>());
  typename Wire<Sample>::Type data;
  to_wire(sample, data);
  Payload payload(type.getSerializedSizeProvider(&data)());
  EXPECT_TRUE(type.serialize(&data, &payload));
  return {payload.data, payload.data + payload.length};
}

template <class Sample>
bool deserialise(const std::vector<std::uint8_t>& octets, typename Wire<Sample>::Type& data) {
  GuardedType<Sample> type(std::make_shared<MalformedSamples>());
  Payload payload(static_cast<std::uint32_t>(octets.size()));
  std::copy(octets.begin(), octets.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(octets.size());
  return type.deserialize(&payload, &data);
}

template <class Sample>
class FastWire : public ::testing::Test {};
using AllSamples =
    ::testing::Types<WorkerStatus, SweepSpecification, Lease, ResultBatch, ResultAcknowledgement, Checkpoint, Request,
                     Reply, SweepProgress, Traffic, RobotStatus, RobotRequest, RobotReply, ServoCommand, ServoState>;
TYPED_TEST_SUITE(FastWire, AllSamples);

TYPED_TEST(FastWire, ThereAndBackIsTheSame) {
  for (const auto& sample : {TypeParam{}, testing::example<TypeParam>(), testing::extreme<TypeParam>()}) {
    typename Wire<TypeParam>::Type data;
    ASSERT_TRUE(deserialise<TypeParam>(serialised(sample), data));
    TypeParam back;
    EXPECT_TRUE(from_wire(data, back));
    EXPECT_EQ(back, sample);
  }
}

TYPED_TEST(FastWire, TruncatedPayloadsAreRefused) {
  const auto whole = serialised(testing::example<TypeParam>());
  for (std::size_t size = 0; size < whole.size(); size += size < 512 ? 1 : 97) {
    typename Wire<TypeParam>::Type data;
    EXPECT_FALSE(deserialise<TypeParam>({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}, data))
        << size;
  }
}

TYPED_TEST(FastWire, DamagedLengthsAreSurvived) {
  const auto whole = serialised(testing::example<TypeParam>());
  for (std::size_t position = 4; position + 4 <= whole.size(); position += 4) {
    auto hostile = whole;
    std::memset(hostile.data() + position, 0xfe, 4);
    typename Wire<TypeParam>::Type data;
    if (!deserialise<TypeParam>(hostile, data)) continue;
    TypeParam sample;
    static_cast<void>(from_wire(data, sample));
  }
}

// Generated code resizes a vector to whatever its length says.
TEST(FastWireHostile, LengthBeyondThePayloadIsRefusedBeforeMemoryIsSetAside) {
  Request request = testing::example<Request>();
  auto octets = serialised(request);
  const std::size_t length_position = octets.size() - request.payload.size() - 4;
  EXPECT_TRUE(lengths_are_possible<Request>(octets));
  octets[length_position] = static_cast<std::uint8_t>(octets[length_position] + 1);
  EXPECT_FALSE(lengths_are_possible<Request>(octets));
  std::memset(octets.data() + length_position, 0xff, 4);
  EXPECT_FALSE(lengths_are_possible<Request>(octets));
}

TEST(FastWireHostile, PayloadsOfBigEndianSendersAreUnderstood) {
  // Encapsulation CDR_BE, worker, origin, client, correlation, a payload of two octets.
  std::vector<std::uint8_t> octets(4 + 8 + 32 + 16, 0);
  octets.insert(octets.end(), {0, 0, 0, 2, 7, 8});
  EXPECT_TRUE(lengths_are_possible<Request>(octets));
  wire::Request data;
  ASSERT_TRUE(deserialise<Request>(octets, data));
  EXPECT_EQ(data.payload(), (std::vector<std::uint8_t>{7, 8}));
  octets[octets.size() - 3] = 3;
  EXPECT_FALSE(lengths_are_possible<Request>(octets));
}

TYPED_TEST(FastWire, RandomDamageIsSurvived) {
  std::mt19937_64 random(7);
  const auto whole = serialised(testing::example<TypeParam>());
  for (int i = 0; i < 2000; ++i) {
    auto hostile = whole;
    for (int flips = 0; flips < 4; ++flips) hostile[random() % hostile.size()] = static_cast<std::uint8_t>(random());
    typename Wire<TypeParam>::Type data;
    if (!deserialise<TypeParam>(hostile, data)) continue;
    TypeParam sample;
    static_cast<void>(from_wire(data, sample));
  }
}

TEST(FastWireHostile, UnknownEnumeratorsAreRefused) {
  wire::WorkerStatus status;
  to_wire(WorkerStatus{}, status);
  status.state(static_cast<wire::WorkerState>(3));
  WorkerStatus back;
  EXPECT_FALSE(from_wire(status, back));

  wire::Lease lease;
  to_wire(Lease{}, lease);
  lease.kind(static_cast<wire::LeaseKind>(256));
  Lease lease_back;
  EXPECT_FALSE(from_wire(lease, lease_back));
}

TEST(FastWireHostile, MeasuresBeyondThePayloadAreRefusedBeforeMemoryIsSetAside) {
  ResultBatch batch;
  batch.results.resize(1);
  auto& result = batch.results[0];
  result.outcome.measures = {{"recovered", 7, 1}};
  auto octets = serialised(batch);
  // The count, the length of the name, the name.
  const std::string name = "recovered";
  const auto found = std::search(octets.begin(), octets.end(), name.begin(), name.end());
  const auto count_position = static_cast<std::size_t>(found - octets.begin()) - 8;
  ASSERT_EQ(octets.at(count_position), 1);
  ResultBatchOnWire data;
  EXPECT_TRUE(deserialise<ResultBatch>(octets, data));
  octets[count_position] = 255;
  EXPECT_FALSE(deserialise<ResultBatch>(octets, data));
  EXPECT_TRUE(data.incoming.results.at(0).outcome.measures.empty());
  std::memset(octets.data() + count_position, 0xff, 4);
  EXPECT_FALSE(deserialise<ResultBatch>(octets, data));
  EXPECT_TRUE(data.incoming.results.at(0).outcome.measures.empty());
}

// One object serves a writer's or reader's samples one after another.
TYPED_TEST(FastWire, NothingOfAnEarlierSampleStaysBehind) {
  typename Wire<TypeParam>::Type outgoing;
  typename Wire<TypeParam>::Type incoming;
  for (const auto& sample : {testing::extreme<TypeParam>(), testing::example<TypeParam>(), TypeParam{}}) {
    GuardedType<TypeParam> type(std::make_shared<MalformedSamples>());
    to_wire(sample, outgoing);
    Payload payload(type.getSerializedSizeProvider(&outgoing)());
    ASSERT_TRUE(type.serialize(&outgoing, &payload));
    ASSERT_TRUE(type.deserialize(&payload, &incoming));
    TypeParam back;
    EXPECT_TRUE(from_wire(incoming, back));
    EXPECT_EQ(back, sample);
  }
}

/// As the generated code understands it.
wire::ResultBatch generated(const ResultBatch& sample) {
  const auto octets = serialised(sample);
  Payload payload(static_cast<std::uint32_t>(octets.size()));
  std::copy(octets.begin(), octets.end(), payload.data);
  payload.length = static_cast<std::uint32_t>(octets.size());
  wire::ResultBatch batch;
  EXPECT_TRUE(wire::ResultBatchPubSubType().deserialize(&payload, &batch));
  return batch;
}

/// As the generated code writes it.
std::vector<std::uint8_t> octets_of(const wire::ResultBatch& batch, eprosima::fastcdr::Cdr::Endianness endianness) {
  std::vector<char> octets(4 + wire::ResultBatch::getCdrSerializedSize(batch));
  eprosima::fastcdr::FastBuffer buffer(octets.data(), octets.size());
  eprosima::fastcdr::Cdr cdr(buffer, endianness, eprosima::fastcdr::Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  batch.serialize(cdr);
  return {octets.begin(), octets.begin() + static_cast<std::ptrdiff_t>(cdr.getSerializedDataLength())};
}

TEST(FastWireResultBatch, IsTheGeneratedCodesOctetForOctet) {
  for (const auto& sample : {ResultBatch{}, testing::example<ResultBatch>(), testing::extreme<ResultBatch>()}) {
    EXPECT_EQ(serialised(sample), octets_of(generated(sample), eprosima::fastcdr::Cdr::DEFAULT_ENDIAN));
  }
}

TEST(FastWireResultBatch, OfABigEndianSenderIsUnderstood) {
  const auto sample = testing::example<ResultBatch>();
  ResultBatchOnWire data;
  ASSERT_TRUE(deserialise<ResultBatch>(octets_of(generated(sample), eprosima::fastcdr::Cdr::BIG_ENDIANNESS), data));
  ResultBatch back;
  EXPECT_TRUE(from_wire(data, back));
  EXPECT_EQ(back, sample);
}

TEST(FastWireHostile, OddBatchesOfResultsAreRefused) {
  using Change = void (*)(wire::JobResult&);
  const std::vector<Change> changes = {
      [](wire::JobResult& result) { result.kind(static_cast<wire::ResultKind>(2)); },
      [](wire::JobResult& result) { result.outcome().trace().cycles().push_back(7); },
      [](wire::JobResult& result) { result.outcome().trace().stability().pop_back(); },
      [](wire::JobResult& result) { result.outcome().trace().distance().push_back(7); },
      [](wire::JobResult& result) { result.outcome().trace().fuel().pop_back(); },
      [](wire::JobResult& result) { result.outcome().trace().total().clear(); },
  };
  for (const Change change : changes) {
    auto batch = generated(testing::example<ResultBatch>());
    change(batch.results()[2]);
    ResultBatchOnWire data;
    ASSERT_TRUE(deserialise<ResultBatch>(octets_of(batch, eprosima::fastcdr::Cdr::DEFAULT_ENDIAN), data));
    ResultBatch back;
    EXPECT_FALSE(from_wire(data, back));
  }
}

}  // namespace
}  // namespace lamprey::messaging::fastdds
