#include "studies/page/page.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "studies/analysis/fragility_result.h"
#include "studies/page/study_page.h"
#include "studies/results/results_file.h"
#include "studies/results/stored_predictability.h"
#include "tests/studies/analysis/synthetic_runs.h"
#include "tests/studies/page/balanced.h"
#include "tests/studies/page/large_study.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/synthetic_study.h"
#include "tests/support/temp_folder.h"

namespace gurney::page {
namespace {

using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::json;

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  if (start == text.npos) return {};
  return text.substr(start + from.size(), text.find(to, start) - start - from.size());
}

Json cases_of(const std::string& page) {
  return Json::parse(between(page, "id=\"cases-data\">", "</script>"));
}

std::vector<double> values_of(const Json& cases, const std::string& title) {
  for (const Json& column : cases["columns"])
    if (column["title"] == title) {
      std::vector<double> values;
      for (const Json& each : column["values"])
        values.push_back(each.is_null() ? std::nan("") : each.get<double>());
      return values;
    }
  ADD_FAILURE() << "no column " << title;
  return {};
}

TEST(Page, OfAStudyIsWholeAndBalanced) {
  const TempFolder folder;
  SyntheticStudy::write(folder.file("s.h5"));
  const std::string page = results_page({.file = folder.file("s.h5")});
  EXPECT_EQ(unbalanced(page), "");
  for (const char* id : {"summary", "design", "records", "outcomes", "demands", "fragility",
                         "cases", "failures", "time-step", "methods", "assumptions", "provenance"})
    EXPECT_THAT(page, HasSubstr(fmt::format("<section id=\"{}\" ", id)));
  EXPECT_THAT(page, Not(HasSubstr("src=\"")));
  EXPECT_THAT(page, Not(HasSubstr("href=\"http")));
  EXPECT_THAT(page, HasSubstr(fmt::format("gurney replay {} {}", folder.file("s.h5"),
                                          SyntheticStudy::kFailed)));
}

TEST(Page, HasTheNumbersOfTheFile) {
  const TempFolder folder;
  SyntheticStudy::write(folder.file("s.h5"));
  const std::string page = results_page({.file = folder.file("s.h5")});
  const study::StudyData data(folder.file("s.h5"));
  const Json cases = cases_of(page);

  const auto peak = values_of(cases, "Peak displacement (m)");
  const auto runs = data.file().numbers("items/run"),
             stored = data.file().numbers("items/peak_displacement");
  ASSERT_EQ(peak.size(), data.file().runs());
  for (std::size_t row = 0; row < runs.size(); ++row)
    EXPECT_EQ(peak[static_cast<std::size_t>(runs[row])], stored[row]);
  EXPECT_TRUE(std::isnan(peak[SyntheticStudy::kFailed]));

  const study::FragilityResult fit = fragility_of(data, {.state = 0, .configuration = 1});
  EXPECT_THAT(page, HasSubstr(fmt::format("data-value=\"{}\"", fit.curve()->theta)));
  EXPECT_THAT(page, HasSubstr(fmt::format("data-value=\"{}\"", fit.curve()->beta)));
}

TEST(Page, CautionsOfRangesThatWereNotDrawn) {
  const TempFolder folder;
  SyntheticStudy::write(folder.file("s.h5"));
  const std::string page = results_page({.file = folder.file("s.h5")});
  EXPECT_THAT(page, HasSubstr("1 parameter with a range kept its value, so that this uncertainty"));
  EXPECT_THAT(between(page, "Uncertainties not propagated", "</section>"),
              HasSubstr("bed.toml: chassis.mass_kg"));
  study::SyntheticRuns all_drawn{
      .job = study::synthetic_job(), .records = {"a", "b"}, .files = {}, .runs = {}};
  for (std::size_t record = 0; record < 2; ++record)
    all_drawn.runs.push_back({.record = record, .level = 1, .displacement = 0.1});
  all_drawn.write(folder.file("d.h5"));
  const std::string without = results_page({.file = folder.file("d.h5")});
  EXPECT_THAT(without, Not(HasSubstr("with a range kept")));
  EXPECT_THAT(without, Not(HasSubstr("Uncertainties not propagated")));
}

TEST(Page, TakesOtherLimitStates) {
  const TempFolder folder;
  SyntheticStudy::write(folder.file("s.h5"));
  const std::string page =
      results_page({.file = folder.file("s.h5"),
                    .assessed_by = {.limit_states = {"far = peak_displacement > 1 cm"}}});
  EXPECT_THAT(page, HasSubstr("Limit state far"));
  EXPECT_THAT(page, Not(HasSubstr("Limit state moved")));
}

TEST(Page, ShowsHostileNamesAsText) {
  const TempFolder folder;
  const std::string hostile = "</script><img src=x onerror=alert(1)>'\"\u65e5{{script}}";
  study::SyntheticRuns study{
      .job = study::synthetic_job(), .records = {hostile, "<b>r"}, .files = {}, .runs = {}};
  for (std::size_t record = 0; record < 2; ++record)
    for (const double level : {1.0, 2.0})
      study.runs.push_back({.record = record, .level = level, .displacement = 0.1 * level});
  study.write(folder.file("s.h5"));
  const std::string page = results_page({.file = folder.file("s.h5")});
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("&lt;/script&gt;&lt;img src=x"));
  const Json cases = cases_of(page);
  for (const Json& column : cases["columns"])
    if (column["title"] == "Record") {
      EXPECT_EQ(column["texts"][0], hostile);
    }
}

