#include "robot_bridge/calibration.hpp"

#include "experiment/problem.hpp"
#include "science/problems/controlled_quadruped.hpp"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace lamprey::robot_bridge {
namespace {

using testing::HasSubstr;

const std::string good_joints =
    R"(joints:
  front left vertical: {channel: 0, minimum: 600, centre: 1000, maximum: 2400, per_unit: 50, direction: 1, offset: 0, slew_rate: 5000}
  front right vertical: {channel: 1, minimum: 600, centre: 2000, maximum: 2400, per_unit: 50, direction: -1, offset: -12.5, slew_rate: 5000}
  front left horizontal: {channel: 2, minimum: 600, centre: 1000, maximum: 2400, per_unit: 33.3, slew_rate: 5000}
  front right horizontal: {channel: 3, minimum: 600, centre: 1000, maximum: 2400, per_unit: 50, slew_rate: 5000}
  back left vertical: {channel: 4, minimum: 600, centre: 1000, maximum: 2400, per_unit: 50, slew_rate: 5000}
  back right vertical: {channel: 5, minimum: 600, centre: 1000, maximum: 2400, per_unit: 50, slew_rate: 5000}
  back left horizontal: {channel: 6, minimum: 600, centre: 1000, maximum: 2400, per_unit: 50, slew_rate: 5000}
  back right horizontal: {channel: 31, minimum: 600, centre: 1000, maximum: 2400, per_unit: 50, slew_rate: 5000}
)";
const std::string good = "driver: ssc32\nbaud: 115200\n" + good_joints;

/// All that is said about a wrong file.
std::string refusal(const std::string& yaml) {
  try {
    parse_calibration(yaml, "robot.yaml");
  } catch (const experiment::InvalidInput& error) {
    return error.what();
  }
  return "no refusal";
}

