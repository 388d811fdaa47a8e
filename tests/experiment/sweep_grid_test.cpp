#include "experiment/sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <set>
#include <stdexcept>

namespace lamprey::experiment {
namespace {

using testing::ElementsAre;

idl::SweepSpecification sweep(const std::string& yaml) {
  return parse_sweep(yaml, "sweep.yaml").specification;
}

std::vector<std::string> axis_texts(const std::string& axis) {
  const SweepGrid grid(sweep("name: a\nbase: {acceptance: annealing}\ngrids: [{" + axis + "}]\n"));
  std::vector<std::string> texts;
  for (const auto& value : grid.grids().at(0).axes.at(0).values) texts.push_back(to_text(value));
  return texts;
}

TEST(SweepGrid, CountsWithTheLastAxisFastestGridByGridAndReplicateByReplicate) {
  const SweepGrid grid(sweep(R"(
name: order
seed: 7
base: {cycles: 10}
grids:
  - {mutation: [all, one], equilibrium_disturbance: [25, 50, 75]}
  - {mutation: some}
replicates: 2
)"));
  EXPECT_EQ(grid.cells(), 7U);
  EXPECT_EQ(grid.replicates(), 2U);
  ASSERT_EQ(grid.jobs(), 14U);
  const auto text = [&](std::uint64_t number) {
    const Job job = grid.job(number);
    EXPECT_EQ(job.number, number);
    EXPECT_EQ(job.seed, 7U);
    EXPECT_EQ(job.parameters.integer("cycles"), 10);
    return job.parameters.choice("mutation") + " " + std::to_string(job.parameters.integer("equilibrium_disturbance")) +
           " " + std::to_string(job.replicate);
  };
  EXPECT_EQ(text(0), "all 25 0");
  EXPECT_EQ(text(1), "all 50 0");
  EXPECT_EQ(text(2), "all 75 0");
  EXPECT_EQ(text(3), "one 25 0");
  EXPECT_EQ(text(5), "one 75 0");
  EXPECT_EQ(text(6), "some 50 0") << "the second grid has its own axes only; the rest is base and defaults";
  EXPECT_EQ(text(7), "all 25 1");
  EXPECT_EQ(text(13), "some 50 1");
}

TEST(SweepGrid, HasNoJobBeyondItsLast) {
  const SweepGrid grid(sweep("name: a\nreplicates: 3\n"));
  EXPECT_EQ(grid.job(2).replicate, 2U);
  EXPECT_THROW(grid.job(3), std::out_of_range);
  EXPECT_THROW(grid.job(~std::uint64_t{0}), std::out_of_range);
}

TEST(SweepGrid, WithoutGridsHasOneJobPerReplicate) {
  EXPECT_EQ(SweepGrid(sweep("name: a\n")).jobs(), 1U);
  EXPECT_EQ(SweepGrid(sweep("name: a\nbase: {cycles: 5}\nreplicates: 4\n")).jobs(), 4U);
}

TEST(SweepGrid, NumbersOfTheFirstReplicateStayWhenReplicatesOrAGridAreAdded) {
  const std::string first = "name: a\ngrids:\n  - {mutation: [all, one], cycles: [10, 20]}\n";
  const SweepGrid before(sweep(first));
  const SweepGrid replicated(sweep(first + "replicates: 5\n"));
  const SweepGrid extended(sweep(first + "  - {mutation: [some], cycles: [10, 20]}\n"));
  EXPECT_EQ(replicated.jobs(), 20U);
  EXPECT_EQ(extended.jobs(), 6U);
  for (std::uint64_t number = 0; number < before.jobs(); ++number) {
    EXPECT_EQ(identity(replicated.job(number)), identity(before.job(number)));
    EXPECT_EQ(identity(extended.job(number)), identity(before.job(number)));
  }
}

TEST(SweepGrid, RefusesWhatIsNotValid) {
  EXPECT_THROW(SweepGrid{idl::SweepSpecification{}}, InvalidInput);
}

TEST(Ranges, GoUpToAndIncludingTheirEnd) {
  EXPECT_THAT(axis_texts("mutation_size: {from: 25, to: 100, step: 25}"), ElementsAre("25", "50", "75", "100"));
  EXPECT_THAT(axis_texts("mutation_size: {from: 0, to: 10, step: 4}"), ElementsAre("0", "4", "8"));
  EXPECT_THAT(axis_texts("mutation_size: {from: 7, to: 7, step: 1}"), ElementsAre("7"));
  EXPECT_THAT(axis_texts("mutation_size: {from: 7, to: 9, step: 9223372036854775807}"), ElementsAre("7"));
}

TEST(Ranges, OfRealNumbersHaveTheValuesThatOneWouldWrite) {
  EXPECT_THAT(axis_texts("cooling: {from: 0.5, to: 1, step: 0.1}"),
              ElementsAre("0.5", "0.6", "0.7", "0.8", "0.9", "1"));
  EXPECT_THAT(axis_texts("temperature: {from: 0.1, to: 0.7, step: 0.2}"), ElementsAre("0.1", "0.3", "0.5", "0.7"));
  EXPECT_THAT(axis_texts("temperature: {from: 1, to: 2, step: 0.3}"), ElementsAre("1", "1.3", "1.6", "1.9"));
  EXPECT_THAT(axis_texts("temperature: {from: 1, to: 1000000000, step: 1e308}"), ElementsAre("1"));
}

TEST(Ranges, OfRealNumbersHaveTheSameIdentitiesAsTheList) {
  const std::string start = "name: a\nbase: {acceptance: annealing}\ngrids:\n  - temperature: ";
  const SweepGrid range(sweep(start + "{from: 0.1, to: 1, step: 0.1}\n"));
  const SweepGrid list(sweep(start + "[0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1]\n"));
  ASSERT_EQ(range.jobs(), list.jobs());
  for (std::uint64_t number = 0; number < list.jobs(); ++number) {
    EXPECT_EQ(identity(range.job(number)), identity(list.job(number))) << number;
  }
}

TEST(SweepId, IsTheSameForTheSameSweepHoweverItIsWritten) {
  const auto id = sweep_id(sweep("name: a\nbase: {gait: walk, cycles: 10}\ngrids: [{mutation: [all]}]\n"));
  EXPECT_EQ(id, sweep_id(sweep("name: a\nbase: {cycles: 10, gait: walk}\ngrids: [{mutation: all}]\n")));
  EXPECT_EQ(id, sweep_id(sweep("# note\nreplicates: 1\nseed: 1\ngrids:\n  - mutation:\n      - \"all\"\n"
                               "base: {cycles: 10, gait: walk}\nname: 'a'\ndescription: said later\n")));
}

TEST(SweepId, DiffersWithEverythingElse) {
  std::set<Id128> ids;
  const auto is_new = [&](const std::string& yaml) { return ids.insert(sweep_id(sweep(yaml))).second; };
  EXPECT_TRUE(is_new("name: a\n"));
  EXPECT_TRUE(is_new("name: b\n"));
  EXPECT_TRUE(is_new("name: a\nseed: 2\n"));
  EXPECT_TRUE(is_new("name: a\nreplicates: 2\n"));
  EXPECT_TRUE(is_new("name: a\nbase: {cycles: 1000}\n"));
  EXPECT_TRUE(is_new("name: a\nbase: {cycles: 1001}\n"));
  EXPECT_TRUE(is_new("name: a\ngrids: [{cycles: 1001}]\n"));
  EXPECT_TRUE(is_new("name: a\ngrids: [{cycles: [1001, 1002]}]\n"));
  EXPECT_TRUE(is_new("name: a\ngrids: [{cycles: [1002, 1001]}]\n"));
  EXPECT_TRUE(is_new("name: a\ngrids: [{cycles: {from: 1001, to: 1002, step: 1}}]\n"));
  EXPECT_TRUE(is_new("name: a\ngrids: [{cycles: 1001}, {cycles: 1002}]\n"));
  EXPECT_TRUE(is_new("name: a\ngrids: [{cycles: 1001, gait: walk}]\n"));
  EXPECT_TRUE(is_new("name: a\ngrids: [{gait: walk, cycles: 1001}]\n"));
}

TEST(SweepId, OfAWholeNumberForARealParameterIsThatOfTheReal) {
  auto specification = sweep("name: a\nbase: {acceptance: annealing, temperature: 2}\n");
  const Id128 id = sweep_id(specification);
  specification.mutable_base(1)->mutable_value()->set_integer(2);
  EXPECT_EQ(sweep_id(specification), id);
}

// Stored databases name sweeps by it: another value here means that running sweeps would be forgotten.
TEST(SweepId, IsPinned) {
  EXPECT_EQ(
      to_hex(sweep_id(sweep("name: a\nseed: 2006\nbase: {gait: walk, cycles: 10}\n"
                            "grids:\n  - {mutation: [all, one], mutation_size: {from: 25, to: 100, step: 25}}\n"))),
      to_hex(leading_128_bits(sha256("lamprey-sweep/1\nname=a\nseed=2006\nreplicates=1\nbase\ncycles=10\n"
                                     "gait=walk\ngrid\nmutation=all,one\nmutation_size=25..100/25\n"))));
}

TEST(SweepId, IsThatOfAValidSpecificationOnly) {
  EXPECT_THROW(sweep_id(idl::SweepSpecification{}), InvalidInput);
}

}  // namespace
}  // namespace lamprey::experiment
