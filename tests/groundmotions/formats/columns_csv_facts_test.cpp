#include <gmock/gmock.h>

#include "engine/base/units.h"
#include "groundmotions/formats/writers.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

std::vector<Component> read(const std::string& text) {
  return read_components(SourceFile("f.csv", text), {});
}

const std::string kRows = "time_s,x_m_per_s2,z_m_per_s2\n0,1,2\n0.01,3,4\n";

Record record_of(const std::vector<Component>& components) {
  Record record;
  for (const Component& component : components)
    record.components[static_cast<std::size_t>(*component.direction)] = component;
  return record;
}

TEST(ColumnsCsvFacts, ReadsAzimuthsAndStartsAsTheyAreWritten) {
  Record record = record_of(read(kRows));
  record.components[0]->azimuth = 318.25 * kRadiansPerDegree;
  // 1994-01-17 is day 8782 since 1970: 24 years, 6 leap days and 16 days.
  const double start = 8782 * 86400. + 12 * 3600 + 30 * 60 + 55.125;
  record.components[0]->start_time = start;
  record.components[2]->start_time = start + 0.002;
  const std::string text = columns_csv_text(record, {"of a test"});
  EXPECT_EQ(text.substr(0, text.find("time_s")),
            "# of a test\n"
            "# h1: azimuth 318.25 deg\n"
            "# h1: start 1994-01-17T12:30:55.125Z\n"
            "# vertical: start 1994-01-17T12:30:55.127Z\n");
  const auto again = read(text);
  EXPECT_NEAR(again[0].azimuth.value(), 318.25 * kRadiansPerDegree, 1e-9);  // ten digits
  EXPECT_FALSE(again[1].azimuth);
  EXPECT_NEAR(again[0].start_time.value(), start, 0.0005);  // milliseconds
  EXPECT_NEAR(again[1].start_time.value(), start + 0.002, 0.0005);
}

TEST(ColumnsCsvFacts, KnowsStartsBefore1970) {
  Record record = record_of(read(kRows));
  record.components[0]->start_time = -0.25;
  EXPECT_EQ(columns_csv_facts(record), "# h1: start 1969-12-31T23:59:59.750Z\n");
  EXPECT_NEAR(read(columns_csv_facts(record) + kRows)[0].start_time.value(), -0.25, 0.0005);
}

TEST(ColumnsCsvFacts, LeavesOtherCommentsAlone) {
  for (const Component& component : read("# h1\n#\n# h1: north\n# azimuth 30 deg\n" + kRows)) {
    EXPECT_FALSE(component.azimuth);
    EXPECT_FALSE(component.start_time);
  }
  EXPECT_TRUE(read("# a: azimuth 0 deg\ntime_s,a_g\n0,1\n1,2\n")[0].azimuth);
}

TEST(ColumnsCsvFacts, ReportsWhatIsWrong) {
  EXPECT_EQ(error_text([] {
              read(
                  "# h1: azimuth 30\n# h1: azimuth 400 deg\n# h1: start yesterday\n"
                  "# h2: azimuth 3 deg\n# vertical: azimuth 3 deg\n# h1: azimuth 3 deg\n"
                  "# h1: azimuth 4 deg\n" +
                  kRows);
            }),
            "f.csv:1:1: '30': must be such as 318 deg, from 0 to 360\n"
            "f.csv:2:1: '400 deg': must be such as 318 deg, from 0 to 360\n"
            "f.csv:3:1: 'yesterday': must be such as 1994-01-17T12:30:55.000Z\n"
            "f.csv:4:1: the file has no column of h2\n"
            "f.csv:5:1: a vertical has no azimuth\n"
            "f.csv:7:1: 'azimuth 4 deg' is stated twice for h1");
}

}  // namespace
}  // namespace gurney::groundmotions
