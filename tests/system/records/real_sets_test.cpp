#include <algorithm>
#include <map>
#include <set>

#include "groundmotions/suites/suite.h"
#include "tests/system/records/real_records.h"

namespace gurney::groundmotions {
namespace {

using FileNames = std::set<std::string>;

/// Sets of files that belong together: component_sets.csv beside the real files.
class RealSets : public RealRecords {
 protected:
  std::vector<FileNames> sets() const {
    std::ifstream stream(folder_ / "component_sets.csv");
    std::vector<FileNames> all;
    std::string line;
    for (std::getline(stream, line); std::getline(stream, line);) {
      std::istringstream text(line);
      std::vector<std::string> cells;
      for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
      FileNames files(cells.begin() + 1, cells.begin() + 4);
      files.erase("");
      all.push_back(files);
    }
    return all;
  }

  /// Units of files that do not state them.
  static ReadOptions options_for(const std::string& folder) {
    if (folder == "sac") return {.unit = "cm/s2"};
    if (folder == "ucgmsim_emod3d_text") return {.unit = "g"};
    return {};
  }

  const Suite& suite_of(const std::string& folder) {
    if (!suites_.contains(folder))
      suites_[folder] = read_suite({folder_ / folder}, options_for(folder));
    return suites_[folder];
  }

  std::map<std::string, Suite> suites_;
};

TEST_F(RealSets, FilesOfOneRecordAreOneRecordOfTheirFolder) {
  const auto all = sets();
  EXPECT_GT(all.size(), 30u);
  for (const FileNames& files : all) {
    SCOPED_TRACE(*files.begin());
    const std::string folder = std::filesystem::path(*files.begin()).parent_path().string();
    const Suite& suite = suite_of(folder);
    const auto record = std::ranges::find_if(suite.records, [&](const SuiteRecord& each) {
      FileNames own;
      for (const RecordFile& file : each.files)
        own.insert(file.path.lexically_relative(folder_).string());
      return own == files;
    });
    ASSERT_NE(record, suite.records.end());
    const Record read = read_record(*record);
    EXPECT_TRUE(read[Direction::kH1] && read[Direction::kH2]);
    const bool alone = files.size() == 2;
    EXPECT_EQ(read[Direction::kVertical].has_value(), !alone);
  }
}

}  // namespace
}  // namespace gurney::groundmotions
