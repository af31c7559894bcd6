#include "engine/base/random/draw.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#include "engine/base/random/normal_draw.h"

namespace gurney {
namespace {

constexpr int kRuns = 100000;

double score(std::uint64_t run, const char* name, const CorrelationGroup& group = {}) {
  return normal_quantile(Draw(5, run).probability(name, group));
}

/// Sample correlation of the normal scores of two variables.
double correlation(const char* first, const CorrelationGroup& first_group, const char* second,
                   const CorrelationGroup& second_group) {
  double xy = 0, xx = 0, yy = 0;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    const double x = score(run, first, first_group), y = score(run, second, second_group);
    xy += x * y;
    xx += x * x;
    yy += y * y;
  }
  return xy / std::sqrt(xx * yy);
}

// Fisher's z = atanh r is normal with standard deviation 1 / sqrt(n - 3): 4.5 of it.
void expect_correlation(double sample, double expected) {
  EXPECT_NEAR(std::atanh(sample), std::atanh(expected), 4.5 / std::sqrt(kRuns - 3));
}

TEST(Draw, MembersOfAGroupCorrelateByTheProductOfTheirCorrelations) {
  const CorrelationGroup tread{"treads", 0.7}, other{"treads", 0.5}, against{"treads", -0.7};
  expect_correlation(correlation("a", tread, "b", tread), 0.49);
  expect_correlation(correlation("a", tread, "b", other), 0.35);
  expect_correlation(correlation("a", tread, "b", against), -0.49);
  expect_correlation(correlation("a", tread, "b", {"treads", 1}), 0.7);
  expect_correlation(correlation("a", tread, "b", {"brakes", 0.7}), 0);
  expect_correlation(correlation("a", {}, "b", {}), 0);
  expect_correlation(correlation("a", tread, "b", {}), 0);
  EXPECT_EQ(score(1, "a", {"treads", 1}), score(1, "b", {"treads", 1}));
}

// Mean and variance of a partly correlated score: 1 / sqrt n and sqrt(2 / n), 4.5 of them.
TEST(Draw, PartlyCorrelatedScoresAreStandardNormal) {
  double sum = 0, squares = 0;
  for (std::uint64_t run = 0; run < kRuns; ++run) {
    const double x = score(run, "a", {"treads", 0.7});
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / kRuns, 0, 4.5 / std::sqrt(kRuns));
  EXPECT_NEAR(squares / kRuns, 1, 4.5 * std::sqrt(2.0 / kRuns));
}

TEST(Draw, DependsOnSeedRunAndNameOnly) {
  const Draw draw(1, 2);
  EXPECT_EQ(draw.probability("x"), Draw(1, 2).probability("x"));
  EXPECT_NE(draw.probability("x"), Draw(1, 3).probability("x"));
  EXPECT_NE(draw.probability("x"), Draw(2, 2).probability("x"));
  EXPECT_NE(draw.probability("x"), draw.probability("y"));
  EXPECT_NE(draw.probability("x"), draw.probability("y", {"x", 1}));  // a group is no variable
  EXPECT_EQ(draw.probability("x"), draw.probability("x", {"g", 0}));
}

// The numbers are part of the file format: a study must give them again in ten years. From Philox
// 4x64-10 with key (1, FNV-1a("variable x")) and counter (2, 0, 0, 0),
// computed by a second program in Python.
TEST(Draw, GivesTheNumbersItAlwaysGave) {
  EXPECT_EQ(Draw(1, 2).probability("x"), 0.9040619785017003);
  EXPECT_EQ(Draw(1, 2).probability("x", {"g", 1}), 0.9384227184554879);
}

TEST(Draw, PartsHaveTheirOwnVariablesAndShareTheirGroups) {
  const Draw draw(1, 2), left = draw.of_part("front left"), right = draw.of_part("front right");
  EXPECT_EQ(left.full_name("cr"), "front left/cr");
  EXPECT_EQ(left.of_part("tread").full_name("cr"), "front left/tread/cr");
  EXPECT_NE(left.probability("cr"), right.probability("cr"));
  EXPECT_EQ(left.probability("cr"), draw.probability("front left/cr"));
  EXPECT_EQ(left.probability("cr", {"treads", 1}), right.probability("cr", {"treads", 1}));
  EXPECT_NE(left.probability("cr", {"treads", 0.9}), right.probability("cr", {"treads", 0.9}));
  EXPECT_EQ(left.text(), "draw 2 of seed 1");
}

TEST(Draw, DependsOnNoThreadAndNoOrder) {
  constexpr std::uint64_t kFew = 1000;
  std::vector<double> forwards(kFew), backwards(kFew);
  std::thread first([&] {
    for (std::uint64_t run = 0; run < kFew; ++run) forwards[run] = score(run, "a", {"g", 0.5});
  });
  std::thread second([&] {
    for (std::uint64_t run = kFew; run-- > 0;) {
      score(run, "b");
      backwards[run] = score(run, "a", {"g", 0.5});
    }
  });
  first.join();
  second.join();
  EXPECT_EQ(forwards, backwards);
}

/// The cells of 1/16 that 16 draws of a variable fall into.
std::set<int> cells(const char* name, const std::function<Draw(std::uint64_t)>& draw) {
  std::set<int> result;
  for (std::uint64_t run = 0; run < 16; ++run)
    result.insert(static_cast<int>(16 * draw(run).probability(name)));
  return result;
}

TEST(Draw, PlansPutOneDrawOfEachVariableInEachCell) {
  const auto streams = std::make_shared<Draw::Streams>(
      Draw::Streams{"variable mass", "variable friction", "variable left", "group treads"});
  const auto hypercube = [](std::uint64_t run) { return Draw::of_hypercube(3, run, 16); };
  const auto sobol = [&](std::uint64_t run) { return Draw::of_sobol(3, run, streams); };
  for (const char* name : {"mass", "friction"}) {
    EXPECT_EQ(cells(name, hypercube).size(), 16) << name;
    EXPECT_EQ(cells(name, sobol).size(), 16) << name;
  }
  // Plain draws fill all cells with probability 16! / 16^16 = 1e-6 only.
  EXPECT_LT(cells("mass", [](std::uint64_t run) { return Draw(3, run); }).size(), 16);
  EXPECT_EQ(Draw::of_sobol(3, 5, streams).probability("new"), Draw(3, 5).probability("new"));
}

/// The normal scores of a variable in the draws of a Latin hypercube.
std::vector<double> hypercube_scores(std::uint64_t seed, std::uint64_t draws, const char* name,
                                     const CorrelationGroup& group) {
  std::vector<double> scores;
  for (std::uint64_t run = 0; run < draws; ++run)
    scores.push_back(
        normal_quantile(Draw::of_hypercube(seed, run, draws).probability(name, group)));
  return scores;
}

double sample_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  double xy = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xy += x[i] * y[i];
    xx += x[i] * x[i];
    yy += y[i] * y[i];
  }
  return xy / std::sqrt(xx * yy);
}

