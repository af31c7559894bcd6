#include <gmock/gmock.h>

#include <sstream>

#include "engine/base/hash/sha256.h"
#include "studies/report/record_report.h"

namespace gurney::report {
namespace {

using testing::ElementsAre;

groundmotions::Component constant(double acceleration, const std::string& sha256) {
  groundmotions::Component component;
  component.time_step = 0.01;
  component.acceleration = Eigen::VectorXd::Constant(101, acceleration);
  component.format = "PEER AT2";
  component.unit = "g";
  component.sha256 = sha256;
  return component;
}

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

// 1 s of 1 and of 4 m/s2: geometric means of a = 2 m/s2, v = a T, Ia = pi / (2 g) a^2 T = 0.6407,
// CAV = a T, and 0.9 T between 5 and 95 %. 4 m/s are left. An oscillator of 1 s under a constant
// load ends its first swing after 0.5 s: u omega^2 = a (1 + exp(-pi zeta / sqrt(1 - zeta^2))) =
// 1.8545 a. RotD50: the median of |cos(theta) + 4 sin(theta)| is sqrt(17) / sqrt(2) m/s2 = 0.2973
// g.
TEST(RecordTable, HasMeansOfBothHorizontals) {
  groundmotions::Record record;
  record.name = "made up";
  record.components[0] = constant(1, std::string(64, 'a'));
  record.components[1] = constant(4, std::string(64, 'a'));
  EXPECT_THAT(words(record_table_line(record)),
              ElementsAre("made", "up", "PEER", "AT2", "g", "0.01", "1.00", "0.102", "0.408", "-",
                          "0.551", "2", "0.9", "0.641", "2", "4", "aaaaaaaa", testing::_));
  EXPECT_EQ(record_table_head().find("RotD50"),
            record_table_head().find("Sa(1) g") - record_table_head().find('\n'));
}

TEST(RecordTable, HasTheValuesOfTheOnlyComponent) {
  groundmotions::Record record;
  record.name = "one";
  record.components[2] = constant(4, "");
  record.components[2]->unit = "cm/s2";
  EXPECT_THAT(words(record_table_line(record)),
              ElementsAre("one", "PEER", "AT2", "cm/s2", "0.01", "1.00", "-", "-", "0.408", "0.756",
                          "4", "0.9", "2.56", "4", "4", "-", testing::_));
}

TEST(RecordTable, ReportsAllFilesByOneHash) {
  groundmotions::Record record;
  const std::string a(64, 'a'), b(64, 'b');
  record.components[0] = constant(1, a);
  EXPECT_EQ(short_hash(record), "aaaaaaaa");
  record.components[2] = constant(1, b);
  EXPECT_EQ(short_hash(record), sha256(a + b).substr(0, 8));
}

}  // namespace
}  // namespace gurney::report