/// The good file with one text instead of another.
std::string with(const std::string& from, const std::string& to, std::string yaml = good) {
  const auto place = yaml.find(from);
  EXPECT_NE(place, std::string::npos) << from;
  return yaml.replace(place, from.size(), to);
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

TEST(Calibration, IsReadWithItsDefaults) {
  const Calibration calibration = parse_calibration(good, "robot.yaml");
  EXPECT_EQ(calibration.family, DeviceFamily::ssc32);
  EXPECT_EQ(calibration.baud, 115200);
  EXPECT_EQ(calibration.joints[1], (Joint{.channel = 1,
                                          .minimum = 600,
                                          .centre = 2000,
                                          .maximum = 2400,
                                          .per_unit = 50,
                                          .direction = -1,
                                          .offset = -12.5,
                                          .slew_rate = 5000}));
  EXPECT_EQ(calibration.joints[2].direction, 1);
  EXPECT_EQ(calibration.joints[2].offset, 0);
  EXPECT_EQ(calibration.joints[7].channel, 31);
  EXPECT_EQ(slew_in_units(calibration.joints[0]), 100);
  for (const auto& foot : calibration.feet) EXPECT_FALSE(foot);
}

TEST(Calibration, NamesServosInTheRobotsOrder) {
  const auto names = science::problems::servo_names();
  for (std::size_t servo = 0; servo < servos; ++servo) {
    const std::string line = "  " + names[servo] + ": {channel: " + std::to_string(servo);
    if (servo + 1 < servos) {
      EXPECT_THAT(good, HasSubstr(line));
    }
  }
}

TEST(Calibration, ReadsFeetAndTheContactBoard) {
  const auto ssc32 = parse_calibration(
      good + "feet:\n  front left: {input: A, closed: low}\n  back right: {input: F, closed: high}\n", "robot.yaml");
  EXPECT_EQ(ssc32.feet[science::robots::front_left], (FootContact{.channel = 0, .closed_is_low = true}));
  EXPECT_EQ(ssc32.feet[science::robots::back_right], (FootContact{.channel = 5, .closed_is_low = false}));
  const auto dynamixel =
      parse_calibration("driver: dynamixel\nbaud: 1000000\n" + good_joints +
                            "feet:\n  front right: {bit: 7}\ncontact_board: {id: 200, address: 10}\n",
                        "robot.yaml");
  EXPECT_EQ(dynamixel.feet[science::robots::front_right], (FootContact{.channel = 7, .closed_is_low = true}));
  EXPECT_EQ(dynamixel.contact_board, (ContactBoard{.id = 200, .address = 10}));
}

TEST(Calibration, IsWrittenAsItWasRead) {
  const std::vector<std::string> files = {
      good,
      "driver: mock\n",
      good + "feet:\n  front left: {input: A, closed: low}\n  back right: {input: F, closed: high}\n",
      "driver: dynamixel\nbaud: 57600\n" + good_joints +
          "feet:\n  front left: {bit: 0, closed: high}\ncontact_board: {id: 200, address: 10}\n",
      with("per_unit: 33.3", "per_unit: 0.1234567890123456789"),
      with("offset: 0", "offset: 1e-300")};
  for (const auto& file : files) {
    const auto calibration = parse_calibration(file, "robot.yaml");
    EXPECT_EQ(parse_calibration(to_yaml(calibration), "written.yaml"), calibration) << to_yaml(calibration);
  }
}

TEST(Calibration, OfTheMockNeedsNoMoreThanItsName) {
  const auto mock = parse_calibration("driver: mock\n", "mock.yaml");
  EXPECT_EQ(mock, mock_calibration());
  for (const auto& joint : mock.joints) {
    EXPECT_EQ(joint.to_device(0), 0);
    EXPECT_EQ(joint.to_device(30), 30);
    EXPECT_EQ(joint.to_units(12.5), 12.5);
    EXPECT_EQ(slew_in_units(joint), 30'000);
  }
}

struct WrongCalibration {
  const char* name;
  std::string yaml;
  std::string messages;
};

void PrintTo(const WrongCalibration& wrong, std::ostream* stream) {
  *stream << wrong.name;
}

class WrongCalibrations : public testing::TestWithParam<WrongCalibration> {};

TEST_P(WrongCalibrations, AreRefusedWithEveryProblemInPlace) {
  EXPECT_EQ(refusal(GetParam().yaml), GetParam().messages);
}

const std::vector<WrongCalibration>& wrong_calibrations() {
  static const std::vector<WrongCalibration> cases = {
      {"NoMapping", "- 1\n",
       "robot.yaml:1:1: a calibration is a mapping of driver, baud, joints and so on; this is a list"},
      {"NoDriver", "baud: 9600\n", "robot.yaml:1:1: driver: is missing; it takes one of mock, ssc32, dynamixel"},
      {"UnknownDriver", "driver: ssc23\n",
       "robot.yaml:1:9: driver: 'ssc23' is not allowed; it takes one of mock, ssc32, dynamixel; did you mean 'ssc32'?"},
      {"NothingElse", "driver: ssc32\n",
       "robot.yaml:1:1: baud: is missing; it takes one of 9600, 38400, 115200\n"
       "robot.yaml:1:1: joints: is missing; it takes all eight joints"},
      {"Baud", with("115200", "115201"),
       "robot.yaml:2:7: baud: '115201' is not allowed; it takes one of 9600, 38400, 115200"},
      {"UnknownField", good + "fete: {}\n", "robot.yaml:12:1: fete: unknown field 'fete'; did you mean 'feet'?"},
      {"UnknownJoint", with("front left vertical", "front left vertcal"),
       "robot.yaml:4:3: joints.front left vertcal: unknown joint 'front left vertcal'; did you mean 'front left "
       "vertical'?"},
      {"MissingJoint", with("  back left vertical", "#"), "robot.yaml:4:3: joints.back left vertical: is missing"},
      {"UnknownJointField", with("channel: 4", "channel: 4, chanel: 4"),
       "robot.yaml:8:36: joints.back left vertical.chanel: unknown field 'chanel'; did you mean 'channel'?"},
      {"MissingJointFields", with("channel: 4, minimum: 600, ", ""),
       "robot.yaml:8:23: joints.back left vertical.channel: is missing\n"
       "robot.yaml:8:23: joints.back left vertical.minimum: is missing"},
      {"TakenChannel", with("channel: 4", "channel: 2"),
       "robot.yaml:8:33: joints.back left vertical.channel: channel 2 is taken: joints.front left horizontal.channel "
       "has it, in line 6"},
      {"ChannelOutOfRange", with("channel: 31", "channel: 32"),
       "robot.yaml:11:36: joints.back right horizontal.channel: '32' is not allowed; it takes a whole number from 0 to "
       "31"},
      {"PulseOutOfRange", with("minimum: 600", "minimum: 499"),
       "robot.yaml:4:46: joints.front left vertical.minimum: '499' is not allowed; it takes a whole number from 500 to "
       "2500 (µs)"},
      {"PartOfAMicrosecond", with("maximum: 2400", "maximum: 2400.5"),
       "robot.yaml:4:74: joints.front left vertical.maximum: '2400.5' is not allowed; it takes a whole number from 500 "
       "to 2500 (µs)"},
      {"StandsOutOfRange", with("offset: 0", "offset: 1400"),
       "robot.yaml:4:59: joints.front left vertical.centre: where the leg stands, centre + offset = 2400, is not "
       "between minimum and maximum, 600 and 2400"},
      {"MinimumAboveMaximum",
       with("minimum: 600, centre: 1000, maximum: 2400", "minimum: 2400, centre: 1000, maximum: 600"),
       "robot.yaml:4:60: joints.front left vertical.centre: where the leg stands, centre + offset = 1000, is not "
       "between minimum and maximum, 2400 and 600"},
      {"NoNumber", with("per_unit: 50", "per_unit: nan"),
       "robot.yaml:4:90: joints.front left vertical.per_unit: 'nan' is not allowed; it takes a number above 0, up to "
       "2000 (µs)"},
      {"NoSpeed", with("slew_rate: 5000", "slew_rate: 0"),
       "robot.yaml:4:130: joints.front left vertical.slew_rate: '0' is not allowed; it takes a number above 0, up to "
       "1000000 (µs per second)"},
      {"Direction", with("direction: 1", "direction: 2"),
       "robot.yaml:4:105: joints.front left vertical.direction: '2' is not allowed; it takes 1 or -1"},
      {"JointIsNoMapping", "driver: mock\njoints:\n  front left vertical: 3\n",
       "robot.yaml:3:3: joints.front right vertical: is missing\n"
       "robot.yaml:3:3: joints.front left horizontal: is missing\n"
       "robot.yaml:3:3: joints.front right horizontal: is missing\n"
       "robot.yaml:3:3: joints.back left vertical: is missing\n"
       "robot.yaml:3:3: joints.back right vertical: is missing\n"
       "robot.yaml:3:3: joints.back left horizontal: is missing\n"
       "robot.yaml:3:3: joints.back right horizontal: is missing\n"
       "robot.yaml:3:24: joints.front left vertical: takes a mapping of channel, minimum, centre, maximum, per_unit, "
       "direction, offset, slew_rate; this is '3'"},
      {"Feet", good + "feet:\n  front left: {input: G, closed: low}\n  front lft: {input: A}\n  back left: {bit: 1}\n",
       "robot.yaml:13:23: feet.front left.input: 'G' is not allowed; it takes one of A, B, C, D, E, F\n"
       "robot.yaml:14:3: feet.front lft: unknown foot 'front lft'; did you mean 'front left'?\n"
       "robot.yaml:15:14: feet.back left.input: is missing\n"
       "robot.yaml:15:15: feet.back left.bit: unknown field 'bit'; known are input, closed"},
      {"SharedInput", good + "feet:\n  front left: {input: B}\n  back left: {input: B}\n",
       "robot.yaml:14:14: feet.back left: has the same input as front left"},
      {"FeetOfTheMock", "driver: mock\nfeet: {}\n", "robot.yaml:2:1: feet: the mock has no inputs; leave it out"},
      {"BoardOfAnSsc32", good + "contact_board: {id: 1, address: 2}\n",
       "robot.yaml:12:1: contact_board: only a dynamixel bus has one; leave it out"},
      {"NoBoard", "driver: dynamixel\nbaud: 57600\n" + good_joints + "feet:\n  front left: {bit: 0}\n",
       "robot.yaml:13:3: contact_board: is missing; the feet's contacts are read from it"},
      {"TakenBoard", "driver: dynamixel\nbaud: 57600\n" + good_joints + "contact_board: {id: 31, address: 2}\n",
       "robot.yaml:12:21: contact_board.id: id 31 is taken: joints.back right horizontal.channel has it"},
      {"DuplicateKey", good + "baud: 9600\n", "robot.yaml:12:1: duplicate key 'baud', first used in line 2"},
  };
  return cases;
}

std::string test_name(const testing::TestParamInfo<WrongCalibration>& wrong) {
  return wrong.param.name;
}

INSTANTIATE_TEST_SUITE_P(Calibration, WrongCalibrations, testing::ValuesIn(wrong_calibrations()), test_name);

TEST(Calibration, TellsAllThatIsWrongAtOnce) {
  const std::string messages = refusal(with("channel: 0", "channel: -1", with("2000", "5000", with("115200", "1"))));
  EXPECT_THAT(messages, HasSubstr("robot.yaml:2:7: baud: '1' is not allowed"));
  EXPECT_THAT(messages, HasSubstr("robot.yaml:4:34: joints.front left vertical.channel: '-1' is not allowed"));
  EXPECT_THAT(messages, HasSubstr("robot.yaml:5:60: joints.front right vertical.centre: '5000' is not allowed"));
}

TEST(Calibration, IsReadFromAFile) {
  const auto path = std::filesystem::temp_directory_path() / ("lamprey-calibration-" + std::to_string(::getpid()));
  std::ofstream(path) << good;
  EXPECT_EQ(read_calibration(path.string()), parse_calibration(good, ""));
  std::filesystem::remove(path);
  try {
    read_calibration(path.string());
    FAIL() << "read a file that isn't there";
  } catch (const experiment::InvalidInput& error) {
    EXPECT_THAT(error.what(), HasSubstr("no such file"));
  }
}

TEST(Calibration, ExamplesOfTheDocumentationAreGood) {
  const std::string page = contents(LAMPREY_SOURCE_DIR "/docs/formats/calibration.md");
  int examples = 0;
  for (auto begin = page.find("```yaml\n"); begin != std::string::npos; begin = page.find("```yaml\n", begin)) {
    begin += std::string("```yaml\n").size();
    const std::string yaml = page.substr(begin, page.find("```", begin) - begin);
    EXPECT_NO_THROW(parse_calibration(yaml, "example.yaml")) << refusal(yaml);
    ++examples;
  }
  EXPECT_EQ(examples, 3);
}

}  // namespace
}  // namespace lamprey::robot_bridge
