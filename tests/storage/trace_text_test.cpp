#include "storage/trace_text.hpp"

#include <bit>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace lamprey::storage {
namespace {

using experiment::AcceptedChange;

std::string written(const std::vector<AcceptedChange>& trace) {
  std::string text = "what was there before";
  write_trace(trace, text);
  return text;
}

TEST(TraceText, IsCompactJsonWithShortestNumbers) {
  EXPECT_EQ(written({}), "[]");
  EXPECT_EQ(written({{0, {80, 60.5, 0.1, 1e-7}}, {4294967295U, {-0.0, 1e300, 5e-324, 1.0 / 3}}}),
            "[[0,80,60.5,0.1,1e-07],[4294967295,-0,1e+300,5e-324,0.3333333333333333]]");
}

TEST(TraceText, ReadsBackToTheSameBitsForAnyFiniteScores) {
  std::mt19937_64 random(1);
  std::vector<AcceptedChange> trace;
  for (std::uint32_t cycle = 0; cycle < 2000; ++cycle) {
    AcceptedChange change{cycle * 3, {}};
    for (double* value : {&change.score.stability, &change.score.distance, &change.score.fuel, &change.score.total}) {
      do {
        *value = std::bit_cast<double>(random());
      } while (!std::isfinite(*value));
    }
    trace.push_back(change);
  }
  const auto read = read_trace(written(trace));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, trace);
  EXPECT_EQ(written(*read), written(trace));
}

TEST(TraceText, OtherTextIsRefused) {
  for (const auto* text : {"",
                           "[",
                           "]",
                           "[]]",
                           "[],",
                           " []",
                           "[] ",
                           "[[]]",
                           "[[1,2,3,4]]",
                           "[[1,2,3,4,5,6]]",
                           "[[1,2,3,4,5]",
                           "[[1,2,3,4,5],]",
                           "[[1,2,3,4,5][1,2,3,4,5]]",
                           "[[-1,2,3,4,5]]",
                           "[[1.5,2,3,4,5]]",
                           "[[4294967296,2,3,4,5]]",
                           "[[1, 2,3,4,5]]",
                           "[[1,2,3,4,nan]]",
                           "[[1,2,3,4,inf]]",
                           "[[1,2,3,4,1e999]]",
                           "[[1,2,3,4,+5]]",
                           "[[1,2,3,4,5]]\n"}) {
    EXPECT_FALSE(read_trace(text)) << text;
  }
}

TEST(TraceText, OtherSpellingsOfANumberAreFoundByWritingAgain) {
  for (const auto* text :
       {"[[01,2,3,4,5]]", "[[1,2.0,3,4,5]]", "[[1,2,30e-1,4,5]]", "[[1,2,3,4,0.10000000000000001]]"}) {
    const auto read = read_trace(text);
    ASSERT_TRUE(read) << text;
    EXPECT_NE(written(*read), text);
  }
}

std::string written_measures(const std::vector<experiment::Measure>& measures) {
  std::string text = "what was there before";
  write_measures(measures, text);
  return text;
}

TEST(MeasureText, IsCompactJsonThatReadsBackToTheSameBits) {
  const std::vector<experiment::Measure> measures = {
      {"parameter_variation", 4294967295U, 1.0 / 3}, {"recovered", 0, 1}, {"x", 7, -2.2250738585072014e-308}};
  const auto text = written_measures(measures);
  EXPECT_EQ(text, R"([["parameter_variation",4294967295,0.3333333333333333],["recovered",0,1],)"
                  R"(["x",7,-2.2250738585072014e-308]])");
  EXPECT_EQ(read_measures(text), measures);
  EXPECT_EQ(written_measures({}), "[]");
  EXPECT_EQ(read_measures("[]"), std::vector<experiment::Measure>{});
}

TEST(MeasureText, OtherTextIsRefused) {
  for (const auto* text :
       {"", "[", "]", "[[]]", R"([["a",1]])", R"([["a",1,2,3]])", R"([[a,1,2]])", R"([["a,1,2]])", R"([["a" ,1,2]])",
        R"([["a",-1,2]])", R"([["a",1.5,2]])", R"([["a",4294967296,2]])", R"([["a",1,nan]])", R"([["a",1,1e999]])",
        R"([["a",1,2],])", R"([["a",1,2]["b",1,2]])", R"([["a",1,2]] )", R"([["a",1,"2"]])"}) {
    EXPECT_FALSE(read_measures(text)) << text;
  }
}

TEST(MeasureText, OtherSpellingsOfANumberAreFoundByWritingAgain) {
  for (const auto* text : {R"([["a",01,2]])", R"([["a",1,2.0]])", R"([["a",1,20e-1]])"}) {
    const auto read = read_measures(text);
    ASSERT_TRUE(read) << text;
    EXPECT_NE(written_measures(*read), text);
  }
}

}  // namespace
}  // namespace lamprey::storage
