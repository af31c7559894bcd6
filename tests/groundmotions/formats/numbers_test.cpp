#include "groundmotions/formats/numbers.h"

#include <gmock/gmock.h>

#include <limits>

#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> read(const std::string& text) {
  const SourceFile file("f", text);
  FileErrors errors(file);
  NumberReader reader(file, errors);
  for (std::size_t i = 0; i < file.lines().size(); ++i) reader.read_line(i);
  reader.check_end();
  errors.throw_if_any();
  return reader.values();
}

TEST(Number, TakesDecimalsAndNothingElse) {
  EXPECT_EQ(number(" +1.5e3 "), 1500);
  EXPECT_EQ(number("-.25"), -0.25);
  EXPECT_EQ(number("3."), 3);
  EXPECT_EQ(number("1.5D+03"), 1500);
  EXPECT_EQ(number("-.25d-1"), -0.025);
  EXPECT_EQ(number("2D2"), 200);
  EXPECT_EQ(number("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(number("0.0e-999"), 0);
  for (const char* text :
       {"1D",  "1.5D+",     "1e5D3", "1D999", "1DT",   "",       "-",      "+-1", "--1", "nan",
        "inf", "-Infinity", "0x10",  "1,5",   "1e999", "1e-400", "1D-999", "1e",  "1 2", "****"})
    EXPECT_FALSE(number(text)) << text;
}

TEST(NumberReader, ReadsNumbersApartByBlanksTabsOrTheirSigns) {
  EXPECT_THAT(read("  .1E-01\t-0.2 3\n"), ElementsAre(0.01, -0.2, 3));
  EXPECT_THAT(read(".123E-01-.456E-02+.5\n"), ElementsAre(0.0123, -0.00456, 0.5));
  EXPECT_THAT(read("-0.00128-0.00343\n"), ElementsAre(-0.00128, -0.00343));
}

TEST(NumberReader, ReadsExponentsOfFortran) {
  EXPECT_THAT(read("  .1D-01\t-0.2d+1 0.123D-01-0.456D-02\n"),
              ElementsAre(0.01, -2, 0.0123, -0.00456));
}

// The last number of a file whose columns are flush right may have lost its last digits.
TEST(NumberReader, SeesThatTheLastNumberOfFlushColumnsWasCut) {
  const std::string rows = "   12   345     6\n -123     4    56\n";
  EXPECT_THAT(read(rows + "    1   -25"), ElementsAre(12, 345, 6, -123, 4, 56, 1, -25));
  EXPECT_THAT(error_text([&] { read(rows + "    1   -2"); }),
              HasSubstr("f:3:10: the file ends within a line and its last number ends left of its "
                        "column: the file seems to be cut"));
  EXPECT_THAT(error_text([&] { read("   12   345     6\n   1"); }),
              HasSubstr("ends left of its column"));
  // Numbers written without columns may end anywhere.
  for (const char* text : {"10\n20\n5", "1 22 333\n4", "100 200\n300 4"})
    EXPECT_EQ(error_text([&] { read(text); }), "(no error)") << text;
}

TEST(NumberReader, ReadsExponentsThatLostTheirLetter) {
  EXPECT_THAT(read(".5-103 .5+101-.25-100\n"), ElementsAre(.5e-103, .5e101, -.25e-100));
}

TEST(NumberReader, NamesThePlaceOfEachError) {
  EXPECT_EQ(error_text([] { read("1.0 nan\n 2.0 abc 1.0\n"); }),
            "f:1:5: 'nan' is not a finite number\nf:2:6: 'abc' is not a finite number");
  EXPECT_EQ(error_text([] { read("1.0 2.0.5\n"); }), "f:1:5: '2.0.5' is not a finite number");
  EXPECT_EQ(error_text([] { read("0.5-1\n"); }), "f:1:4: '0.5-1' is not a finite number");
  EXPECT_EQ(error_text([] { read(".1E-01-.2E\n"); }), "f:1:7: '.1E-01-.2E' is not a finite number");
}

TEST(NumberReader, ReportsTwentyErrorsAndCountsTheRest) {
  std::string text;
  for (int i = 0; i < 25; ++i) text += "x\n";
  EXPECT_THAT(error_text([&] { read(text); }), HasSubstr("f:20:1: 'x' is not a finite number\n"
                                                         "f: and 5 more of the kind"));
}

TEST(NumberReader, SeesThatTheLastNumberWasCut) {
  EXPECT_THAT(error_text([] { read(".123E-01 .456E-01\n.789E-01 .123E-0"); }),
              HasSubstr("f:2:16: the file ends within a line"));
  EXPECT_THAT(read(".123E-01 .456E-01\n.789E-01 .123E-02"), testing::SizeIs(4));
  EXPECT_THAT(read("0.5\n0.25\n1.5"), testing::SizeIs(3));
}

}  // namespace
}  // namespace gurney::groundmotions
