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
  const Job twists = read("file = \"twisting_hospital\"\nfloor = 3\nposition_m = [4, -2]\n");
  EXPECT_EQ(twists.record->building->place, Vector2(4, -2));
  EXPECT_THAT(
      error_text(
          [&] { read("file = \"twisting_hospital\"\nfloor = 3\nposition_m = [4000, -2000]\n"); }),
      testing::HasSubstr("position_m[0] = 4000: must be a finite number >= -500 and <= 500"));
  EXPECT_THAT(
      error_text(
          [&] { read("file = \"lead_rubber_hospital\"\nfloor = 3\nposition_m = [4, -2]\n"); }),
      testing::HasSubstr("excitation.building.position_m: has no effect on a floor that does "
                         "not twist: the building has no torsion"));
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

TEST(JobBuilding, FindsFloorsOfTablesByName) {
  const auto read = [](const std::string& floor, const std::string& more = "") {
    const TempFolder folder;
    folder.write("clinic.toml", R"(schema = "gurney-building/1"
name = "Clinic"
kind = "tables"
floors = ["1", "2", "top"]
file = "{record}.out"
columns = "time, 1 h1, 2 h1, top h1"
unit = "g"
acceleration = "absolute"
)");
    return read_job(folder.write("job.toml", R"(schema = "gurney-job/1"
[item]
equipment = "xu_trolley"
[excitation.record]
synthetic.kind = "ac156"
)" + more + R"([excitation.building]
file = "clinic.toml"
floor = )" + floor));
  };
  const auto floor = [&](const std::string& name) { return read(name).record->building->floor; };
  EXPECT_EQ(floor("2"), 1);
  EXPECT_EQ(floor("\"top\""), 2);
  EXPECT_EQ(floor("\"roof\""), 2);
  EXPECT_THAT(
      error_text([&] { floor("\"tp\""); }),
      testing::HasSubstr("excitation.building.floor = \"tp\": must be one of 1, 2, top, roof; "
                         "did you mean 'top'?"));
  EXPECT_THAT(error_text([&] { floor("3"); }),
              testing::HasSubstr("excitation.building.floor = 3: must be 1, 2, top or roof"));
  EXPECT_THAT(error_text([&] {
                read("1", "processing = [{ step = \"baseline\", kind = \"end_at_rest\" }]\n");
              }),
              testing::HasSubstr("excitation.record.processing: must not go with floor motions of "
                                 "another program"));
}

}  // namespace
}  // namespace gurney::study
