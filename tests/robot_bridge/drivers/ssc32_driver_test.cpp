#include "robot_bridge/drivers/ssc32_driver.hpp"

#include "pseudo_terminal.hpp"

#include <atomic>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <mutex>
#include <thread>

namespace lamprey::robot_bridge::drivers {
namespace {

using Kind = DriverError::Kind;
using std::chrono::milliseconds;
using testing::HasSubstr;

Calibration calibration() {
  Calibration calibration;
  calibration.family = DeviceFamily::ssc32;
  for (std::size_t servo = 0; servo < servos; ++servo) {
    calibration.joints[servo] = {.channel = static_cast<std::int32_t>(servo),
                                 .minimum = 600,
                                 .centre = 1000,
                                 .maximum = 2000,
                                 .per_unit = 33.3,
                                 .direction = 1,
                                 .offset = 0,
                                 .slew_rate = 5000};
  }
  calibration.feet[science::robots::front_left] = FootContact{.channel = 0, .closed_is_low = true};
  calibration.feet[science::robots::back_right] = FootContact{.channel = 2, .closed_is_low = true};
  return calibration;
}

/// Answers lines of the protocol with what the test has put here.
class Script {
 public:
  void version(const std::string& text) {
    const std::lock_guard lock(mutex_);
    version_ = text;
  }
  /// All servos at so many tens of microseconds.
  void pulses(int tens) { pulses(std::string(8, static_cast<char>(tens))); }
  void pulses(const std::string& octets) {
    const std::lock_guard lock(mutex_);
    pulses_ = octets;
  }
  void pulse(std::size_t servo, int tens) {
    const std::lock_guard lock(mutex_);
    pulses_[servo] = static_cast<char>(tens);
  }
  void inputs(const std::string& digits) {
    const std::lock_guard lock(mutex_);
    inputs_ = digits;
  }
  void movement(const std::string& answer) {
    const std::lock_guard lock(mutex_);
    movement_ = answer;
  }
  void silent(bool is_silent) {
    const std::lock_guard lock(mutex_);
    silent_ = is_silent;
  }

  std::string answer(std::string& received) const {
    const std::lock_guard lock(mutex_);
    std::string answer;
    for (auto end = received.find('\r'); end != std::string::npos; end = received.find('\r')) {
      const std::string line = received.substr(0, end);
      received.erase(0, end + 1);
      if (silent_) continue;
      if (line.ends_with("VER")) answer += version_;
      if (line.starts_with("QP")) answer += pulses_;
      if (line == "AC") answer += inputs_;
      if (line == "Q") answer += movement_;
    }
    return answer;
  }

 private:
  mutable std::mutex mutex_;
  bool silent_ = false;
  std::string version_ = "SSC32-V2.50USB\r";
  std::string pulses_ = std::string(8, '\0');
  std::string inputs_ = "10";
  std::string movement_ = ".";
};

class Ssc32DriverTest : public testing::Test {
 protected:
  Script script;
  PseudoTerminal terminal{[this](std::string& received) { return script.answer(received); }};
  Ssc32Driver driver{calibration(), terminal.port()};

  /// What was sent since the last call but questions for positions, when an answer to one has shown that it has come.
  std::string sent() {
    driver.present_position();
    const std::string all = terminal.received();
    std::string news = all.substr(seen_);
    seen_ = all.size();
    const std::string question = "QP0QP1QP2QP3QP4QP5QP6QP7\r";
    for (auto at = news.find(question); at != std::string::npos; at = news.find(question)) {
      news.erase(at, question.size());
    }
    return news;
  }

  Kind kind_of_error(const std::function<void()>& call) {
    try {
      call();
    } catch (const DriverError& error) {
      message = error.what();
      return error.kind();
    }
    ADD_FAILURE() << "no error";
    return {};
  }
  std::string message;
  const std::string release_ = "\x1b#0P0#1P0#2P0#3P0#4P0#5P0#6P0#7P0\r";

