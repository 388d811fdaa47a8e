#include "robot_bridge/emulators/ssc32/command.hpp"

#include <gtest/gtest.h>
#include <random>

namespace lamprey::robot_bridge::emulators::ssc32 {
namespace {

std::string reason(std::string_view line) {
  const Command command = parse(line);
  const auto* bad = std::get_if<Bad>(&command);
  return bad == nullptr ? "nothing" : bad->reason;
}

// Examples of the SSC-32U user guide.
TEST(CommandTest, ReadsTheUserGuidesMoves) {
  const auto speed = std::get<Move>(parse("#5P1500S750"));
  ASSERT_EQ(speed.targets.size(), 1U);
  EXPECT_EQ(speed.targets[0].channel, 5U);
  EXPECT_EQ(speed.targets[0].pulse, 1500);
  EXPECT_EQ(speed.targets[0].speed, 750);
  EXPECT_FALSE(speed.milliseconds);

  const auto time = std::get<Move>(parse("#3P1600T1000"));
  EXPECT_EQ(time.milliseconds, 1000);
  EXPECT_FALSE(time.targets[0].speed);

  const auto group = std::get<Move>(parse("#5 P1600 #17 P750 S500 #2 P2250 T2000 "));
  ASSERT_EQ(group.targets.size(), 3U);
  EXPECT_EQ(group.targets[1].channel, 17U);
  EXPECT_EQ(group.targets[1].speed, 500);
  EXPECT_EQ(group.targets[2].pulse, 2250);
  EXPECT_EQ(group.milliseconds, 2000);
}

TEST(CommandTest, ReadsTheUserGuidesQueries) {
  EXPECT_TRUE(std::holds_alternative<QueryMovement>(parse("Q")));
  EXPECT_TRUE(std::holds_alternative<QueryVersion>(parse("VER")));
  EXPECT_EQ(std::get<QueryPulses>(parse("QP 5 QP 17 QP2")).channels, (std::vector<unsigned>{5, 17, 2}));
  EXPECT_EQ(std::get<Stop>(parse("STOP 31")).channel, 31U);
  const auto digital = std::get<ReadDigital>(parse("ABEDL")).inputs;
  ASSERT_EQ(digital.size(), 4U);
  EXPECT_EQ(digital[2].input, 4U);
  EXPECT_FALSE(digital[2].latched);
  EXPECT_EQ(digital[3].input, 3U);
  EXPECT_TRUE(digital[3].latched);
  EXPECT_EQ(std::get<ReadAnalog>(parse("VA VB VC VH")).inputs, (std::vector<unsigned>{0, 1, 2, 7}));
}

TEST(CommandTest, CaseSpacesTabsAndLineFeedsDoNotMatter) {
  const auto move = std::get<Move>(parse("\n #\t1 0p15 00 \ns2t30"));
  EXPECT_EQ(move.targets[0].channel, 10U);
  EXPECT_EQ(move.targets[0].pulse, 1500);
  EXPECT_EQ(move.targets[0].speed, 2);
  EXPECT_EQ(move.milliseconds, 30);
  EXPECT_TRUE(std::holds_alternative<QueryVersion>(parse("v e r")));
  EXPECT_TRUE(std::holds_alternative<Nothing>(parse(" \n\t")));
}

TEST(CommandTest, LimitsAreAllowedAndWhatIsBeyondThemIsNot) {
  EXPECT_EQ(reason("#0P500#31P2500S65535T65535"), "nothing");
  EXPECT_EQ(reason("#0P0"), "nothing");
  EXPECT_EQ(reason("#32P1500"), "channel");
  EXPECT_EQ(reason("#P1500"), "channel");
  EXPECT_EQ(reason("#-1P1500"), "channel");
  EXPECT_EQ(reason("#0P499"), "pulse width");
  EXPECT_EQ(reason("#0P2501"), "pulse width");
  EXPECT_EQ(reason("#0P-1500"), "pulse width");
  EXPECT_EQ(reason("#0P"), "pulse width");
  EXPECT_EQ(reason("#0P1500T65536"), "time");
  EXPECT_EQ(reason("#0P1500T"), "time");
  EXPECT_EQ(reason("#0P1500S65536"), "speed");
  EXPECT_EQ(reason("#0P99999999999999999999"), "pulse width");
  EXPECT_EQ(reason("QP32"), "channel");
  EXPECT_EQ(reason("STOP"), "channel");
  EXPECT_EQ(reason("STOP32"), "channel");
}

TEST(CommandTest, CommandTypesDoNotMixAndNothingMayFollow) {
  for (const char* line : {"#0P1500Q",
                           "#0P1500QP0",
                           "Q#0P1500",
                           "QP0Q",
                           "VERQ",
                           "AVA",
                           "VAA",
                           "G",
                           "VI",
                           "AG",
                           "L",
                           "#0",
                           "#0H",
                           "T100",
                           "STOP0STOP1",
                           "STOP0T10",
                           "#0P1500T10T10",
                           "#0P1500T10#1P1500",

                           "ABCDEFABC",
                           "VAVBVCVDVEVFVGVHVA",
                           "HELLO",
                           "#0P1500!"}) {
    EXPECT_EQ(reason(line), "command") << line;
  }
}

TEST(CommandTest, NoOctetsDoHarm) {
  std::mt19937 random(2006);
  constexpr std::string_view likely = "##PPSTQVERABCDEFLSTOP0123456789  ";
  int moves = 0;
  for (int round = 0; round < 50'000; ++round) {
    std::string line = round % 2 == 0 ? "#1P1500" : "";
    for (auto left = random() % 12; left > 0; --left) {
      line += random() % 8 == 0 ? static_cast<char>(random()) : likely[random() % likely.size()];
    }
    const Command command = parse(line);
    if (const auto* move = std::get_if<Move>(&command)) {
      ++moves;
      ASSERT_FALSE(move->targets.empty()) << line;
      for (const Target& target : move->targets) {
        ASSERT_LT(target.channel, channels) << line;
        ASSERT_TRUE(target.pulse == 0 || (target.pulse >= shortest_pulse && target.pulse <= longest_pulse)) << line;
      }
    }
  }
  EXPECT_GT(moves, 1000);
}

}  // namespace
}  // namespace lamprey::robot_bridge::emulators::ssc32
