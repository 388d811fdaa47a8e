#include "robot_bridge/claims.hpp"

#include <gtest/gtest.h>

namespace lamprey::robot_bridge {
namespace {

using namespace std::chrono_literals;

constexpr std::uint64_t anne = 7;
constexpr std::uint64_t bert = 8;
constexpr Clock::time_point start{1h};

TEST(Claims, TokensGoOnAfterTheLastThatWasEverGranted) {
  Claims claims(41, 2s);
  const auto answer = claims.claim(anne, 0, start);
  EXPECT_TRUE(answer.granted);
  EXPECT_TRUE(answer.is_new);
  EXPECT_EQ(answer.token, 42U);
  EXPECT_TRUE(claims.holds(42, start));
}

TEST(Claims, OnlyOneHolderAtATime) {
  Claims claims(0, 2s);
  const auto token = claims.claim(anne, 0, start).token;
  const auto refused = claims.claim(bert, 0, start + 1s);
  EXPECT_FALSE(refused.granted);
  EXPECT_EQ(refused.reason, "the claim is held by 0000000000000007");
  EXPECT_TRUE(claims.holds(token, start + 1s));
}

TEST(Claims, ARepeatedRequestGetsTheSameClaim) {
  Claims claims(0, 2s);
  const auto token = claims.claim(anne, 0, start).token;
  const auto again = claims.claim(anne, 0, start + 10ms);
  EXPECT_TRUE(again.granted);
  EXPECT_FALSE(again.is_new);
  EXPECT_EQ(again.token, token);
}

TEST(Claims, WhoRenewsKeepsIt) {
  Claims claims(0, 2s);
  const auto token = claims.claim(anne, 0, start).token;
  for (auto now = start; now < start + 1min; now += 1s) EXPECT_TRUE(claims.claim(anne, token, now).granted);
  EXPECT_EQ(claims.holder(start + 1min), anne);
}

TEST(Claims, WhoDoesNotLosesItToTheNextWithAHigherToken) {
  Claims claims(0, 2s);
  const auto old = claims.claim(anne, 0, start).token;
  const auto now = start + 2s;
  EXPECT_FALSE(claims.holds(old, now));
  const auto next = claims.claim(bert, 0, now);
  EXPECT_TRUE(next.granted);
  EXPECT_GT(next.token, old);
  EXPECT_FALSE(claims.holds(old, now));
  EXPECT_FALSE(claims.claim(anne, old, now).granted);
}

TEST(Claims, AnExpiredClaimIsNotRenewedButGrantedAnew) {
  Claims claims(0, 2s);
  const auto old = claims.claim(anne, 0, start).token;
  const auto renewal = claims.claim(anne, old, start + 3s);
  EXPECT_FALSE(renewal.granted);
  EXPECT_EQ(renewal.reason, "claim 1 is over");
  EXPECT_EQ(claims.claim(anne, 0, start + 3s).token, old + 1);
}

TEST(Claims, OnlyItsHolderReleasesIt) {
  Claims claims(0, 2s);
  const auto token = claims.claim(anne, 0, start).token;
  EXPECT_FALSE(claims.release(bert, token, start).granted);
  EXPECT_TRUE(claims.holds(token, start));
  EXPECT_TRUE(claims.release(anne, token, start).granted);
  EXPECT_EQ(claims.holder(start), 0U);
  EXPECT_TRUE(claims.release(anne, token, start).granted) << "a repeated request";
}

TEST(Claims, ReleasingAnOldClaimLeavesTheNewOne) {
  Claims claims(0, 2s);
  const auto old = claims.claim(anne, 0, start).token;
  const auto token = claims.claim(bert, 0, start + 2s).token;
  EXPECT_TRUE(claims.release(anne, old, start + 2s).granted);
  EXPECT_TRUE(claims.holds(token, start + 2s));
}

}  // namespace
}  // namespace lamprey::robot_bridge
