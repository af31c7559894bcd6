#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/job/job.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

TEST(JobBuilding, FindsBuildingsByName) {
  const auto read = [](const std::string& building) {
    const TempFolder folder;
    return read_job(folder.write("job.toml", R"(schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[excitation.record]
synthetic.kind = "ac156"
[excitation.building]
)" + building));
  };
  const Job job = read("file = \"lead_rubber_hospital\"\nfloor = 3\n");
  EXPECT_EQ(job.record->building->building.storeys, 4);
  EXPECT_EQ(job.record->building->floor, 3);
  // The floors of a building that is not there are not known: one error, not two.
  for (const char* floor : {"3", "\"roof\""}) {
    const std::string error = error_text(
        [&] { read(std::string("file = \"lead_ruber_hospital\"\nfloor = ") + floor + "\n"); });
    EXPECT_THAT(error, testing::HasSubstr("job.toml:7:8: excitation.building.file = "
                                          "\"lead_ruber_hospital\": unknown building; did you "
                                          "mean 'lead_rubber_hospital'?"));
    EXPECT_EQ(error.find("floor ="), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace gurney::study
