#include "groundmotions/assembly/plausibility.h"

#include <gmock/gmock.h>

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Record record(const Eigen::VectorXd& h1, const Eigen::VectorXd& h2) {
  Record result;
  for (const auto& [place, samples] : {std::pair(0, &h1), std::pair(1, &h2)}) {
    Component component;
    component.name = place == 0 ? "A" : "B";
    component.file = place == 0 ? "a" : "b";
    component.time_step = 0.1;
    component.acceleration = *samples;
    result.components[static_cast<std::size_t>(place)] = component;
  }
  return result;
}

TEST(Plausibility, FindsNothingInAnEverydayRecord) {
  EXPECT_THAT(implausible(record(Eigen::Vector4d(1, -2, 3, -2), Eigen::Vector4d(2, -1, 1, -2))),
              IsEmpty());
}

// A roller with 1 % of its peak acceleration as an offset is worth no word here; 10 % is.
TEST(Plausibility, FindsAConstantOffset) {
  const Eigen::VectorXd swing = Eigen::Vector4d(1, -1, 1, -1).replicate(25, 1);
  EXPECT_THAT(implausible(record(swing.array() + 0.1, 0.9 * swing)), IsEmpty());
  EXPECT_THAT(implausible(record(swing.array() + 0.2, 0.9 * swing)),
              ElementsAre(HasSubstr("a: the mean of h1 is 0.0204 g at a peak of 0.122 g")));
}

TEST(Plausibility, FindsSamplesOfOneSign) {
  const Eigen::VectorXd swing = Eigen::Vector4d(1, -1, 1, -1).replicate(25, 1);
  EXPECT_THAT(implausible(record(swing.array() + 1, 0.9 * swing)),
              ElementsAre(HasSubstr("a: all samples of h1 have one sign")));
  EXPECT_THAT(implausible(record(-1 - swing.array(), 0.9 * swing)),
              ElementsAre(HasSubstr("a: all samples of h1 have one sign")));
}

TEST(Plausibility, FindsComponentsThatDisagreeByOrdersOfMagnitude) {
  const Eigen::VectorXd swing = Eigen::Vector4d(1, -1, 1, -1).replicate(25, 1);
  EXPECT_THAT(implausible(record(9.9 * swing, 0.1 * swing)), IsEmpty());
  EXPECT_THAT(implausible(record(10.1 * swing, 0.1 * swing)),
              ElementsAre(HasSubstr("a and b: peak accelerations of 1.03 and 0.0102 g")));
}

TEST(Plausibility, FindsTheSameComponentTwice) {
  const Eigen::VectorXd swing = Eigen::Vector4d(1, -1, 1, -1).replicate(25, 1);
  EXPECT_THAT(implausible(record(swing, swing)),
              ElementsAre("a and b: components 'A' and 'B' are the same numbers"));
}

TEST(Plausibility, NamesNoFileOfWhatHasNone) {
  const Eigen::VectorXd swing = Eigen::Vector4d(1, -1, 1, -1).replicate(25, 1);
  Record synthetic = record(30 * swing, 30 * swing);
  for (std::optional<Component>& each : synthetic.components)
    if (each) each->file.clear();
  EXPECT_THAT(implausible(synthetic),
              ElementsAre(testing::StartsWith("the peak acceleration of h1"),
                          testing::StartsWith("the peak acceleration of h2"),
                          "A and B: components 'A' and 'B' are the same numbers"));
}

TEST(Plausibility, FindsPeaksNobodyRecorded) {
  const Eigen::VectorXd swing = Eigen::Vector4d(1, -1, 1, -1).replicate(25, 1);
  EXPECT_THAT(implausible(record(29 * swing, 28 * swing)), IsEmpty());
  EXPECT_THAT(implausible(record(30 * swing, 28 * swing)),
              ElementsAre(HasSubstr("the peak acceleration of h1 is 3.06 g")));
  EXPECT_THAT(implausible(record(0.009 * swing, 0.01 * swing)),
              ElementsAre(HasSubstr("the peak acceleration of h1 is 0.000918 g")));
}

}  // namespace
}  // namespace gurney::groundmotions
