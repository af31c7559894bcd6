#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <set>

#include "tests/groundmotions/formats/checked_read.h"
#include "tests/groundmotions/formats/format_samples.h"
#include "tests/support/temp_folder.h"

/// Real files, cut and changed: one of each kind in the folder named by GURNEY_RECORDS.
namespace gurney::groundmotions {
namespace {

constexpr std::uintmax_t kLargest = 200'000;  ///< so that all of it takes some seconds [bytes]

/// The first of a few options under which a file is read; its components.
std::pair<ReadOptions, Components> read_whole(const std::string& bytes) {
  for (const ReadOptions& options :
       {ReadOptions{}, ReadOptions{.unit = "g"}, ReadOptions{.unit = "g", .time_step = 0.01}}) {
    Components components = checked_read(bytes, options);
    if (!components.empty()) return {options, components};
  }
  return {};
}

/// A file with a row more than it states may lose that row.
bool has_more_than_stated(const Components& components) {
  return std::ranges::any_of(components[0].warnings, [](const std::string& warning) {
    return warning.find("all were taken") != std::string::npos;
  });
}

TEST(RealRobustness, CutAndChangedFilesAreErrorsOrRecords) {
  const char* folder = std::getenv("GURNEY_RECORDS");
  if (!folder) GTEST_SKIP() << "GURNEY_RECORDS names no folder of real records";
  std::set<std::string> no_count, kinds;
  for (const FormatSample& sample : format_samples())
    if (!sample.states_count) no_count.insert(sample.format);
  std::set<std::filesystem::path> files;  // in one order on every machine
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.file_size() <= kLargest) files.insert(entry.path());

  std::mt19937 draw(3);
  int cases = 0;
  for (const auto& path : files) {
    if (!kinds.insert((path.parent_path() / path.extension()).string()).second) continue;
    SCOPED_TRACE(path);
    const std::string bytes = contents_of(path);
    const auto [options, whole] = read_whole(bytes);
    if (whole.empty()) continue;
    for (const double share : {0.3, 0.8, 0.95, 1.0}) {
      auto length = static_cast<std::size_t>(share * static_cast<double>(bytes.size() - 2));
      for (const bool at_line_end : {false, true}) {
        if (at_line_end) length = bytes.rfind('\n', length) + 1;
        const Components cut = checked_read(bytes.substr(0, length), options);
        ++cases;
        if (cut.empty() || no_count.contains(whole[0].format) || has_more_than_stated(whole))
          continue;
        EXPECT_TRUE(samples_in(cut) >= samples_in(whole) || warnings_in(cut) > warnings_in(whole))
            << "cut at " << length << ": " << samples_in(cut) << " samples of "
            << samples_in(whole);
      }
    }
    for (int round = 0; round < 4; ++round) {
      std::string changed = bytes;
      for (int i = 0; i < 3; ++i) {
        // Half of the changes in the header.
        const std::size_t range =
            i % 2 == 0 ? changed.size() : std::min<std::size_t>(2000, changed.size());
        changed[draw() % range] =
            static_cast<char>(draw() % 2 == 0 ? draw() % 256 : '0' + draw() % 10);
      }
      checked_read(changed, options);
      ++cases;
    }
  }
  EXPECT_GT(cases, 200);
}

}  // namespace
}  // namespace gurney::groundmotions
