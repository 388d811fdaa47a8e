#include "robot_bridge/drivers/mock_driver.hpp"

#include <gtest/gtest.h>
#include <thread>

namespace lamprey::robot_bridge::drivers {
namespace {

using Kind = DriverError::Kind;
using std::chrono::milliseconds;

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

TEST(MockDriver, StandsAndMovesAtOnce) {
  MockDriver mock(mock_calibration());
  mock.connect();
  EXPECT_EQ(mock.present_position(), standing_pose());
  mock.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = 12;
  pose[7] = 30;
  mock.move(pose, milliseconds(20));
  EXPECT_EQ(mock.read(), (Feedback{.position = pose, .measured = true, .feet_down = 0b1110}));
  EXPECT_EQ(mock.moves(), 1U);
}

TEST(MockDriver, StaysWithinTheRobotsRange) {
  MockDriver mock(mock_calibration());
  mock.connect();
  mock.enable(standing_pose());
  Pose pose = standing_pose();
  pose[0] = -5;
  pose[1] = 31;
  mock.move(pose, milliseconds(20));
  EXPECT_EQ(mock.position()[0], lowest_position);
  EXPECT_EQ(mock.position()[1], highest_position);
}

TEST(MockDriver, MovesNothingBeforeItIsConnectedAndEnabled) {
  MockDriver mock(mock_calibration());
  EXPECT_EQ(kind_of_error([&] { mock.read(); }), Kind::disconnected);
  mock.connect();
  EXPECT_EQ(kind_of_error([&] { mock.move(standing_pose(), milliseconds(20)); }), Kind::refused);
  EXPECT_FALSE(mock.is_connected()) << "an error ends the connection";
  mock.connect();
  mock.enable(standing_pose());
  mock.release();
  EXPECT_FALSE(mock.is_enabled());
  EXPECT_EQ(kind_of_error([&] { mock.move(standing_pose(), milliseconds(20)); }), Kind::refused);
}

TEST(MockDriver, FailsAsItIsToldForAsManyCalls) {
  for (const Kind kind : {Kind::silent, Kind::garbled, Kind::refused, Kind::disconnected}) {
    MockDriver mock(mock_calibration());
    mock.connect();
    mock.inject({.error = kind, .calls = 2});
    EXPECT_EQ(kind_of_error([&] { mock.read(); }), kind);
    EXPECT_EQ(kind_of_error([&] { mock.connect(); }), kind);
    mock.connect();
    EXPECT_NO_THROW(mock.read());
  }
}

TEST(MockDriver, FailsUntilTheFaultIsTakenAway) {
  MockDriver mock(mock_calibration());
  mock.inject({.error = Kind::disconnected, .calls = -1});
  for (int i = 0; i < 5; ++i) EXPECT_EQ(kind_of_error([&] { mock.connect(); }), Kind::disconnected);
  mock.inject({.calls = 0});
  EXPECT_NO_THROW(mock.connect());
}

TEST(MockDriver, EndsADelayThatIsCancelledFromAnotherThread) {
  MockDriver mock(mock_calibration());
  mock.connect();
  mock.inject({.delay = std::chrono::minutes(10)});
  std::thread other([&] {
    while (mock.is_connected()) mock.cancel();
  });
  EXPECT_EQ(kind_of_error([&] { mock.read(); }), Kind::cancelled);
  other.join();
}

TEST(MockDriver, IsPutSomewhereByHand) {
  MockDriver mock(mock_calibration());
  Pose pose = standing_pose();
  pose[3] = 17.5;
  mock.put(pose);
  mock.connect();
  EXPECT_EQ(mock.present_position(), pose);
}

}  // namespace
}  // namespace lamprey::robot_bridge::drivers
