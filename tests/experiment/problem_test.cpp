#include "experiment/problem.hpp"

#include <gtest/gtest.h>

namespace lamprey::experiment {
namespace {

TEST(Problem, TextHasThePartsThatAreKnown) {
  const Problem all{.field = "grids[1].steps[0]", .message = "wrong", .file = "sweeps/a.yaml", .line = 7, .column = 12};
  EXPECT_EQ(all.text(), "sweeps/a.yaml:7:12: grids[1].steps[0]: wrong");
  EXPECT_EQ((Problem{.field = "name", .message = "wrong", .file = ""}).text(), "name: wrong");
  EXPECT_EQ((Problem{.field = "", .message = "no such file", .file = "a.yaml"}).text(), "a.yaml: no such file");
  EXPECT_EQ((Problem{.field = "", .message = "wrong", .file = ""}).text(), "wrong");
}

TEST(InvalidInput, SaysAllProblemsALineEach) {
  const InvalidInput error(
      {{.field = "a", .message = "one", .file = ""}, {.field = "b", .message = "two", .file = ""}});
  EXPECT_STREQ(error.what(), "a: one\nb: two");
  EXPECT_EQ(error.problems().size(), 2U);
}

TEST(Findings, KeepEachProblemOnceAndNoneAboutWhatWasUnreadable) {
  Findings findings({{.field = "grids[1].steps", .message = "unreadable", .file = ""}});
  findings.add("grids[1].steps[0]", "follows from the first");
  findings.add("grids[1].steps", "follows from the first");
  findings.add("grids[1].steps_more", "another field");
  findings.add("grids[1].steps_more", "another field");
  EXPECT_TRUE(findings.any_within("grids[1]"));
  EXPECT_TRUE(findings.any_within("grids"));
  EXPECT_FALSE(findings.any_within("grids[10]"));
  const auto problems = findings.take();
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[1].message, "another field");
}

TEST(Findings, StopAtTheirMaximum) {
  Findings findings({});
  for (std::size_t i = 0; i < 2 * maximum_problems; ++i) findings.add("field" + std::to_string(i), "wrong");
  EXPECT_TRUE(findings.full());
  EXPECT_EQ(findings.take().size(), maximum_problems);
}

TEST(NearestName, FindsSlipsOfTheFinger) {
  const std::vector<std::string_view> known = {"gait", "steps", "mutation_size", "walk"};
  EXPECT_EQ(nearest_name("gaitt", known), "gait");
  EXPECT_EQ(nearest_name("wlak", known), "walk") << "two neighbours swapped are one slip";
  EXPECT_EQ(nearest_name("Steps", known), "steps") << "case is no difference";
  EXPECT_EQ(nearest_name("mutate_size", known), "mutation_size");
}

TEST(NearestName, IsEmptyWhereNothingIsNear) {
  const std::vector<std::string_view> known = {"gait", "steps", "all"};
  EXPECT_EQ(nearest_name("temperature", known), "");
  EXPECT_EQ(nearest_name("", known), "");
  EXPECT_EQ(nearest_name("x", known), "");
  EXPECT_EQ(nearest_name(std::string(1'000'000, 'a'), known), "");
  EXPECT_EQ(nearest_name("gait", {}), "");
}

TEST(NearestName, PrefersTheFirstOfEquallyNearNames) {
  EXPECT_EQ(nearest_name("steqs", {"steps", "stems"}), "steps");
}

TEST(FirstUnreadable, AcceptsUtf8WithTabsAndLineEnds) {
  EXPECT_EQ(first_unreadable("a\tb\r\nc"), std::string_view::npos);
  EXPECT_EQ(first_unreadable("Gr\xC3\xB6\xC3\x9F"
                             "e \xE2\x82\xAC \xF0\x9F\x90\x9F"),
            std::string_view::npos);
  EXPECT_EQ(first_unreadable(""), std::string_view::npos);
}

TEST(FirstUnreadable, FindsWhatIsNotUtf8) {
  EXPECT_EQ(first_unreadable("ab\xFF"), 2U);
  EXPECT_EQ(first_unreadable("\xC0\x80"), 0U) << "overlong";
  EXPECT_EQ(first_unreadable("\xE0\x80\x80"), 0U) << "overlong";
  EXPECT_EQ(first_unreadable("\xED\xA0\x80"), 0U) << "surrogate";
  EXPECT_EQ(first_unreadable("\xF4\x90\x80\x80"), 0U) << "beyond Unicode";
  EXPECT_EQ(first_unreadable("\xE2\x82"), 0U) << "cut off";
}

TEST(FirstUnreadable, FindsControlCharacters) {
  EXPECT_EQ(first_unreadable(std::string_view("a\0b", 3)), 1U);
  EXPECT_EQ(first_unreadable("red\x1B[31m"), 3U);
  EXPECT_EQ(first_unreadable("\x7F"), 0U);
  EXPECT_EQ(first_unreadable("a\xC2\x85"), 1U) << "C1";
}

TEST(Printable, EscapesWhatATerminalWouldActOnAndCutsLongText) {
  EXPECT_EQ(printable("walk"), "walk");
  EXPECT_EQ(printable("\x1B[31m\n\xFF"), "\\x1b[31m\\x0a\\xff");
  EXPECT_EQ(printable("Gr\xC3\xB6\xC3\x9F"
                      "e"),
            "Gr\xC3\xB6\xC3\x9F"
            "e");
  EXPECT_EQ(printable(std::string(1000, 'x')), std::string(60, 'x') + "...");
}

}  // namespace
}  // namespace lamprey::experiment