 private:
  std::size_t seen_ = 0;
};

TEST_F(Ssc32DriverTest, ConnectsToAnSsc32AndMovesNothing) {
  driver.connect();
  EXPECT_EQ(terminal.received(), "\x1bVER\r");
  EXPECT_EQ(driver.description(),
            "SSC-32 at " + terminal.port() + ", 115200 baud, version SSC32-V2.50USB, at most 50 steps per second");
}

TEST_F(Ssc32DriverTest, RefusesAnotherDevice) {
  script.version("GRBL 1.1\r");
  EXPECT_EQ(kind_of_error([&] { driver.connect(); }), Kind::garbled);
  EXPECT_THAT(message, HasSubstr("is no SSC-32"));
}

TEST_F(Ssc32DriverTest, ConnectsThroughNoiseAtThePlug) {
  int attempts = 0;
  PseudoTerminal noisy([&](std::string& received) {
    received.clear();
    return std::string(++attempts == 1 ? "\xff\x80noise\r" : "SSC32-V2.01\r");
  });
  Ssc32Driver connecting(calibration(), noisy.port());
  EXPECT_NO_THROW(connecting.connect());
  EXPECT_THAT(connecting.description(), HasSubstr("version SSC32-V2.01"));
}

TEST_F(Ssc32DriverTest, DoesNotKnowWhereServosAreThatAreOff) {
  driver.connect();
  EXPECT_EQ(driver.present_position(), std::nullopt);
  script.pulses(100);
  script.pulse(3, 0);
  EXPECT_EQ(driver.present_position(), std::nullopt);
  script.pulse(3, 120);
  const auto pose = driver.present_position();
  ASSERT_TRUE(pose);
  EXPECT_EQ((*pose)[0], 10);
  EXPECT_DOUBLE_EQ((*pose)[3], 10 + 200 / 33.3);
}

TEST_F(Ssc32DriverTest, StartsOnlyServosThatAreOffAndAtTheStartItself) {
  driver.connect();
  script.pulses(100);
  script.pulse(2, 0);
  script.pulse(5, 0);
  sent();
  driver.enable(standing_pose());
  EXPECT_THAT(sent(), testing::EndsWith("#2P1000#5P1000\r"));
}

TEST_F(Ssc32DriverTest, LeavesServosThatAreOnWhereTheyAre) {
  driver.connect();
  script.pulses(100);
  sent();
  driver.enable(standing_pose());
  EXPECT_THAT(sent(), testing::Not(HasSubstr("#")));
}

TEST_F(Ssc32DriverTest, MovesAllServosInOneCommand) {
  driver.connect();
  driver.enable(standing_pose());
  sent();
  Pose pose = standing_pose();
  pose[0] = 11;
  pose[7] = 1000;
  driver.move(pose, milliseconds(20));
  EXPECT_EQ(sent(), "#0P1033#1P1000#2P1000#3P1000#4P1000#5P1000#6P1000#7P2000T20\r");
}

TEST_F(Ssc32DriverTest, TellsExactlyWhatWasAskedForWhereAServoHasReachedItsPulse) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = 11;  // 1033 µs
  pose[1] = 14;  // 1133 µs
  pose[2] = 99;  // beyond the range: 2000 µs
  driver.move(pose, milliseconds(20));
  script.pulses(100);
  script.pulse(0, 103);
  script.pulse(1, 110);  // on its way
  script.pulse(2, 200);
  const Feedback feedback = driver.read();
  EXPECT_FALSE(feedback.measured);
  EXPECT_EQ(feedback.position[0], 11);
  EXPECT_DOUBLE_EQ(feedback.position[1], 10 + 100 / 33.3);
  EXPECT_DOUBLE_EQ(feedback.position[2], 10 + 1000 / 33.3);
  EXPECT_EQ(feedback.position[3], 10);
}

TEST_F(Ssc32DriverTest, TellsServosThatHaveArrivedFromThoseOnTheirWay) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[1] = 20;
  driver.move(pose, milliseconds(20));
  script.pulses(100);
  script.movement("+");
  EXPECT_FALSE(driver.read().arrived);
  EXPECT_TRUE(driver.moving());
  script.pulse(1, 133);
  script.movement(".");
  EXPECT_TRUE(driver.read().arrived);
  EXPECT_FALSE(driver.moving());
  script.movement("x");
  EXPECT_EQ(kind_of_error([&] { driver.moving(); }), Kind::garbled);
}

