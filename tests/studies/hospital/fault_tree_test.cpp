#include "studies/hospital/fault_tree.h"

#include <gmock/gmock.h>

#include <cmath>

#include "studies/statistics/special.h"
#include "tests/support/error_text.h"

namespace gurney::study {
namespace {

using testing::HasSubstr;

/// P(the last node works) of independent pieces, by all 2^n outcomes.
double enumerated(const FaultTree& tree, const std::vector<double>& fails) {
  double sum = 0;
  std::vector<char> works(tree.size());
  for (unsigned outcome = 0; outcome < 1u << fails.size(); ++outcome) {
    double chance = 1;
    std::vector<Reached> reached;
    for (std::size_t i = 0; i < fails.size(); ++i) {
      reached.push_back(outcome >> i & 1);
      chance *= reached.back() != 0 ? fails[i] : 1 - fails[i];
    }
    tree.evaluate(reached.data(), works);
    sum += works.back() ? chance : 0;
  }
  return sum;
}

TEST(FaultTree, OfIndependentPiecesHasTheClosedFormsOfSeriesParallelAndKOfN) {
  constexpr int kPieces = 7;
  constexpr double kFails = 0.3;
  for (int least = 1; least <= kPieces; ++least) {
    FaultTree tree;
    std::vector<FaultTree::Node> pieces;
    for (std::size_t i = 0; i < kPieces; ++i) pieces.push_back(tree.piece(i, 1));
    tree.gate(least, pieces);
    const double works = 1 - statistics::binomial_cdf(least - 1, kPieces, 1 - kFails);
    EXPECT_NEAR(enumerated(tree, std::vector<double>(kPieces, kFails)), works, 1e-14);
    if (least == 1) {  // parallel
      EXPECT_NEAR(works, 1 - std::pow(kFails, kPieces), 1e-14);
    }
    if (least == kPieces) {  // series
      EXPECT_NEAR(works, std::pow(1 - kFails, kPieces), 1e-14);
    }
  }
}

TEST(FaultTree, SharesAPieceBetweenItsBranches) {
  // all(a, any(b, c)) and any(a, c): works with a and (b or c).
  FaultTree tree;
  const auto a = tree.piece(0, 1), b = tree.piece(1, 1), c = tree.piece(2, 1);
  const auto first = tree.gate(2, {a, tree.gate(1, {b, c})});
  const auto second = tree.gate(1, {a, c});
  tree.gate(2, {first, second});
  EXPECT_NEAR(enumerated(tree, {0.1, 0.2, 0.4}), 0.9 * (1 - 0.2 * 0.4), 1e-15);
}

TEST(FaultTree, APieceIsLostInTheStatesThatAreAskedFor) {
  FaultTree tree;
  tree.piece(0, 0b110);
  std::vector<char> works(1);
  for (const auto& [reached, expected] : {std::pair{0b001u, 1}, {0b010u, 0}, {0b101u, 0}}) {
    const Reached states = reached;
    tree.evaluate(&states, works);
    EXPECT_EQ(works[0], expected) << reached;
  }
}

TEST(Requirement, IsReadWithItsParts) {
  const Requirement read =
      read_requirement(" all(bed, at_least(2, \"big pump\", pole), not_reached(bed, moved)) ");
  EXPECT_EQ(read.kind, Requirement::Kind::kAll);
  ASSERT_EQ(read.parts.size(), 3);
  EXPECT_EQ(read.parts[0].name, "bed");
  EXPECT_EQ(read.parts[1].at_least, 2);
  EXPECT_EQ(read.parts[1].parts[0].name, "big pump");
  EXPECT_EQ(read.parts[1].parts[0].column, 23);
  EXPECT_EQ(read.parts[2].state, "moved");
}

TEST(Requirement, ErrorsSayWhere) {
  const auto error = [](const char* text) { return error_text([&] { read_requirement(text); }); };
  EXPECT_EQ(error("all(bed"), "at character 8: ')' must stand here");
  EXPECT_EQ(error("all(bed,)"), "at character 9: a name must stand here");
  EXPECT_EQ(error("bed pole"), "at character 5: nothing may follow here");
  EXPECT_EQ(error("al(bed)"), "at character 1: 'al(': is no gate; did you mean 'all'?");
  EXPECT_EQ(error("at_least(0, bed)"),
            "at character 10: '0': at_least begins with a whole number from 1 on");
  EXPECT_EQ(error("at_least(1e30, bed)"),
            "at character 10: '1e30': at_least begins with a whole number from 1 on");
  EXPECT_EQ(error("all(\"bed)"), "at character 5: a quote that does not end");
  EXPECT_THAT(error(std::string(std::string(4 * 70, ' ')).c_str()), HasSubstr("a name must"));
  std::string deep;
  for (int i = 0; i < 70; ++i) deep += "all(";
  EXPECT_THAT(error(deep.c_str()), HasSubstr("nested deeper than 64"));
}

}  // namespace
}  // namespace gurney::study