TEST(Draw, AHypercubeStratifiesMembersOfGroups) {
  for (const double r : {0.3, 0.8, -0.8, 1.0, -1.0}) {
    std::set<int> cells;
    for (std::uint64_t run = 0; run < 30; ++run)
      cells.insert(
          static_cast<int>(30 * Draw::of_hypercube(3, run, 30).probability("a", {"g", r})));
    EXPECT_EQ(cells.size(), 30) << "correlation " << r;
  }
}

// Fisher's z, 4.5 of its standard deviations: the sampling error of plain draws, of which a
// hypercube has no more.
TEST(Draw, AHypercubeKeepsTheCorrelationOfAGroup) {
  constexpr std::uint64_t kDraws = 3000;
  const auto of = [&](const char* name, double r) {
    return hypercube_scores(4, kDraws, name, {"g", r});
  };
  const double allowed = 4.5 / std::sqrt(kDraws - 3);
  EXPECT_NEAR(std::atanh(sample_correlation(of("a", 0.8), of("b", 0.8))), std::atanh(0.64),
              allowed);
  EXPECT_NEAR(std::atanh(sample_correlation(of("a", 0.8), of("b", -0.5))), std::atanh(-0.4),
              allowed);
  EXPECT_NEAR(std::atanh(sample_correlation(of("a", 0.8), of("b", 1))), std::atanh(0.8), allowed);
}