TEST_F(Ssc32DriverTest, ReadsFeetFromInputsAndElseFromPositions) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[science::robots::vertical_servo(science::robots::front_right)] = 20;
  driver.move(pose, milliseconds(20));
  script.pulses(100);
  script.pulse(1, 133);
  script.inputs("10");  // A is open, C is closed
  EXPECT_EQ(driver.read().feet_down, 0b1100U);
  script.inputs("01");
  EXPECT_EQ(driver.read().feet_down, 0b0101U);
}

TEST_F(Ssc32DriverTest, HoldsAndReleasesEachServo) {
  driver.connect();
  driver.enable(standing_pose());
  sent();
  driver.hold();
  EXPECT_EQ(sent(), "STOP0\rSTOP1\rSTOP2\rSTOP3\rSTOP4\rSTOP5\rSTOP6\rSTOP7\r");
  driver.release();
  EXPECT_EQ(sent(), release_);
}

TEST_F(Ssc32DriverTest, MakesSureThatServosAreReleased) {
  driver.connect();
  driver.enable(standing_pose());
  script.pulse(6, 100);
  EXPECT_EQ(kind_of_error([&] { driver.release(); }), Kind::refused);
  EXPECT_EQ(message, "back left horizontal (channel 6) keeps its pulses");
}

TEST_F(Ssc32DriverTest, LetsGoWithoutAnAnswer) {
  driver.connect();
  driver.enable(standing_pose());
  script.silent(true);
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::silent);
  EXPECT_TRUE(driver.let_go());
  script.silent(false);
  driver.connect();
  EXPECT_THAT(terminal.received(), HasSubstr(release_ + "\x1bVER\r"));
  terminal.unplug();
  EXPECT_FALSE(driver.let_go());
}

TEST_F(Ssc32DriverTest, KnowsAfterAHoldOnlyWhatTheDeviceTells) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = 11;
  driver.move(pose, milliseconds(20));
  driver.hold();
  script.pulses(100);
  script.pulse(0, 103);
  EXPECT_DOUBLE_EQ(driver.read().position[0], 10 + 30 / 33.3);
}

TEST_F(Ssc32DriverTest, RefusesToMoveServosThatWereNotEnabled) {
  driver.connect();
  EXPECT_EQ(kind_of_error([&] { driver.move(standing_pose(), milliseconds(20)); }), Kind::refused);
  driver.connect();
  driver.enable(standing_pose());
  driver.release();
  EXPECT_EQ(kind_of_error([&] { driver.move(standing_pose(), milliseconds(20)); }), Kind::refused);
  EXPECT_THAT(terminal.received(), testing::Not(HasSubstr("T20")));
}

TEST_F(Ssc32DriverTest, SendsNothingOfAMoveToWhatIsNoPosition) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[6] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kind_of_error([&] { driver.move(pose, milliseconds(20)); }), Kind::refused);
  driver.connect();
  EXPECT_THAT(sent(), testing::Not(HasSubstr("T20")));
}

TEST_F(Ssc32DriverTest, NoticesThatTheControllerWasReset) {
  driver.connect();
  driver.enable(standing_pose());
  script.pulses(100);
  driver.read();
  script.pulse(4, 0);
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::refused);
  EXPECT_THAT(message, HasSubstr("back left vertical (channel 4) has no pulses any more"));
}

TEST_F(Ssc32DriverTest, TellsNoiseFromAnAnswer) {
  const std::string good(8, 'd');  // 100
  std::string bad_pulse = good;
  bad_pulse[6] = 3;
  for (const auto& [pulses, inputs] : {std::pair(bad_pulse, "10"), std::pair(good, "1x"), std::pair(good, "1")}) {
    driver.connect();
    script.pulses(pulses);
    script.inputs(inputs);
    EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::garbled) << inputs;
  }
}

