#include <gmock/gmock.h>

#include <random>

#include "engine/base/error.h"
#include "groundmotions/formats/format.h"
#include "tests/groundmotions/formats/network_samples.h"

/// Damaged files of networks give an Error or finite samples; what is cut is never taken for whole.
namespace gurney {
namespace {

std::vector<std::string> whole_files() {
  return {csmip_volume1(),
          pairs_volume1({0, 0.005, 0.01, 0.015, 0.02, 0.025, 0.035, 0.04, 0.045, 0.05}),
          csmip_volume2(),
          cosmos_file(),
          bhrc_channel("L1"),
          usc_block("AC") + usc_block("VL")};
}

/// The samples of the first component; nothing if the file is refused.
Eigen::VectorXd samples_of(const std::string& text) {
  try {
    const auto components = read_components(SourceFile("f", text));
    EXPECT_FALSE(components.empty());
    for (const Component& component : components) {
      EXPECT_GE(component.acceleration.size(), 2);
      EXPECT_TRUE(component.acceleration.allFinite());
      EXPECT_TRUE(component.time_step > 0 && component.time_step <= 1);
    }
    return components.front().acceleration;
  } catch (const Error& error) {
    EXPECT_STRNE(error.what(), "");
    return {};
  }
}

TEST(NetworkRobustness, ATruncatedFileIsRefusedOrHasAllSamples) {
  for (const std::string& text : whole_files()) {
    const Eigen::VectorXd whole = samples_of(text);
    ASSERT_GT(whole.size(), 0) << text.substr(0, 60);
    for (std::size_t length = 1; length < text.size(); ++length) {
      const Eigen::VectorXd cut = samples_of(text.substr(0, length));
      ASSERT_TRUE(cut.size() == 0 || cut == whole) << text.substr(0, 60) << " cut at " << length;
    }
  }
}

TEST(NetworkRobustness, AChangedFileIsRefusedOrHasFiniteSamples) {
  const std::string pieces[] = {"-",  ".",    "E",   "e999", "nan",  "inf",  "(", "\n",
                                "\r", " ",    "\t",  "9",    "****", "-999", ")", "99999999",
                                "0",  "\x1a", "(8f", "\xff", "/&",   "=",    ":"};
  std::mt19937 draw(7);
  for (const std::string& text : whole_files())
    for (int round = 0; round < 3000; ++round) {
      std::string changed = text;
      for (auto changes = draw() % 3 + 1; changes > 0; --changes)
        changed.replace(draw() % changed.size(), draw() % 4, pieces[draw() % std::size(pieces)]);
      samples_of(changed);
    }
}

}  // namespace
}  // namespace gurney
