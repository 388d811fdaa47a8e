#include "messaging/discovery/introduction.hpp"

#include <gtest/gtest.h>

namespace lamprey::messaging::discovery {
namespace {

const Introduction worker{
    .role = "worker", .host = "alpha", .process = 4711, .build = "0.1.0 (0123456789ab)", .isolation = "lab", .wire = 4};

TEST(Introduction, CanBeReadByPeopleAndByPrograms) {
  const auto text = user_data_of(worker);
  EXPECT_EQ(text, "lamprey;wire=4;role=worker;host=alpha;process=4711;isolation=lab;build=0.1.0 (0123456789ab)");
  EXPECT_EQ(introduction_in(text), worker);
}

TEST(Introduction, OfANewerProgramMayHaveMoreFields) {
  EXPECT_EQ(introduction_in(user_data_of(worker) + ";mood=good"), worker);
}

TEST(Introduction, NeverCarriesWhatWouldEndAValueOrDisturbATerminal) {
  Introduction hostile = worker;
  hostile.host = "a;role=coordinator\x1b[2J";
  hostile.build = std::string(5000, 'x');
  const auto read = introduction_in(user_data_of(hostile));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->role, "worker");
  EXPECT_EQ(read->host, "a_role=coordinator_[2J");
  EXPECT_EQ(read->build.size(), 128U);
}

TEST(Introduction, IsNotReadFromWhatIsNone) {
  for (const std::string text : {"", "enclave=/;", "lamprey", "lamprey;role", "lamprey;process=-1",
                                 "lamprey;process=1x", "lamprey;host=\x1b[2J", "lamprey;wire=99999999999"}) {
    EXPECT_FALSE(introduction_in(text)) << text;
  }
  EXPECT_FALSE(introduction_in("lamprey;host=" + std::string(200, 'x')));
  EXPECT_FALSE(introduction_in("lamprey;" + std::string(2000, ';')));
}

}  // namespace
}  // namespace lamprey::messaging::discovery
