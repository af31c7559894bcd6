#include <fstream>
#include <numeric>

#include "studies/results/hdf5_reader.h"
#include "studies/results/hdf5_writer.h"
#include "tests/support/error_text.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

std::string saved(Hdf5Writer& file, const TempFolder& folder) {
  const std::string path = folder.file("a.h5");
  std::ofstream(path, std::ios::binary) << file.image();
  return path;
}

TEST(Hdf5File, GivesBackWhatWasWritten) {
  const TempFolder folder;
  Hdf5Writer file;
  file.add_group("/g");
  file.add_scale({"/g/t", "s", "time", {}}, std::vector<double>{0, 0.5});
  file.add_scale({"/g/w", "1", "wheel", {}},
                 std::vector<std::string>{"left", "right", "r\u00e9ar"});
  file.add({"/g/n", "N", "force", {"/g/t", "/g/w"}}, std::vector<double>{1, 2, 3, 4, 5, 6});
  file.add({"/g/c", "1", "count", {"/g/t"}}, std::vector<std::int64_t>{-7, 1LL << 40});
  file.set_attribute("/", "job_text", std::string(100000, 'x'));  // beyond HDF5's 64 kB in place
  const Hdf5Reader reader(saved(file, folder));
  EXPECT_EQ(reader.numbers("/g/n"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(reader.numbers("/g/c"), (std::vector<double>{-7, 1099511627776.0}));
  EXPECT_EQ(reader.strings("/g/w"), (std::vector<std::string>{"left", "right", "r\u00e9ar"}));
  EXPECT_EQ(reader.text_attribute("job_text").size(), 100000u);
}

// Numbers count up by one: shuffled, all bytes of a double but two are almost constant.
TEST(Hdf5File, IsSmallerThanItsNumbers) {
  std::vector<double> counted(100000);
  std::iota(counted.begin(), counted.end(), 0);
  Hdf5Writer file;
  file.add_scale({"/t", "s", "time", {}}, counted);
  EXPECT_LT(file.image().size(), counted.size() * sizeof(double) / 2);
}

TEST(Hdf5File, DescribesItsDatasets) {
  const TempFolder folder;
  Hdf5Writer file;
  file.add_group("/g");
  file.add_scale({"/g/t", "s", "time", {}}, std::vector<double>{0, 0.5});
  file.add({"/g/mode", "1", "what it does", {"/g/t"}}, std::vector<std::uint8_t>{1, 2});
  const auto datasets = Hdf5Reader(saved(file, folder)).datasets();
  ASSERT_EQ(datasets.size(), 2u);
  EXPECT_EQ(datasets[0].path, "/g/mode");
  EXPECT_EQ(datasets[0].type, "uint8");
  EXPECT_EQ(datasets[0].scales, std::vector<std::string>{"t"});
  EXPECT_EQ(datasets[0].long_name, "what it does");
  EXPECT_EQ(datasets[1].type, "float64");
  EXPECT_EQ(datasets[1].units, "s");
  EXPECT_EQ(datasets[1].scales, std::vector<std::string>{"t"});
}

TEST(Hdf5File, TakesEmptyDimensions) {
  const TempFolder folder;
  Hdf5Writer file;
  file.add_group("/g");
  file.add_scale({"/g/p", "1", "point", {}}, std::vector<std::string>{});
  file.add({"/g/a", "1", "nothing", {"/g/p"}}, std::vector<double>{});
  file.set_attribute("/", "none", std::vector<std::string>{});
  EXPECT_TRUE(Hdf5Reader(saved(file, folder)).numbers("/g/a").empty());
}

TEST(Hdf5File, WhatIsNoneIsReportedInWords) {
  const TempFolder folder;
  EXPECT_ERROR(Hdf5Reader(folder.file("a.h5")), "a.h5: no such file");
  EXPECT_ERROR(Hdf5Reader(folder.path()), ": is a folder, not a file");
  std::ofstream(folder.file("text.h5")) << "text";
  EXPECT_ERROR(Hdf5Reader(folder.file("text.h5")),
               "text.h5: is not a results file of gurney (no HDF5 file)");
}

TEST(Hdf5File, ErrorsStateTheReasonInOneLine) {
  const TempFolder folder;
  const std::string path = folder.file("none/a.h5");
  EXPECT_EQ(error_text([&] { Hdf5Writer file(path); }),
            "HDF5 cannot make " + path + ": No such file or directory");
  Hdf5Writer file;
  EXPECT_EQ(error_text([&] { file.add_group("/missing/group"); }),
            "HDF5 cannot make group /missing/group: component not found");
  file.add_group("/g");
  file.add_scale({"/g/t", "s", "time", {}}, std::vector<double>{0, 0.5});
  EXPECT_ERROR(file.add({"/g/a", "m", "a", {"/g/t"}}, std::vector<double>{1}),
               "write dataset /g/a: its scales ask for 2 values, got 1");
  EXPECT_ERROR(file.add({"/g/a", "m", "a", {"/g/none"}}, std::vector<double>{1}),
               "no dimension scale /g/none for /g/a");
}

}  // namespace
}  // namespace gurney::study
