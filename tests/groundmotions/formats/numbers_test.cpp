#include "groundmotions/formats/numbers.h"

#include <gmock/gmock.h>

#include "tests/support/error_text.h"

namespace gurney {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> read(const std::string& text) {
  const SourceFile file("f", text);
  Mistakes mistakes("f");
  NumberReader reader(file, mistakes);
  for (std::size_t i = 0; i < file.lines().size(); ++i) reader.read_line(i);
  reader.check_end();
  mistakes.throw_if_any();
  return reader.values();
}

TEST(Number, TakesDecimalsAndNothingElse) {
  EXPECT_EQ(number(" +1.5e3 "), 1500);
  EXPECT_EQ(number("-.25"), -0.25);
  EXPECT_EQ(number("3."), 3);
  for (const char* text : {"", "-", "+-1", "--1", "nan", "inf", "-Infinity", "0x10", "1,5", "1e999",
                           "1e", "1 2", "****"})
    EXPECT_FALSE(number(text)) << text;
}

TEST(NumberReader, ReadsNumbersApartByBlanksTabsOrTheirSigns) {
  EXPECT_THAT(read("  .1E-01\t-0.2 3\n"), ElementsAre(0.01, -0.2, 3));
  EXPECT_THAT(read(".123E-01-.456E-02+.5\n"), ElementsAre(0.0123, -0.00456, 0.5));
  EXPECT_THAT(read("-0.00128-0.00343\n"), ElementsAre(-0.00128, -0.00343));
}

TEST(NumberReader, ReadsExponentsThatLostTheirLetter) {
  EXPECT_THAT(read(".5-103 .5+101-.25-100\n"), ElementsAre(.5e-103, .5e101, -.25e-100));
}

TEST(NumberReader, NamesThePlaceOfEachMistake) {
  EXPECT_EQ(error_text([] { read("1.0 nan\n 2.0 abc 1.0\n"); }),
            "f:1:5: 'nan' is not a finite number\nf:2:6: 'abc' is not a finite number");
  EXPECT_EQ(error_text([] { read("1.0 2.0.5\n"); }), "f:1:5: '2.0.5' is not a finite number");
  EXPECT_EQ(error_text([] { read("0.5-1\n"); }), "f:1:4: '0.5-1' is not a finite number");
  EXPECT_EQ(error_text([] { read(".1E-01-.2E\n"); }), "f:1:7: '.1E-01-.2E' is not a finite number");
}

TEST(NumberReader, TellsTwentyMistakesAndCountsTheRest) {
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
}  // namespace gurney