TEST(Draw, AMemberInAHypercubeDependsOnSeedRunAndNameOnly) {
  const auto member = [](std::uint64_t seed, std::uint64_t run, const char* name) {
    return Draw::of_hypercube(seed, run, 30).probability(name, {"g", 0.8});
  };
  EXPECT_EQ(member(3, 7, "a"), member(3, 7, "a"));
  EXPECT_NE(member(3, 7, "a"), member(4, 7, "a"));
  EXPECT_NE(member(3, 7, "a"), member(3, 8, "a"));
  EXPECT_NE(member(3, 7, "a"), member(3, 7, "b"));
  std::vector<double> forwards(30), backwards(30);
  std::thread other([&] {
    for (std::uint64_t run = 30; run-- > 0;) backwards[run] = member(9, run, "c");
  });
  for (std::uint64_t run = 0; run < 30; ++run) forwards[run] = member(9, run, "c");
  other.join();
  EXPECT_EQ(forwards, backwards);
}

TEST(Draw, StreamsOfAVariableAreItsOwnAndItsGroups) {
  const Draw draw = Draw(3, 0).of_part("left");
  EXPECT_EQ(draw.streams_of("mass"), (Draw::Streams{"variable left/mass"}));
  EXPECT_EQ(draw.streams_of("mass", {"treads", 0.5}),
            (Draw::Streams{"variable left/mass", "group treads"}));
  EXPECT_EQ(draw.streams_of("mass", {"treads", 1}), (Draw::Streams{"group treads"}));
}

TEST(Draw, RowsOfASaltelliDesignTakeOneInputFromB) {
  const auto inputs = std::make_shared<Draw::Streams>(
      Draw::Streams{"group treads", "variable left", "variable mass"});
  const CorrelationGroup half{"treads", 0.5}, whole{"treads", 1};
  const auto row = [&](std::uint64_t matrix) {
    return Draw::of_saltelli(3, 0, {7, matrix}, inputs);
  };
  const auto left = [&](std::uint64_t matrix) { return row(matrix).probability("left", half); };
  const auto right = [&](std::uint64_t matrix) { return row(matrix).probability("right", whole); };
  const auto mass = [&](std::uint64_t matrix) { return row(matrix).probability("mass"); };
  const auto other = [&](std::uint64_t matrix) { return row(matrix).probability("other"); };
  for (const auto& value : {std::function<double(std::uint64_t)>(left), {right}, {mass}, {other}})
    EXPECT_NE(value(0), value(1));
  // 2: the group from B. 3: what is left's alone. 4: the mass.
  EXPECT_EQ(right(2), right(1));
  EXPECT_EQ(right(3), right(0));
  EXPECT_EQ(mass(4), mass(1));
  EXPECT_EQ(mass(2), mass(0));
  std::set<double> lefts;
  for (std::uint64_t matrix = 0; matrix < 4; ++matrix) lefts.insert(left(matrix));
  EXPECT_EQ(lefts.size(), 4u) << "the score is of both inputs";
  EXPECT_EQ(left(4), left(0));
  for (std::uint64_t matrix = 2; matrix < 5; ++matrix) EXPECT_EQ(other(matrix), other(0));
}

}  // namespace
}  // namespace gurney
