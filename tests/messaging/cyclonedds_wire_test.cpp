#include "messaging/cyclonedds/wire.hpp"
#include "tests/messaging/example_samples.hpp"

#include <gtest/gtest.h>

namespace lamprey::messaging::cyclonedds {
namespace {

template <class Sample>
class CycloneWire : public ::testing::Test {};
using AllSamples =
    ::testing::Types<WorkerStatus, SweepSpecification, Lease, ResultBatch, ResultAcknowledgement, Checkpoint, Request,
                     Reply, SweepProgress, Traffic, RobotStatus, RobotRequest, RobotReply, ServoCommand, ServoState>;
TYPED_TEST_SUITE(CycloneWire, AllSamples);

TYPED_TEST(CycloneWire, ThereAndBackIsTheSame) {
  for (const auto& sample : {TypeParam{}, testing::example<TypeParam>(), testing::extreme<TypeParam>()}) {
    Arena arena;
    TypeParam back;
    EXPECT_TRUE(from_wire(to_wire(sample, arena), back));
    EXPECT_EQ(back, sample);
  }
}

// The C enumeration can hold no value beyond its bits; Cyclone itself refuses those.
TEST(CycloneWireHostile, UnknownEnumeratorIsRefused) {
  Arena arena;
  WorkerStatus status;
  auto wire = to_wire(status, arena);
  wire.state = static_cast<lamprey_wire_WorkerState>(3);
  EXPECT_FALSE(from_wire(wire, status));
}

TEST(CycloneWireHostile, TraceColumnsOfUnequalLengthAreRefused) {
  Arena arena;
  auto batch = testing::example<ResultBatch>();
  auto wire = to_wire(batch, arena);
  wire.results._buffer[2].outcome.trace.fuel._length -= 1;
  EXPECT_FALSE(from_wire(wire, batch));
}

}  // namespace
}  // namespace lamprey::messaging::cyclonedds
