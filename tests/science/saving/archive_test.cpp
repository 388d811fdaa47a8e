#include "science/saving/archive.hpp"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace lamprey::science::saving {
namespace {

struct Everything {
  std::int16_t small = 0;
  std::uint32_t count = 0;
  std::int64_t wide = 0;
  bool yes = false;
  double real = 0;
  std::array<std::int32_t, 2> list{};
  std::vector<double> reals;

  bool operator==(const Everything&) const = default;
};

void fields(auto& archive, Of<Everything> auto& state) {
  archive.whole("small", state.small, -1, 400);
  archive.whole("count", state.count, 0, 0xFFFFFFFF);
  archive.whole("wide", state.wide, std::numeric_limits<std::int64_t>::min(), 0);
  archive.flag("yes", state.yes);
  archive.real("real", state.real);
  wholes(archive, "list", state.list, -5, 5);
  counted_reals(archive, "reals", state.reals, 3, 0, 10);
}

const Everything example{
    .small = -1, .count = 0x01020304, .wide = -2, .yes = true, .real = -0.0, .list = {5, -5}, .reals = {1, 2.5}};

std::vector<std::uint8_t> written(const Everything& state) {
  Writer writer;
  fields(writer, state);
  return std::move(writer).take();
}

std::string refusal(const std::vector<std::uint8_t>& octets) {
  try {
    Reader reader(octets);
    Everything state;
    fields(reader, state);
    reader.end();
  } catch (const Invalid& error) {
    return error.what();
  }
  return {};
}

TEST(Archive, WritesLittleEndianNumbersOfTheirOwnWidthWithoutPadding) {
  const std::vector<std::uint8_t> expected{
      0xFF, 0xFF,                                      // small
      4,    3,    2,    1,                             // count
      0xFE, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF,  // wide
      1,                                               // yes
      0,    0,    0,    0,    0,    0,    0,    0x80,  // real
      5,    0,    0,    0,    0xFB, 0xFF, 0xFF, 0xFF,  // list
      2,    0,    0,    0,                             // how many reals
      0,    0,    0,    0,    0,    0,    0xF0, 0x3F,  // 1
      0,    0,    0,    0,    0,    0,    4,    0x40,  // 2.5
  };
  EXPECT_EQ(written(example), expected);
}

TEST(Archive, WhatWasWrittenIsReadToTheBit) {
  const auto octets = written(example);
  Reader reader(octets);
  Everything read;
  fields(reader, read);
  EXPECT_NO_THROW(reader.end());
  EXPECT_EQ(read, example);
  EXPECT_TRUE(std::signbit(read.real));
}

TEST(Archive, OctetsThatAreTooFewOrTooManyAreRefused) {
  const auto octets = written(example);
  for (std::size_t length = 0; length < octets.size(); ++length) {
    EXPECT_TRUE(refusal({octets.begin(), octets.begin() + static_cast<std::ptrdiff_t>(length)}).starts_with("it ends"))
        << length;
  }
  auto longer = octets;
  longer.push_back(0);
  EXPECT_EQ(refusal(longer), "1 octets too many");
}

TEST(Archive, ValuesOutOfTheirRangeAreRefusedByName) {
  auto wrong = example;
  wrong.small = 401;
  EXPECT_EQ(refusal(written(wrong)), "small is 401, but must be -1..400");
  wrong = example;
  wrong.list[1] = -6;
  EXPECT_EQ(refusal(written(wrong)), "list is -6, but must be -5..5");
  wrong = example;
  wrong.real = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal(written(wrong)), "real is not a finite number");
  wrong = example;
  wrong.reals = {0, 0, 0, 0};
  EXPECT_EQ(refusal(written(wrong)), "reals is 4, but must be 0..3");
  wrong.reals = {0, 11};
  EXPECT_EQ(refusal(written(wrong)), "reals is 11, but must be 0..10");
  auto octets = written(example);
  octets[14] = 2;
  EXPECT_EQ(refusal(octets), "yes is 2, but must be 0..1");
}

TEST(Archive, ARealIsHeldToItsRangeWhenItIsRead) {
  Writer writer;
  real_within(writer, "temperature", 12.5, 0, 10);
  const auto octets = std::move(writer).take();
  Reader reader(octets);
  double value = 0;
  try {
    real_within(reader, "temperature", value, 0, 10);
    FAIL();
  } catch (const Invalid& error) {
    EXPECT_STREQ(error.what(), "temperature is 12.5, but must be 0..10");
  }
}

}  // namespace
}  // namespace lamprey::science::saving
