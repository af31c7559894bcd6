#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "engine/base/input_file.h"
#include "engine/base/printable.h"
#include "engine/config/table.h"
#include "engine/config/toml_depth.h"
#include "engine/config/unit_limit.h"
#include "tests/support/error_text.h"
#include "tests/support/expect_error.h"
#include "tests/support/temp_folder.h"

/// Files that would overflow the stack, block for ever, or bring numbers and texts that nothing can
/// be computed or printed with.
namespace gurney::config {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// What `finish` says after the number `key` has been read.
std::string error_of(const std::string& text, const std::string& key, const Range& range) {
  return error_text([&] {
    Document document(text, "a.toml");
    document.root().number(key, range);
    document.finish();
  });
}

TEST(Nesting, DeepFilesAreRefusedBeforeTheyAreParsed) {
  const std::string deep = "nested more than 64 deep";
  EXPECT_ERROR(Document("{\"x\":" + std::string(100000, '['), "a.json"), deep);
  EXPECT_ERROR(Document(repeated("{\"x\":", 100000), "a.json"), deep);
  EXPECT_ERROR(Document("x = " + std::string(100000, '['), "a.toml"), "a.toml:1:69: " + deep);
  EXPECT_ERROR(Document("x" + repeated(".x", 100000) + " = 1\n", "a.toml"), deep);
  EXPECT_ERROR(Document("\n[x" + repeated(".x", 100000) + "]\n", "a.toml"),
               "a.toml:2:129: " + deep);
  EXPECT_ERROR(Document("x = " + repeated("{ x.y = ", 33), "a.toml"), deep);
}

TEST(Nesting, DotsAndBracketsInTextsAndCommentsAreNone) {
  const std::string many = std::string(100, '.') + std::string(100, '[');
  const Document document("a = \"" + many + "\\\"" + many + "\"\nb = '" + many + "' # " + many +
                              "\nc = \"\"\"\n" + many + "\"\n" + many + "\"\"\"\nd = [" +
                              repeated("1.5, ", 100) + "]\n" + repeated("[[t.u]]\n", 100),
                          "a.toml");
  EXPECT_EQ(document.tree().find("c")->text, many + "\"\n" + many);
}

TEST(Nesting, SixtyFourIsDeepEnough) {
  EXPECT_FALSE(find_too_deep("x = " + std::string(64, '[') + std::string(64, ']')));
  EXPECT_TRUE(find_too_deep("x = " + std::string(65, '[') + std::string(65, ']')));
}

TEST(UnitLimits, FiniteNumbersThatNoQuantityCanBeAreRefused) {
  EXPECT_EQ(error_of("mass_kg = 1e300\n", "mass_kg", Range::positive()),
            "a.toml:1:11: mass_kg = 1e+300: must be at most 1e+09 in magnitude");
  EXPECT_EQ(error_of("width_m = 5e-324\n", "width_m", Range::positive()),
            "a.toml:1:11: width_m = 5e-324: must be at least 1e-06");
  EXPECT_EQ(error_of("at_m = 5e-324\n", "at_m", Range::any()), "(no error)");
  EXPECT_EQ(error_of("at_m = -1e16\n", "at_m", Range::any()),
            "a.toml:1:8: at_m = -1e+16: must be at most 10000 in magnitude");
  EXPECT_EQ(error_of("strength_n = inf\n", "strength_n", Range::positive().with_infinity()),
            "(no error)");
  EXPECT_EQ(error_of("mass_kg = -1\n", "mass_kg", Range::positive()),
            "a.toml:1:11: mass_kg = -1: must be a finite number > 0");
}

TEST(UnitLimits, AreThoseOfTheLastPartOfAName) {
  EXPECT_STREQ(unit_limit("item[0].mass_kg.distribution.median").ending, "_kg");
  EXPECT_STREQ(unit_limit("excitation.force[2].time_s[7]").ending, "_s");
  EXPECT_STREQ(unit_limit("stiffness_n_per_m").ending, "_n_per_m");
  EXPECT_STREQ(unit_limit("friction_rate_s_per_m").ending, "_s_per_m");
  EXPECT_STREQ(unit_limit("static_friction").ending, "friction");
  EXPECT_STREQ(unit_limit("study.intensity.levels[3]").ending, "");
}

TEST(UnitLimits, StandOnTheirPage) {
  const std::string page = contents_of(GURNEY_SOURCE_DIR "/docs/formats/limits.md");
  for (const UnitLimit& each : unit_limits()) {
    const std::string ending = each.ending;
    const std::string row =
        fmt::format("\n| {} | {:g} | {:g} |\n", ending.empty() ? "any other" : '`' + ending + '`',
                    each.smallest, each.largest);
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST(ControlCharacters, AreRefusedInTexts) {
  EXPECT_EQ(error_text([] {
              Document document("name = \"a\\u001b[2Jb\"\n", "a.toml");
              document.root().text("name");
              document.finish();
            }),
            "a.toml:1:8: name = \"a\\x1b[2Jb\": must be text without control characters");
  Document document("name = \"a\\tb\\nc\"\n", "a.toml");
  EXPECT_EQ(document.root().text("name"), "a\tb\nc");
}

TEST(ControlCharacters, AreWrittenOut) {
  EXPECT_EQ(printable("r\u00e9sum\u00e9\t1\r\n2\n"), "r\u00e9sum\u00e9\t1\r\n2\n");
  EXPECT_EQ(printable("a\x1b[31m\rb\x7f"), "a\\x1b[31m\\x0db\\x7f");
  EXPECT_EQ(printable("\xc2\x9b \xff \xe2\x82"), "\\xc2\\x9b \\xff \\xe2\\x82");
}

TEST(InputFile, OnlyRegularFilesOfASizeAreRead) {
  const TempFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_ERROR(Document{pipe}, "pipe: is a pipe or a device, not a regular file");
  EXPECT_ERROR(Document{"/dev/zero"}, "is a pipe or a device, not a regular file");
  EXPECT_ERROR(Document{folder.path()}, ": is a folder, not a file");
  EXPECT_ERROR(Document{folder.file("none")}, "none: no such file");
  const std::string ten = folder.write("ten", "0123456789");
  EXPECT_EQ(read_input_file(ten, 10), "0123456789");
  EXPECT_ERROR(read_input_file(ten, 9), "ten: has 10 bytes; must have at most 9");
  EXPECT_EQ(read_input_file(folder.write("empty", "")), "");
}

}  // namespace
}  // namespace gurney::config
