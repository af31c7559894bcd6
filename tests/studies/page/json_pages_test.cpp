#include <fmt/format.h>
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/base/error.h"
#include "studies/page/page.h"
#include "tests/studies/page/balanced.h"
#include "tests/support/temp_folder.h"

namespace gurney::page {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

const std::string kHostile = "</script><img src=x onerror=\"alert(1)\"> '&\" \u65e5\u672c";

Json check(const std::string& quantity, double error, double tolerance) {
  return {{"quantity", quantity},
          {"unit", "m"},
          {"computed", 4.9 + error},
          {"reference", 4.9},
          {"error", error},
          {"tolerance", tolerance},
          {"passed", error <= tolerance},
          {"derivation", "dt^2 |g|, " + kHostile},
          {"where", ""}};
}

Json verified(const std::string& name, const std::string& group, const Json& of) {
  return {{"name", name},
          {"group", group},
          {"title", "A stone falls"},
          {"equation", "x = g t^2 / 2"},
          {"source", "Galilei 1638"},
          {"parameters", {{"time", {{"value", 1}, {"unit", "s"}, {"lowest", 0}, {"highest", 2}}}}},
          {"passed", of["passed"]},
          {"checks", {of}},
          {"stock_bullet", {{"stock, default", {check("way", 0.3, 0.1)}}}},
          {"seconds", 0.5}};
}

Json verification() {
  return {{"schema", "gurney-verification/1"},
          {"program_version", "1"},
          {"git_commit", "abc"},
          {"compiler", "GCC"},
          {"cpu_class", kHostile},
          {"passed", false},
          {"cases",
           {verified("fall/short", "falling", check("way", 0.05, 0.1)),
            verified("fall/long", "falling", check("way", 0.2, 0.1)),
            verified("slide/" + kHostile, kHostile, check("way", 0, 0.1))}}};
}

Json calibration() {
  const std::string about = "Cr/R of " + kHostile + " on lino";
  const auto value = [&](const char* trial, const char* use, double of) {
    return Json{{"trial", trial}, {"constant", about},        {"use", use},
                {"value", of},    {"standard_error", 0.0002}, {"lower_bound", false}};
  };
  return {{"schema", "gurney-calibration/1"},
          {"program_version", "1"},
          {"git_commit", "abc"},
          {"source", kHostile},
          {"trials", 3},
          {"simulated", 1},
          {"trial_files",
           {{{"trial", "a"},
             {"file", kHostile},
             {"line", nullptr},
             {"sha256", "00ff"},
             {"kind", "pull"},
             {"use", "calibration"},
             {"origin", "measured"},
             {"caster", kHostile},
             {"floor", "lino"},
             {"against", ""},
             {"mass_kg", 98.5},
             {"excluded", kHostile}}}},
          {"constants",
           {{{"name", "rolling_resistance"},
             {"constant", about},
             {"symbol", "Cr/R"},
             {"unit", "1"},
             {"caster", kHostile},
             {"floor", "lino"},
             {"against", ""},
             {"value", 0.02},
             {"lower_bound", false},
             {"interval_95", {0.019, 0.021}},
             {"scatter_of_logarithm", 0.03},
             {"degrees", 1},
             {"prediction_95", {0, nullptr}},
             {"trials", {"a", "b"}}}}},
          {"values",
           {value("a", "calibration", 0.0206), value("b", "calibration", 0.0194),
            value("c", "validation", 0.03)}},
          {"tests", Json::array()},
          {"pulls",
           {{{"trial", "a"},
             {"caster", kHostile},
             {"floor", "lino"},
             {"normal_force_n", 966},
             {"pull_force_n", 51},
             {"pull_acceleration_mps2", 0.3},
             {"coast_deceleration_mps2", 0.2},
             {"resistance_pulled_n", 19},
             {"resistance_coasting_n", 20},
             {"resistance_n", 19.9},
             {"resistance_error_n", 0.1}}}},
          {"crosswise", Json::array()},
          {"outliers", Json::array()},
          {"validation",
           {{{"trial", "c"},
             {"constant", about},
             {"measured", 0.03},
             {"predicted", 0.02},
             {"prediction_95", {0.018, 0.022}},
             {"misfit", 0.5},
             {"inside", false}}}},
          {"validation_without_constant", Json::array()},
          {"left_out", {{{"file", kHostile}, {"line", 0}, {"reason", "units"}}}},
          {"trials_without_kinetic_friction", Json::array()},
          {"caster_files",
           {{{"file", "x.toml"},
             {"calibrated", {"tread.rolling_resistance_mm"}},
             {"text", "name = \"" + kHostile + "\""}}}},
          {"without_caster_file", {kHostile}}};
}

std::string page_of(const Json& json) {
  const TempFolder folder;
  std::ofstream(folder.file("x.json")) << json.dump(2);
  return results_page({.file = folder.file("x.json")});
}

std::string refusal_of(const std::string& text) {
  const TempFolder folder;
  std::ofstream(folder.file("x.json")) << text;
  try {
    results_page({.file = folder.file("x.json")});
  } catch (const Error& error) {
    return std::string(error.what()).substr(folder.file("").size());
  }
  return "accepted";
}

void expect_sections(const std::string& page, const std::vector<const char*>& ids) {
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("&lt;/script&gt;&lt;img src=x onerror=&quot;"));
  for (const char* id : ids) EXPECT_THAT(page, HasSubstr(fmt::format("<section id=\"{}\" ", id)));
}

TEST(VerificationPage, HasEveryCaseTheFailedOnesFirst) {
  const std::string page = page_of(verification());
  expect_sections(page, {"summary", "tolerances", "cases", "forms", "checks", "provenance"});
  EXPECT_THAT(page, HasSubstr("1 of 3 cases failed"));
  EXPECT_THAT(page, HasSubstr("Checks that failed"));
  const std::size_t cases = page.find("<section id=\"cases\"");
  EXPECT_LT(page.find("fall/long", cases), page.find("fall/short", cases));
  EXPECT_THAT(page, HasSubstr("data-value=\"200\"")) << "percent of the tolerance";
  EXPECT_THAT(page, HasSubstr("Galilei 1638"));
  Json all_passed = verification();
  all_passed["cases"].erase(1);
  all_passed["passed"] = true;
  EXPECT_THAT(page_of(all_passed), Not(HasSubstr("Checks that failed")));
}

TEST(VerificationPage, ShowsNumbersThatAreNoneAsFailed) {
  Json json = verification();
  Json& bad = json["cases"][0]["checks"][0];
  for (const char* key : {"computed", "error"}) bad[key] = nullptr;
  bad["passed"] = json["cases"][0]["passed"] = false;
  json["cases"][2]["checks"] = Json::array();
  json["cases"][2]["passed"] = false;
  const std::string page = page_of(json);
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_THAT(page, HasSubstr("3 of 3 cases failed"));
  EXPECT_THAT(page, HasSubstr("checks nothing"));
  EXPECT_THAT(page, Not(HasSubstr(">nan<")));
}

TEST(CalibrationPage, HasConstantsTrialsAndResiduals) {
  const std::string page = page_of(calibration());
  expect_sections(page,
                  {"summary", "trials", "fit", "validation", "casters", "methods", "provenance"});
  EXPECT_THAT(page, HasSubstr("SIMULATED: 1 of 3 trials"));
  EXPECT_THAT(page, HasSubstr("c, kept for validation, is outside"));
  EXPECT_THAT(page, HasSubstr("0.019 to 0.021"));
  // ln(0.0206 / 0.02) / hypot(0.03, 0.0002 / 0.0206)
  EXPECT_THAT(page, HasSubstr(">0.937<"));
  EXPECT_THAT(page, HasSubstr("id=\"loads-figure\""));
  EXPECT_THAT(page, HasSubstr("id=\"residuals-figure\""));
}

TEST(JsonPages, RefuseWhatTheyDoNotKnow) {
  EXPECT_THAT(refusal_of("{}"), HasSubstr("x.json: is JSON without a schema; a report is made of a "
                                          "results file (HDF5), of calibration.json"));
  EXPECT_THAT(refusal_of("{\"schema\": \"<b>\"}"), HasSubstr("with schema = \"<b>\""));
  EXPECT_THAT(refusal_of("{\"schema\": 3}"), HasSubstr("without a schema"));
  EXPECT_THAT(refusal_of("{\"schema\": "), HasSubstr("x.json"));
  EXPECT_THAT(refusal_of("[1]"), HasSubstr("is not a results file"));
  Json json = verification();
  json["cases"][1]["checks"][0]["error"] = "much";
  EXPECT_EQ(refusal_of(json.dump()), "x.json:/cases/1/checks/0/error: must be a number");
  json["cases"][1].erase("source");
  EXPECT_EQ(refusal_of(json.dump()), "x.json:/cases/1: lacks \"source\"");
  json = calibration();
  json["constants"][0]["interval_95"] = {1};
  EXPECT_EQ(refusal_of(json.dump()), "x.json:/constants/0/interval_95: must be two numbers");
}

}  // namespace
}  // namespace gurney::page
