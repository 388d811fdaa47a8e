#include "robot_bridge/recording/mcap_writer.hpp"

#include "tests/robot_bridge/recording/records.hpp"

#include <gtest/gtest.h>
#include <stdexcept>

namespace lamprey::robot_bridge::recording {
namespace {

class McapWriterTest : public testing::Test {
 protected:
  ScratchFile file;
  std::vector<Channel> channels{{"/a", "a_msgs/msg/A", "uint8 value"}, {"/b", "b_msgs/msg/B", "uint8 other"}};
  const std::vector<std::uint8_t> message{0, 1, 0, 0, 42};
};

TEST_F(McapWriterTest, HasTheSpecificationsRecordsInOrder) {
  McapWriter writer(file.path(), channels);
  writer.write(0, 5, message);
  writer.write(1, 7, message);
  writer.finish();
  EXPECT_EQ(opcodes(file.octets()),
            (std::vector<int>{0x01, 0x03, 0x04, 0x03, 0x04, 0x05, 0x05, 0x0F, 0x03, 0x04, 0x03, 0x04, 0x0B, 0x02}));
}

TEST_F(McapWriterTest, TheFooterSaysWhereTheSummaryIs) {
  McapWriter writer(file.path(), channels);
  writer.write(0, 5, message);
  writer.finish();
  const auto octets = file.octets();
  const auto found = records(octets);
  const auto summary = number<std::uint64_t>(found.back().content, 0);
  EXPECT_EQ(octets.at(summary), 0x03);
  EXPECT_EQ(summary, found[7].offset) << "behind header, two schemas with channels, a message and the data's end";
}

TEST_F(McapWriterTest, CountsItsMessages) {
  McapWriter writer(file.path(), channels);
  for (std::uint64_t time = 5; time < 8; ++time) writer.write(1, time, message);
  writer.finish();
  const auto statistics = records(file.octets()).at(13);
  ASSERT_EQ(statistics.opcode, 0x0B);
  EXPECT_EQ(number<std::uint64_t>(statistics.content, 0), 3U);
  EXPECT_EQ(number<std::uint64_t>(statistics.content, 26), 5U) << "the first's time";
  EXPECT_EQ(number<std::uint64_t>(statistics.content, 34), 7U) << "the last's";
}

TEST_F(McapWriterTest, IsReadableHoweverTheProgramEnds) {
  {
    McapWriter writer(file.path(), channels);
    writer.write(0, 5, message);
    writer.flush();
    EXPECT_EQ(opcodes(file.octets()), (std::vector<int>{0x01, 0x03, 0x04, 0x03, 0x04, 0x05}));
  }
}

TEST_F(McapWriterTest, AFileThatCannotBeWrittenIsAnError) {
  EXPECT_THROW(McapWriter("/nowhere/at/all.mcap", channels), std::runtime_error);
}

}  // namespace
}  // namespace lamprey::robot_bridge::recording
