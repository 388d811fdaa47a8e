#include "robot_bridge/drivers/serial_line.hpp"

#include "pseudo_terminal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <thread>

namespace lamprey::robot_bridge::drivers {
namespace {

using Kind = DriverError::Kind;
using Octets = std::vector<std::uint8_t>;

SerialLine::Deadline in(std::chrono::milliseconds time) {
  return SerialLine::Clock::now() + time;
}
SerialLine::Deadline soon() {
  return in(std::chrono::milliseconds(20));
}
SerialLine::Deadline late() {
  return in(std::chrono::seconds(30));
}

std::string text(const Octets& octets) {
  return {octets.begin(), octets.end()};
}

Octets octets(const std::string& text) {
  return {text.begin(), text.end()};
}

/// The kind of the error that a call ends with.
template <typename Call>
Kind kind_of_error(const Call& call) {
  try {
    call();
  } catch (const DriverError& error) {
    return error.kind();
  }
  ADD_FAILURE() << "no error";
  return {};
}

/// Answers everything with itself.
std::string echo(std::string& received) {
  return std::exchange(received, {});
}

TEST(SerialLine, CarriesEveryOctetAsItIs) {
  PseudoTerminal terminal(echo);
  SerialLine line(terminal.port(), 115200);
  line.open();
  Octets all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  line.write(all, late());
  EXPECT_EQ(line.read_exactly(all.size(), late()), all);
}

TEST(SerialLine, TakesOneMegabaudOnAPseudoTerminal) {
  PseudoTerminal terminal(echo);
  SerialLine line(terminal.port(), 1'000'000);
  line.open();
  line.write(octets("a"), late());
  EXPECT_EQ(text(line.read_exactly(1, late())), "a");
}

TEST(SerialLine, KeepsWhatFollowsALineForTheNextRead) {
  PseudoTerminal terminal;
  SerialLine line(terminal.port(), 9600);
  line.open();
  terminal.send("SSC32\r12345");
  EXPECT_EQ(text(line.read_until('\r', 64, late())), "SSC32");
  EXPECT_EQ(text(line.read_exactly(3, late())), "123");
  EXPECT_EQ(text(line.read_exactly(2, late())), "45");
}

TEST(SerialLine, TellsSilenceFromAPartOfAnAnswer) {
  PseudoTerminal terminal;
  SerialLine line(terminal.port(), 9600);
  line.open();
  EXPECT_TRUE(line.read_some(soon()).empty());
  EXPECT_EQ(kind_of_error([&] { line.read_exactly(2, soon()); }), Kind::silent);
  EXPECT_EQ(kind_of_error([&] { line.read_until('\r', 8, soon()); }), Kind::silent);
  terminal.send("a");
  EXPECT_EQ(kind_of_error([&] { line.read_exactly(2, in(std::chrono::milliseconds(200))); }), Kind::garbled);
  terminal.send("b");
  EXPECT_EQ(kind_of_error([&] { line.read_until('\r', 8, in(std::chrono::milliseconds(200))); }), Kind::garbled);
}

TEST(SerialLine, ReadsNoLineThatIsLongerThanAllowed) {
  PseudoTerminal terminal;
  SerialLine line(terminal.port(), 9600);
  line.open();
  terminal.send("123456789");
  EXPECT_EQ(kind_of_error([&] { line.read_until('\r', 8, late()); }), Kind::garbled);
}

TEST(SerialLine, ForgetsWhatCameBeforeWhereItIsTold) {
  PseudoTerminal terminal;
  SerialLine line(terminal.port(), 9600);
  line.open();
  terminal.send("\rold");
  line.read_until('\r', 8, late());
  while (line.waiting() < 3) std::this_thread::yield();
  line.drain_input();
  EXPECT_EQ(line.waiting(), 0U);
  terminal.send("new");
  EXPECT_EQ(text(line.read_exactly(3, late())), "new");
}

TEST(SerialLine, IsDisconnectedWhereThePortCantBeOpened) {
  SerialLine line("/dev/lamprey-has-no-such-line", 9600);
  EXPECT_EQ(kind_of_error([&] { line.open(); }), Kind::disconnected);
  EXPECT_FALSE(line.is_open());
  EXPECT_EQ(kind_of_error([&] { line.write(octets("a"), late()); }), Kind::disconnected);
  EXPECT_EQ(kind_of_error([&] { line.drain_input(); }), Kind::disconnected);
}

TEST(SerialLine, IsDisconnectedWhereThePortIsNoTerminal) {
  SerialLine line("/dev/null", 9600);
  EXPECT_EQ(kind_of_error([&] { line.open(); }), Kind::disconnected);
}

TEST(SerialLine, IsNobodyElsesWhileItIsOpen) {
  PseudoTerminal terminal;
  SerialLine first(terminal.port(), 9600);
  SerialLine second(terminal.port(), 9600);
  first.open();
  try {
    second.open();
    FAIL() << "opened twice";
  } catch (const DriverError& error) {
    EXPECT_EQ(error.kind(), Kind::disconnected);
    EXPECT_THAT(error.what(), testing::HasSubstr("in use by another program"));
  }
  first.close();
  EXPECT_NO_THROW(second.open());
}

TEST(SerialLine, IsDisconnectedByThePlugInTheMiddleOfARead) {
  PseudoTerminal terminal;
  SerialLine line(terminal.port(), 9600);
  line.open();
  std::thread hand([&] { terminal.unplug(); });
  EXPECT_EQ(kind_of_error([&] { line.read_exactly(1, late()); }), Kind::disconnected);
  hand.join();
}

TEST(SerialLine, EndsAReadThatIsCancelledFromAnotherThread) {
  PseudoTerminal terminal;
  SerialLine line(terminal.port(), 9600);
  line.open();
  std::thread other([&] { line.cancel(); });
  EXPECT_EQ(kind_of_error([&] { line.read_exactly(1, late()); }), Kind::cancelled);
  other.join();
  EXPECT_EQ(kind_of_error([&] { line.read_some(late()); }), Kind::cancelled) << "the whole call is cancelled";
  line.begin_call();
  terminal.send("a");
  EXPECT_EQ(text(line.read_exactly(1, late())), "a");
}

TEST(SerialLine, GivesUpAWriteThatNobodyTakes) {
  PseudoTerminal terminal([](std::string&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return std::string();
  });
  SerialLine line(terminal.port(), 9600);
  line.open();
  EXPECT_EQ(kind_of_error([&] { line.write(Octets(1 << 20), in(std::chrono::milliseconds(50))); }), Kind::silent);
}

TEST(SerialLine, KnowsHowLongOctetsAreOnTheWire) {
  EXPECT_EQ(SerialLine("", 9600).wire_time(61).count(), 63541);
  EXPECT_EQ(SerialLine("", 1'000'000).wire_time(54).count(), 540);
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers
