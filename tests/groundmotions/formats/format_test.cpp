#include "groundmotions/formats/format.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "tests/groundmotions/formats/format_samples.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string error(const std::string& bytes, const ReadOptions& options) {
  return error_text([&] { read_components(SourceFile("f", bytes), options); });
}

TEST(Formats, RefuseOptionsThatAreOfNoUse) {
  for (const FormatSample& sample : format_samples()) {
    SCOPED_TRACE(sample.format);
    const auto format = std::ranges::find(formats(), sample.format, &Format::name);
    ASSERT_NE(format, formats().end());
    ReadOptions options = sample.options;
    options.columns = "samples";
    const auto columns = HasSubstr(
        "f: columns = \"samples\" was given, but the layout of this file "
        "is known");
    EXPECT_EQ(testing::Value(error(sample.bytes, options), columns), !format->takes_columns);
    options = sample.options;
    options.si_per_count = 2;
    const auto counts = StartsWith(
        "f: count_m_per_s2 = 2 was given, but the file does not hold raw "
        "counts");
    EXPECT_EQ(testing::Value(error(sample.bytes, options), counts), !format->takes_counts);
    if (!format->takes_counts) continue;
    options.unit = "g";
    EXPECT_THAT(error(sample.bytes, options),
                StartsWith("f: unit and count_m_per_s2 were both given; one of them is allowed"));
  }
}

TEST(Formats, RefuseOptionsThatAreWrongForEveryFile) {
  for (const double wrong : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(error("1\n2\n", {.time_step = 0.01, .si_per_count = wrong}),
                StartsWith("count_m_per_s2 must be positive and finite, got "));
    EXPECT_THAT(error("1\n2\n", {.unit = "g", .time_step = wrong}),
                StartsWith("the time step of a record must be in [1e-05, 1] s, got "));
  }
  EXPECT_THAT(error("1\n2\n", {.unit = "gg"}), StartsWith("'gg' is not a unit of acceleration"));
}

TEST(Formats, TellWhatIsNoRecord) {
  EXPECT_EQ(
      error("Dear \xf3ne,\tall\n", {}),
      "f:1:1: not a record in a known format (see docs/records.md): 1 line of text, 14 bytes");
}

}  // namespace
}  // namespace gurney::groundmotions
