#include "groundmotions/measures/summary.h"

#include <gmock/gmock.h>

#include <cmath>

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Component component(double rate) {
  Component result;
  result.time_step = 0.01;
  result.acceleration.resize(800);
  for (int i = 0; i < 800; ++i) result.acceleration[i] = std::sin(rate * i) * std::exp(-0.003 * i);
  return result;
}

std::vector<std::string> names(const SummaryRow& row) {
  std::vector<std::string> result;
  for (const auto& [name, value] : row.values) result.push_back(name);
  return result;
}

TEST(Summary, OfAComponentHasEveryMeasure) {
  const Component c = component(0.1);
  const Summary s = summary(c);
  ASSERT_EQ(s.rows.size(), common_measures().size());
  EXPECT_EQ(s.rows[0].name, "PGA");
  EXPECT_EQ(s.rows[0].unit, "m/s2");
  EXPECT_THAT(s.rows[0].definition, HasSubstr("largest |acceleration|"));
  for (const SummaryRow& row : s.rows) {
    ASSERT_THAT(names(row), ElementsAre("value")) << row.name;
    EXPECT_EQ(row.values[0].second, value_of(row.measure, c.time_step, c.acceleration));
  }
  EXPECT_TRUE(s.warnings.empty());
}

TEST(Summary, OfARecordHasWhatItsComponentsAllow) {
  Record record;
  record.components[0] = component(0.1);
  record.components[2] = component(0.3);
  const auto measures = {parse_measure("PGV"), parse_measure("D5-95"), parse_measure("Sa(1)")};
  EXPECT_THAT(names(summary(record, measures).rows[0]), ElementsAre("h1", "vertical"));
  record.components[1] = component(0.2);
  const Summary s = summary(record, measures);
  EXPECT_THAT(names(s.rows[0]),
              ElementsAre("h1", "h2", "vertical", "geomean", "RotD50", "RotD100", "resultant"));
  EXPECT_THAT(names(s.rows[1]), ElementsAre("h1", "h2", "vertical", "geomean"));
  EXPECT_THAT(names(s.rows[2]),
              ElementsAre("h1", "h2", "vertical", "geomean", "RotD50", "RotD100"));
  EXPECT_EQ(s.rows[2].values[4].second,
            value_of(parse_measure("Sa(1)"), Combination::kRotD50, record));
}

TEST(Summary, WarnsOfWhatIsNotThereAndOfShortPeriods) {
  const Summary s = summary(component(0.1), {parse_measure("FIV3(30)"), parse_measure("Sa(0.05)")});
  EXPECT_TRUE(s.rows[0].values.empty());
  EXPECT_EQ(s.rows[1].values.size(), 1u);
  ASSERT_EQ(s.warnings.size(), 2u);
  EXPECT_THAT(s.warnings[0], HasSubstr("FIV3(30): the period must be at most"));
  EXPECT_THAT(s.warnings[1], HasSubstr("Sa(0.05 s): the time step of 0.01 s"));
}

}  // namespace
}  // namespace gurney::groundmotions
