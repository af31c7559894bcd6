#include <gmock/gmock.h>

#include <cmath>

#include "groundmotions/formats/format.h"
#include "groundmotions/normal_draw.h"
#include "tests/support/error_text.h"

/// Damaged files give an Error or a record of finite numbers; never a crash, a hang or an empty
/// record.
namespace gurney {
namespace {

const std::string kAt2 =
    "PEER NGA STRONG MOTION DATABASE RECORD\r\n"
    "Nowhere-01, 1/2/2003, Some Station, 228\r\n"
    "ACCELERATION TIME SERIES IN UNITS OF G\r\n"
    "NPTS=   5, DT=   .0200 SEC\r\n"
    "   .1000000E+00-.2000000E+00   .3000000E+00\r\n"
    "  -.4000000E+00   .5000000E-01\r\n";
const std::string kCsv =
    "# comment\ntime_s, x_m_per_s2, y_g, z_cm_per_s2\n0,1.5,0.1,10\n0.01,-2,0.2,20\n"
    "0.02,+.5,0.3,-3e1\n";
const std::string kPlain = "# comment\n.1\n-.2\n.3\n";

void expect_error_or_record(const std::string& text) {
  try {
    const auto components =
        read_components(SourceFile("f", text), {.unit = "g", .time_step = 0.02});
    ASSERT_FALSE(components.empty());
    for (const Component& component : components) {
      ASSERT_GE(component.acceleration.size(), 2);
      ASSERT_TRUE(component.acceleration.allFinite());
      ASSERT_TRUE(component.time_step > 0 && component.time_step <= 1);
    }
  } catch (const Error& error) {
    ASSERT_STRNE(error.what(), "");
  }
}

/// A whole number in [0, n), from the same generator as everything else.
std::size_t draw(std::uint64_t index, std::size_t n) {
  const double uniform = std::erfc(-normal_draw(5, 0, index) / std::sqrt(2)) / 2;
  return std::min(static_cast<std::size_t>(uniform * static_cast<double>(n)), n - 1);
}

TEST(Robustness, EveryTruncationIsAnErrorOrARecord) {
  for (const std::string& text : {kAt2, kCsv, kPlain})
    for (std::size_t length = 0; length <= text.size(); ++length)
      expect_error_or_record(text.substr(0, length));
}

TEST(Robustness, EveryChangeIsAnErrorOrARecord) {
  const std::string pieces[] = {"-",     ".",   "E",     "e999", "nan", "inf", ",",
                                "\n",    "\r",  " ",     "\t",   "9",   "0x",  "#",
                                "NPTS=", "DT=", "UNITS", "\xff", "\x1a"};
  std::uint64_t index = 0;
  for (const std::string& text : {kAt2, kCsv, kPlain})
    for (int round = 0; round < 5000; ++round) {
      std::string changed = text;
      for (std::size_t i = draw(index++, 3) + 1; i-- > 0;) {
        const std::size_t at = draw(index++, changed.size());
        const std::string& piece = pieces[draw(index++, std::size(pieces))];
        changed.replace(at, draw(index++, 4), piece);
      }
      expect_error_or_record(changed);
    }
}

TEST(Robustness, BinaryAndStrangeFilesAreErrors) {
  std::string binary;
  for (int i = 0; i < 4096; ++i)
    binary += static_cast<char>(draw(static_cast<std::uint64_t>(i), 256));
  for (const std::string& text :
       {binary,
        std::string("\xff\xfe"
                    "1\0"
                    "2\0",
                    6),
        std::string(100000, ' '), std::string(100000, '\n'), std::string("\xef\xbb\xbf"),
        std::string(1000000, '-'), std::string("{\"x\": [1, 2]}"), std::string("<html></html>")})
    EXPECT_NE(error_text([&] {
                read_components(SourceFile("f", text), {.unit = "g", .time_step = 0.02});
              }),
              "")
        << text.substr(0, 20);
}

}  // namespace
}  // namespace gurney