/// 100,000 runs: the page is below 20 MB, and has all of them.
TEST(Page, OfManyRunsStaysSmall) {
  const TempFolder folder;
  large_study().write(folder.file("s.h5"));
  const std::string page = results_page({.file = folder.file("s.h5")});
  EXPECT_LT(page.size(), 20'000'000);
  EXPECT_EQ(values_of(cases_of(page), "Run").size(), 100'000);
  EXPECT_THAT(page, HasSubstr("one in 67 is drawn"));  // 100,000 of 1,500 marks
}

TEST(Page, OfOneRunBeginsWithItsVerdictAndNarrative) {
  const TempFolder folder;
  Response response = synthetic_response();
  response.items[0].demands.time_of_overturning = -1;
  response.items[0].demands.direction_of_overturning = std::nan("");
  response.items[0].predictability = Predictability{.verdict = Predictability::Verdict::kChaotic,
                                                    .amplification = 1e9,
                                                    .amplification_at_peaks = 1e8,
                                                    .time_of_peaks = 12.5,
                                                    .twin = {},
                                                    .half_step = {}};
  folder.write("r.h5", study::results_image(synthetic_facts(), response));
  explanation::Explanation explained;
  explained.failed = true;  // nothing but the narrative
  findings::Section narrative;
  narrative.say("It moved <far>.").list("", "Impacts: 1", {"wall"});
  const std::string page =
      results_page({.file = folder.file("r.h5"), .explanation = explained, .narrative = narrative});
  EXPECT_EQ(unbalanced(page), "");
  const std::string summary = between(page, "<section id=\"summary\"", "</section>");
  const auto at = [&](const std::string& text) { return summary.find(text); };
  ASSERT_NE(at("class=\"cautions\""), summary.npos);
  EXPECT_LT(at("CHAOTIC: a change of mass by one part in a billion"), at("It moved &lt;far&gt;."));
  EXPECT_LT(at("It moved &lt;far&gt;."), at("<table"));
  EXPECT_THAT(summary, HasSubstr("<li>wall</li>"));
  // The order of gurney run, without what the item does not have.
  EXPECT_LT(at("Peak velocity"), at("Path length"));
  EXPECT_EQ(at("Direction of overturning"), summary.npos);
  response.items[0].predictability->verdict = Predictability::Verdict::kPredictable;
  folder.write("p.h5", study::results_image(synthetic_facts(), response));
  EXPECT_THAT(results_page({.file = folder.file("p.h5")}), Not(HasSubstr("CHAOTIC")));
}

/// What one of two items does not have is settled to nothing.
TEST(Page, SettlesOnlyWhatIsThere) {
  const TempFolder folder;
  study::RunFacts facts = synthetic_facts();
  Response response = synthetic_response();
  facts.scene.items.push_back(facts.scene.items[0]);
  facts.scene.items[1].name = "other";
  response.items.push_back(response.items[0]);
  response.items[0].demands.time_of_overturning = 5;
  response.items[1].demands.time_of_overturning = -1;
  for (ItemResponse& item : response.items)
    item.predictability = Predictability{.twin = item.demands, .half_step = item.demands};
  folder.write("r.h5", study::results_image(facts, response));
  const std::string page = results_page({.file = folder.file("r.h5")});
  const std::string summary = between(page, "<section id=\"summary\"", "</section>");
  const std::string row = between(summary, "Time of overturning (s)", "</tr>");
  const auto first = row.find(" %<");
  ASSERT_NE(first, row.npos) << row;
  EXPECT_EQ(row.find(" %<", first + 1), row.npos) << row;
}

/// The number of the file, not another one from other samples.
TEST(StoredPredictability, IsThatOfTheFile) {
  const TempFolder folder;
  Response response = synthetic_response();
  response.items[0].predictability = Predictability{.verdict = Predictability::Verdict::kSensitive,
                                                    .amplification = 9e3,
                                                    .amplification_at_peaks = 7.3e3,
                                                    .time_of_peaks = 12.5,
                                                    .horizon = 11,
                                                    .twin = {},
                                                    .half_step = {}};
  folder.write("r.h5", study::results_image(synthetic_facts(), response));
  const auto stored = study::stored_predictability(study::Hdf5Reader(folder.file("r.h5")));
  ASSERT_EQ(stored.size(), 1u);
  const Predictability& found = stored.front().second;
  EXPECT_EQ(found.verdict, Predictability::Verdict::kSensitive);
  EXPECT_EQ(found.amplification_at_peaks, 7.3e3);
  EXPECT_EQ(found.time_of_peaks, 12.5);
  EXPECT_EQ(found.horizon, 11);
}

TEST(Page, OfOneRunHasItsDemands) {
  const TempFolder folder;
  const Response response = synthetic_response();
  folder.write("r.h5", study::results_image(synthetic_facts(), response));
  const std::string page = results_page({.file = folder.file("r.h5")});
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_THAT(page, HasSubstr(fmt::format("data-value=\"{}\"",
                                          response.items[0].demands.peak_displacement)));
  EXPECT_THAT(page, HasSubstr("<section id=\"histories\""));
}

}  // namespace
}  // namespace gurney::page