TEST_F(Ssc32DriverTest, TellsNoiseThatLooksLikePulsesByWhereTheServosCanBe) {
  driver.connect();
  driver.enable(standing_pose());
  Pose pose = standing_pose();
  pose[3] = 11;  // 1033 µs
  driver.move(pose, milliseconds(20));
  script.pulses(100);
  EXPECT_NO_THROW(driver.read());
  script.pulse(3, 103);
  EXPECT_NO_THROW(driver.read());
  script.pulse(3, 100);
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::garbled) << "it does not go back by itself";
  EXPECT_THAT(message, HasSubstr("front right horizontal (channel 3) can't be at 1000 µs, between 1030 and 1033 µs"));
}

TEST(Ssc32Driver, BelievesAPositionOnlyWhenItIsToldTwice) {
  int questions = 0;
  PseudoTerminal noisy([&](std::string& received) {
    if (received.find('\r') == std::string::npos) return std::string();
    const bool version = received.find("VER") != std::string::npos;
    received.clear();
    if (version) return std::string("SSC32-V2.50USB\r");
    return ++questions == 1 ? std::string("ddddxddd") : std::string("dddddddd");
  });
  Ssc32Driver driver(calibration(), noisy.port());
  driver.connect();
  EXPECT_THROW(driver.present_position(), DriverError);
  driver.connect();
  EXPECT_EQ(driver.present_position(), standing_pose());
}

TEST_F(Ssc32DriverTest, ForgetsNoiseThatCameBeforeTheQuestion) {
  driver.connect();
  script.pulses(100);
  driver.present_position();
  terminal.send("noise");
  std::this_thread::sleep_for(milliseconds(50));
  EXPECT_NO_THROW(driver.read());
}

TEST_F(Ssc32DriverTest, EndsASilenceByItselfAndIsToBeConnectedAnew) {
  driver.connect();
  driver.enable(standing_pose());
  script.silent(true);
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::silent);
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::disconnected);
  EXPECT_EQ(kind_of_error([&] { driver.connect(); }), Kind::silent);
  script.silent(false);
  EXPECT_NO_THROW(driver.connect());
  EXPECT_EQ(kind_of_error([&] { driver.move(standing_pose(), milliseconds(20)); }), Kind::refused)
      << "servos are to be enabled anew, too";
}

TEST_F(Ssc32DriverTest, NoticesThePlug) {
  driver.connect();
  terminal.unplug();
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::disconnected);
  EXPECT_EQ(kind_of_error([&] { driver.connect(); }), Kind::disconnected);
}

TEST_F(Ssc32DriverTest, IsCancelledFromAnotherThread) {
  driver.connect();
  script.silent(true);
  std::atomic<bool> ended = false;
  std::thread other([&] {
    while (!ended) {
      driver.cancel();
      std::this_thread::yield();
    }
  });
  EXPECT_EQ(kind_of_error([&] { driver.read(); }), Kind::cancelled);
  ended = true;
  other.join();
}

TEST(Ssc32Driver, SaysWhichRateItsLineAllows) {
  Calibration slow = calibration();
  slow.baud = 9600;
  const Ssc32Driver driver(slow, "/dev/ttyUSB0");
  EXPECT_NEAR(driver.highest_rate(), 9.25, 0.01);
  EXPECT_THAT(driver.description(), HasSubstr("at most 9.2 steps per second (50 take 115200 baud)"));
  slow.baud = 38400;
  EXPECT_NEAR(Ssc32Driver(slow, "").highest_rate(), 32.49, 0.01);
  slow.baud = 115200;
  EXPECT_EQ(Ssc32Driver(slow, "").highest_rate(), 50);
}

TEST(Ssc32Driver, AllowsFiftyStepsWithTheHighestChannelsAndAllInputs) {
  Calibration wide = calibration();
  for (std::size_t servo = 0; servo < servos; ++servo) wide.joints[servo].channel = 24 + static_cast<int>(servo);
  for (std::size_t leg = 0; leg < wide.feet.size(); ++leg) wide.feet[leg] = FootContact{static_cast<int>(leg), true};
  EXPECT_EQ(Ssc32Driver(wide, "").highest_rate(), 50);
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers
