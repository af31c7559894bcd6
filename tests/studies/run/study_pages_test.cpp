#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "engine/config/table.h"
#include "studies/plan/study.h"
#include "studies/run/study_file.h"
#include "tests/studies/small_study.h"
#include "tests/support/error_text.h"
#include "tests/support/key_table.h"
#include "tests/support/page_rows.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

constexpr const char* kStudyPage = GURNEY_SOURCE_DIR "/docs/formats/study.md";

constexpr const char* kStripes = R"([study]
angles_deg = [0]
performance = ["a", "b"]
hazard = { k0 = 1, k = 2 }
[[study.factor]]
[study.factor.level.NAME]
item.brakes = true
[[study.limit_state]]
name = "a"
point = "top"
demand = "peak_displacement"
above = 1
unit = "m"
[[study.limit_state]]
name = "b"
zone = "lane"
event = "entered"
[[study.limit_state]]
name = "c"
tether = "cord"
demand = "peak_tension"
below = 1
unit = "N"
[[study.limit_state]]
name = "d"
any_of = ["a", "b"]
at_least = 2
[[study.limit_state]]
name = "e"
all_of = ["a", "b"]
[study.intensity]
measure = "PGA"
unit = "g"
levels = [1]
adaptive = { stages = 1, limit_state = "a" }
[study.keep]
)";
constexpr const char* kIda = R"([study]
draws = 2
sampling = "monte-carlo"
synthetic_records = 3
hazard = { im = [1, 2], rate_per_year = [0.1, 0.01] }
[[study.factor]]
key = "item.brakes"
values = [true]
[study.intensity]
measure = "PGA"
unit = "g"
ida = { first = 1, increment = 1, until = "overturned" }
)";

std::set<std::string> asked_keys() {
  std::set<std::string> asked;
  for (const std::string text : {kStripes, kIda, "[study]\nintensity = { scales = [1] }\n"}) {
    config::Document document(text, "a.toml");
    config::Table root = document.root();
    auto table = root.table("study");
    read_study(*table, *document.tree().find("study"));
    EXPECT_EQ(error_text([&] { document.finish(); }), "(no error)");
    for (const std::string& key : document.asked_keys())
      if (!key.starts_with("study.factor[].level.NAME.")) asked.insert(key);
  }
  return asked;
}

TEST(StudyPage, HasEveryKeyTheReaderKnowsAndNoOther) {
  const std::set<std::string> asked = asked_keys(), documented = documented_keys(kStudyPage, "");
  for (const std::string& key : asked) EXPECT_TRUE(documented.contains(key)) << key;
  for (const std::string& key : documented) EXPECT_TRUE(asked.contains(key)) << key;
}

TEST(StudyFilePage, IsWhatAFileHolds) {
  const SmallStudy study(small_job(R"(draws = 1
sampling = "saltelli"
step_check = 1
measures = ["PGA h1", "Sa(1.0) h1"]
[study.keep]
histories = "all"
wheels = true
energy = true
[[study.factor]]
name = "FACTOR"
key = "item.brakes"
values = [true]
)"));
  const TempFolder folder;
  const std::string path = folder.file("a.h5");
  write_study_file(path, study.batch, [&](std::size_t unit) { return study.run(unit); });
  const std::string formats = GURNEY_SOURCE_DIR "/docs/formats/";
  expect_as_on_page(Hdf5Reader(path), formats + "study_file.md", formats + "results_file.md");
}

using Json = nlohmann::json;

Json schema() {
  return Json::parse(contents_of(GURNEY_SOURCE_DIR "/docs/formats/job.schema.json"));
}

/// Keys of the objects that a schema allows, as the pages write them.
void collect(const Json& schema, const std::string& path, std::set<std::string>& keys) {
  for (const char* choice : {"anyOf", "allOf"})
    if (schema.contains(choice))
      for (const Json& each : schema[choice]) collect(each, path, keys);
  if (schema.contains("items") && schema["items"].contains("properties"))
    collect(schema["items"], path == "item" ? path : path + "[]", keys);
  if (!schema.contains("properties")) return;
  for (const auto& [key, value] : schema["properties"].items()) {
    const std::string name = path.empty() ? key : path + '.' + key;
    keys.insert(name);
    collect(value, name, keys);
  }
}

TEST(JobSchema, HasEveryKeyOfThePagesAndNoOther) {
  std::set<std::string> keys, documented;
  collect(schema(), "", keys);
  for (const char* page : {"job_file.md", "study.md"})
    documented.merge(documented_keys(GURNEY_SOURCE_DIR "/docs/formats/" + std::string(page), ""));
  documented.erase("item.payloads.NAME");  // additionalProperties
  documented.erase("study.factor[].level.NAME");
  for (const std::string& key : keys) EXPECT_TRUE(documented.contains(key)) << key;
  for (const std::string& key : documented) EXPECT_TRUE(keys.contains(key)) << key;
}

}  // namespace
}  // namespace gurney::study
