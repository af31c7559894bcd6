#include "studies/cli/json_errors.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "studies/render/render.h"

namespace gurney::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMegabyte = 1 << 20;

Json json_errors(const std::string& text) {
  findings::Section errors;
  add_errors(errors, text);
  return Json::parse(render::json(errors)).value("errors", Json::array());
}

Json error_of(const std::string& line) {
  const Json errors = json_errors(line);
  EXPECT_EQ(errors.size(), 1u) << line;
  return errors.at(0);
}

TEST(JsonErrors, HavePlaceAndKeyOfALine) {
  const Json error = error_of("my job.toml:12:3: item.mass_kg = -1: must be above 0");
  EXPECT_EQ(error["file"], "my job.toml");
  EXPECT_EQ(error["line"], 12);
  EXPECT_EQ(error["column"], 3);
  EXPECT_EQ(error["key"], "item.mass_kg");
  EXPECT_EQ(error["message"], "item.mass_kg = -1: must be above 0");
  EXPECT_EQ(error_of("list.csv:7: no file")["line"], 7);
  EXPECT_TRUE(error_of("list.csv:7: no file")["column"].is_null());
  const Json pointer = error_of("job.json:/item/mass_kg: item.mass_kg: must be a number");
  EXPECT_EQ(pointer["file"], "job.json");
  EXPECT_EQ(pointer["pointer"], "/item/mass_kg");
  EXPECT_EQ(pointer["key"], "item.mass_kg");
  EXPECT_EQ(error_of("out/a.h5: no such file")["file"], "out/a.h5");
  EXPECT_EQ(error_of("out/a.h5: no such file")["message"], "no such file");
}

TEST(JsonErrors, WithoutAPlaceAreMessages) {
  for (const char* line : {"", ":", ": ", "--time x: must be a time", "no equipment 'x'", "a: b"}) {
    if (*line == '\0') continue;
    EXPECT_TRUE(error_of(line)["file"].is_null()) << line;
    EXPECT_EQ(error_of(line)["message"], line);
  }
  EXPECT_TRUE(json_errors("").empty());
  EXPECT_EQ(json_errors("a.toml: b\nc.toml: d").size(), 2u);
}

TEST(JsonErrors, TakeNumbersThatAreNoLinesAsText) {
  const Json error = error_of("a.toml:99999999999:1: b");
  EXPECT_EQ(error["file"], "a.toml:99999999999");
  EXPECT_EQ(error["line"], 1);
  EXPECT_TRUE(error_of("a:99999999999: b")["line"].is_null());
}

TEST(JsonErrors, StandMessagesOfAMegabyte) {
  const std::string name(kMegabyte, 'a');
  std::string colons;
  while (colons.size() < kMegabyte) colons += ":12";
  for (const std::string& line :
       {name, name + ".toml: no such file", "a.toml:1:2: " + name + " = 1: unknown key",
        "a.json:/" + name + ": x", name + ":1:2: x", colons, "a.json:" + colons + ": x",
        std::string(kMegabyte, ' '), std::string(kMegabyte, '\x1b')}) {
    const Json error = error_of(line);
    EXPECT_LT(error["message"].get<std::string>().size(), 4100u);
    EXPECT_FALSE(error.dump().empty());
  }
  EXPECT_EQ(error_of("a.toml:1:2: " + name + " = 1: x")["key"].get<std::string>(), name);
}

TEST(JsonErrors, AreJsonWhateverBytesTheyQuote) {
  EXPECT_EQ(error_of("a.toml:1:2: \xff\x1b")["message"], "\\xff\\x1b");
  EXPECT_EQ(error_of("\xc3")["message"], "\\xc3");
}

}  // namespace
}  // namespace gurney::cli
