#include "tests/system/records/real_records.h"

namespace gurney::groundmotions {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

/// Of text formats; their reference values are in real_records_test.cpp.
class RealTextRecords : public RealRecords {
 protected:
  /// Of the reference values that start so; no file twice.
  std::vector<Component> read_all(const std::string& start) const {
    std::vector<Component> components;
    for (const Reference& row : references(start)) components.push_back(read(row.file).at(0));
    return components;
  }
};

TEST_F(RealTextRecords, KnetFilesNameTheirComponents) {
  for (const char* folder : {"knet/", "kiknet/"})
    for (const Component& component : read_all(folder)) {
      EXPECT_TRUE(component.warnings.empty()) << component.file << ": " << component.warnings[0];
      EXPECT_TRUE(component.file.ends_with(component.name)) << component.name;
      EXPECT_EQ(component.direction == Direction::kVertical, component.name.starts_with("UD"));
      EXPECT_EQ(component.azimuth.value_or(-1), component.name.starts_with("NS") ? 0
                                                : component.name.starts_with("EW")
                                                    ? 90 * kRadiansPerDegree
                                                    : -1);
    }
}

TEST_F(RealTextRecords, EsmAndItacaStateAllDirections) {
  for (const char* folder : {"esm_asc/", "itaca_cor_acc/"})
    for (const Component& component : read_all(folder)) {
      EXPECT_TRUE(component.warnings.empty()) << component.file << ": " << component.warnings[0];
      EXPECT_TRUE(component.azimuth || component.direction == Direction::kVertical)
          << component.file;
    }
}

TEST_F(RealTextRecords, BbpNamesItsComponentsAndSeesACopy) {
  for (const char* file : {"bbp/2002-SYL.bbp", "bbp/ce22170.bbp"}) {
    const auto rows = references(file);
    const auto components = read(file);
    ASSERT_EQ(components.size(), rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(components[k].name, rows[k].component);
  }
  EXPECT_THAT(read("bbp/2002-SYL.bbp")[2].warnings,
              Contains(HasSubstr("component U-D has exactly the samples of N-S")));
}

TEST_F(RealTextRecords, AskForWhatTheFileDoesNotState) {
  EXPECT_THAT(error("plain_text/BM68elc.acc"),
              AllOf(HasSubstr("BM68elc.acc:1:1: 5 numbers in a row, and the first is no time that "
                              "grows from row to row; state columns"),
                    HasSubstr("the file does not state its unit"),
                    HasSubstr("the file does not state its time step")));
  for (const Reference& row : references("ucgmsim_emod3d_text/"))
    EXPECT_THAT(error(row.file), HasSubstr("the file does not state its unit"));
}

}  // namespace
}  // namespace gurney::groundmotions
