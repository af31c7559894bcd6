#include "groundmotions/measures/combination.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/units.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using Eigen::VectorXd;

VectorXd motion(double rate) {
  VectorXd a(600);
  for (int i = 0; i < a.size(); ++i)
    a[i] = std::sin(rate * i) * std::exp(-0.003 * i) + 0.3 * std::cos(rate * rate * i);
  return a;
}

Record record_of(const VectorXd& h1, const VectorXd& h2) {
  Record record;
  record.name = "made up";
  for (auto& component : {&record.components[0], &record.components[1]}) {
    component->emplace();
    (*component)->time_step = 0.01;
  }
  record.components[0]->acceleration = h1;
  record.components[1]->acceleration = h2;
  return record;
}

double value(const char* measure, Combination combination, const Record& record) {
  return value_of(parse_measure(measure), combination, record);
}

TEST(Combination, IsWrittenAsItIsRead) {
  for (const std::string& name : known_combinations())
    EXPECT_EQ(name_of(parse_combination(name)), name);
  EXPECT_EQ(parse_combination("rotd50"), Combination::kRotD50);
  EXPECT_EQ(error_text([] { parse_combination("RotD5O"); }),
            "component 'RotD5O': unknown component or combination; did you mean 'RotD50'?");
}

TEST(Combination, OfTwoNumbers) {
  const Record record = record_of(motion(0.1), 2 * motion(0.1));
  const double h1 = value("Arias", Combination::kH1, record);
  const double h2 = value("Arias", Combination::kH2, record);
  EXPECT_NEAR(h2, 4 * h1, 1e-12);
  EXPECT_NEAR(value("Arias", Combination::kGeometricMean, record), 2 * h1, 1e-12);
  EXPECT_EQ(value("Arias", Combination::kLarger, record), h2);
  EXPECT_NEAR(value("Arias", Combination::kSrss, record), std::sqrt(17.0) * h1, 1e-12);
}

// One direction (3, 4): the resultant is 5 times it; the nearest whole angle, 53 degrees, is 0.13
// degrees off. RotD50 is sin 45 of it, give or take half a degree.
TEST(Combination, OfMotionInOneDirection) {
  const VectorXd along = motion(0.1);
  const Record record = record_of(3 * along, 4 * along);
  for (const char* measure : {"PGA", "PGV", "PGD", "Sa(0.5)", "SaAvg(0.5)", "CAV", "SI"}) {
    const double whole = value_of(parse_measure(measure), 0.01, 5 * along);
    EXPECT_NEAR(value(measure, Combination::kRotD100, record), whole, 1e-5 * whole) << measure;
    EXPECT_NEAR(value(measure, Combination::kRotD50, record), std::sqrt(0.5) * whole,
                std::sqrt(0.5) * 0.5 * kRadiansPerDegree * whole)
        << measure;
    EXPECT_LT(value(measure, Combination::kRotD00, record), 0.5 * kRadiansPerDegree * whole);
  }
  EXPECT_NEAR(value("PFA", Combination::kResultant, record), 5 * along.cwiseAbs().maxCoeff(),
              1e-13);
  EXPECT_NEAR(value("PGV", Combination::kResultant, record),
              5 * value("PGV", Combination::kH1, record) / 3, 1e-13);
}

// The fast way of Sa against the general one: the measure of each turned motion.
TEST(Combination, RotDOfSaIsThatOfTurnedMotions) {
  const VectorXd h1 = motion(0.1), h2 = motion(0.17);
  const Record record = record_of(h1, h2);
  std::vector<double> values;
  for (int i = 0; i < 180; ++i)
    values.push_back(
        value_of(parse_measure("Sa(0.4, 2%)"), 0.01,
                 std::cos(i * kRadiansPerDegree) * h1 + std::sin(i * kRadiansPerDegree) * h2));
  std::sort(values.begin(), values.end());
  EXPECT_NEAR(value("Sa(0.4, 2%)", Combination::kRotD50, record), (values[89] + values[90]) / 2,
              1e-12);
  EXPECT_NEAR(value("Sa(0.4, 2%)", Combination::kRotD00, record), values[0], 1e-12);
}

TEST(Combination, OfSaAvgIsTakenAtEachPeriod) {
  const Record record = record_of(motion(0.1), motion(0.17));
  for (const auto each : {Combination::kLarger, Combination::kSrss, Combination::kRotD50}) {
    double logarithms = 0;
    const VectorXd periods = spectral_periods(parse_measure("SaAvg(0.3:0.6)"));
    for (const double period : periods)
      logarithms += std::log(value_of({MeasureKind::kSa, period}, each, record));
    EXPECT_NEAR(value("SaAvg(0.3:0.6)", each, record),
                std::exp(logarithms / static_cast<double>(periods.size())), 1e-12);
  }
}

TEST(Combination, NeedsItsComponents) {
  Record record = record_of(motion(0.1), motion(0.2));
  EXPECT_EQ(error_text([&] { value("PGA", Combination::kVertical, record); }),
            "record 'made up' has no component vertical, needed for PGA vertical");
  record.components[1].reset();
  EXPECT_EQ(error_text([&] { value("Sa(1)", Combination::kRotD50, record); }),
            "record 'made up' has no component h2, needed for Sa(1) RotD50");
}

TEST(Combination, IsRefusedWhereItHasNoMeaning) {
  const Record record = record_of(motion(0.1), motion(0.2));
  EXPECT_EQ(error_text([&] { value("CAV", Combination::kResultant, record); }),
            "CAV: only PGA, PGV, PGD, PFA and PFV have a resultant");
  EXPECT_EQ(error_text([&] { value("D5-95", Combination::kSrss, record); }),
            "D5-95: SRSS of durations and periods has no meaning");
}

}  // namespace
}  // namespace gurney::groundmotions
