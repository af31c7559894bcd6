#include "groundmotions/formats/fortran_fields.h"

#include <gmock/gmock.h>

#include <cmath>

#include "engine/base/error.h"
#include "tests/support/error_text.h"

namespace gurney::groundmotions {
namespace {

using testing::ElementsAre;

std::vector<double> read(const std::string& text, const char* format, std::size_t count,
                         EmptyField empty = EmptyField::kError) {
  const SourceFile file("f", text);
  FileErrors errors(file);
  std::size_t line = 0;
  const auto values =
      FieldReader(file, errors).read(line, count, fortran_format(format).value(), empty, "samples");
  errors.throw_if_any();
  EXPECT_EQ(line, file.lines().size());
  return values;
}

// The last line lost the end of its last number, whether or not a line end was put behind it.
TEST(FieldReader, SeesThatTheLastFieldIsShort) {
  for (const std::string end : {"", "\n"}) {
    EXPECT_THAT(read("  12  34\n -56  78" + end, "2I4", 4), ElementsAre(12, 34, -56, 78));
    EXPECT_EQ(error_text([&] { read("  12  34\n -56  7" + end, "2I4", 4); }),
              "f:2:5: '  7' is not a number of the format 2I4")
        << end;
  }
  // Numbers that are not in their columns from the start are read by their blanks.
  EXPECT_THAT(read("12 34\n -56  7\n", "2I4", 4), ElementsAre(12, 34, -56, 7));
}

TEST(FortranFormat, ReadsSpellings) {
  for (const char* spelling : {"8F10.3", "(8f10.3)", "( 8 F10.3 )"}) {
    const auto format = fortran_format(spelling);
    ASSERT_TRUE(format) << spelling;
    EXPECT_EQ(format->per_line, 8u);
    EXPECT_EQ(format->width, 10u);
    EXPECT_EQ(format->kind, 'F');
    EXPECT_EQ(format->skip, 0u);
    EXPECT_EQ(format->text, "8F10.3");
  }
  EXPECT_EQ(fortran_format("16I5")->kind, 'I');
  EXPECT_EQ(fortran_format("1P5E14.7")->kind, 'E');
  EXPECT_EQ(fortran_format("1P,5E14.7")->per_line, 5u);
  EXPECT_EQ(fortran_format("1X,10F7.3")->skip, 1u);
  EXPECT_EQ(fortran_format("F10.3")->per_line, 1u);
  for (const char* wrong : {"", "()", "8F", "8X10", "F10.", "0F10.3", "(2(F8.3,F9.6))", "8F10.3,I5",
                            "8F999.3", "99999999999999999999F10.3", "1X,", "-8F10.3"})
    EXPECT_FALSE(fortran_format(wrong)) << wrong;
}

TEST(FortranFields, ReadsNumbersThatStickTogether) {
  EXPECT_THAT(read("   9012001\n    3\n", "2I5", 3), ElementsAre(90, 12001, 3));
  EXPECT_THAT(read("-10.00000-11.00000\n", "2F9.5", 2), ElementsAre(-10, -11));
  EXPECT_THAT(read("1.2345E+001.2345E+01\r\n", "2E10.4", 2), ElementsAre(1.2345, 12.345));
  EXPECT_THAT(read(" 1.5E 00 1.5D+01 1.5-101\n", "3E8.1", 3), ElementsAre(1.5, 15, 1.5e-101));
  EXPECT_THAT(read("    .034100.005\n", "1X,2F7.3", 2), ElementsAre(0.034, 100.005));
}

TEST(FortranFields, ReadsALineByItsBlanksIfItDoesNotFit) {
  EXPECT_THAT(read("1.5 -2.5 3.5\n", "3F10.3", 3), ElementsAre(1.5, -2.5, 3.5));
  EXPECT_EQ(error_text([] { read("1.5 -2.5\n", "3F10.3", 3); }),
            "f:1:1: '1.5 -2.5' is not a number of the format 3F10.3");
}

TEST(FortranFields, RefusesWhatIsNoNumber) {
  const auto error = [](const std::string& text) {
    return error_text([&] { read(text, "2F6.2", 2); });
  };
  EXPECT_EQ(error("  1.00   nan\n"), "f:1:7: '   nan' is not a number of the format 2F6.2");
  EXPECT_EQ(error("  1.00******\n"), "f:1:7: '******' is not a number of the format 2F6.2");
  EXPECT_EQ(error("  1.00      \n"), "f:1:7: '      ' is not a number of the format 2F6.2");
  EXPECT_EQ(error("  1.00  2.00  3.00\n"), "f:1:13: '3.00' follows the 2 numbers of this line");
  // Parts of numbers, as columns of another width have them.
  EXPECT_EQ(error("   1.2345678\n"), "f:1:7: '345678' is not a number of the format 2F6.2");
  EXPECT_EQ(error("    123.0000\n"), "f:1:1: '    12' is not a number of the format 2F6.2");
}

TEST(FortranFields, RefusesAFileThatEndsEarly) {
  EXPECT_EQ(error_text([] { read("  1.00  2.00\n", "2F6.2", 3); }),
            "f:1:1: the file ends after 2 of 3 samples");
  EXPECT_EQ(error_text([] { read("  1.00  2.0", "2F6.2", 2); }),
            "f:1:7: '  2.0' is not a number of the format 2F6.2");
}

TEST(FortranFields, TakesEmptyFieldsOfAHeaderAsZero) {
  const auto values = read("    1     *****\n    4\n", "3I5", 4, EmptyField::kZero);
  EXPECT_EQ(values[0], 1);
  EXPECT_EQ(values[1], 0);
  EXPECT_TRUE(std::isnan(values[2]));
  EXPECT_EQ(values[3], 4);
  EXPECT_THAT(read("   500  .250\n", "2F6.3", 2, EmptyField::kZero), ElementsAre(500, 0.25));
}

}  // namespace
}  // namespace gurney::groundmotions
