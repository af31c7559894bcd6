#include <gmock/gmock.h>

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "studies/analysis/overview.h"
#include "studies/exports/export.h"
#include "studies/exports/fragility_export.h"
#include "studies/statistics/capacity.h"
#include "tests/support/expect_error.h"
#include "tests/support/synthetic_study.h"
#include "tests/support/temp_folder.h"

namespace gurney::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Exports : public testing::Test {
 protected:
  Exports() {
    SyntheticStudy::write(path_);
    data_.emplace(path_);
  }

  TakeFile take() {
    return [this](const std::string& name, std::string_view bytes) { files_[name] = bytes; };
  }

  TempFolder folder_;
  std::string path_ = folder_.file("exports.h5");
  std::optional<StudyData> data_;
  std::map<std::string, std::string> files_;
};

TEST_F(Exports, NameTheNearestOfWhatTheStudyDoesNotHave) {
  EXPECT_ERROR(export_pelicun(*data_, {.configurations = {"flase"}}, take()),
               "exports.h5: no configuration 'flase'; did you mean 'false'?");
  EXPECT_ERROR(export_nrml(*data_, {.limit = "moed"}, take()),
               "no limit state 'moed'; did you mean 'moved'?");
  EXPECT_ERROR(export_nrml(*data_, {.measure = "PGA lager"}, take()),
               "no intensity measure 'PGA lager'; did you mean 'PGA larger'?");
  EXPECT_ERROR(export_responses(*data_, {.configurations = {"flase"}}, take()),
               "no configuration 'flase'");
  EXPECT_TRUE(files_.empty());
}

TEST_F(Exports, RefuseMeasuresTheFormatHasNoNameFor) {
  EXPECT_ERROR(
      export_nrml(*data_, {.measure = "pfv"}, take()),
      "NRML, which knows ground motions only, has no name for the intensity measure "
      "'pfv'; take one of these with --measure: 'PGA larger', 'Sa(1) RotD50', 'FIV3(1) geomean'");
  EXPECT_ERROR(export_pelicun(*data_, {.measure = "FIV3(1) geomean"}, take()),
               "DLML, whose names pelicun knows, has no name for the intensity measure 'FIV3(1) "
               "geomean'; take one of these with --measure: 'PGA larger', 'Sa(1) RotD50', 'pfa', "
               "'pfv'");
  // The spectra of both are those with 5 % damping.
  EXPECT_ERROR(export_pelicun(*data_, {.measure = "Sa(1, 2%) RotD50"}, take()),
               "no name for the intensity measure 'Sa(1, 2%) RotD50'");
  EXPECT_TRUE(files_.empty());
}

TEST_F(Exports, SayWhyThereIsNoCurve) {
  EXPECT_ERROR(export_pelicun(*data_, {.limit = "hit"}, take()),
               "no fragility curve over PGA larger can be fitted; nothing was written\n"
               "  false, 'hit': no run exceeds up to ");
  EXPECT_TRUE(files_.empty());
  EXPECT_THAT(
      export_nrml(*data_, {.configurations = {"true"}}, take()),
      ElementsAre(HasSubstr("true, 'rolled': "), HasSubstr("'hit'"), HasSubstr("'overturned'")));
  EXPECT_EQ(files_.size(), 1u);
}

TEST_F(Exports, WriteWhatIsChosen) {
  export_nrml(*data_, {.configurations = {"true"}}, take());
  EXPECT_THAT(files_.at("moved.xml"), HasSubstr("fragilityFunction id=\"true\""));
  EXPECT_THAT(files_.at("moved.xml"), testing::Not(HasSubstr("id=\"false\"")));
  files_.clear();
  export_responses(*data_, {.configurations = {"false"}}, take());
  EXPECT_EQ(files_.size(), 1 + SyntheticStudy::kLevels.size());
}

// Scales are 0.49 to 5.88; of `false` the failed run is one at 5.88.
TEST_F(Exports, CarryTheCautionsOfACurve) {
  export_pelicun(*data_, {.limit = "moved"}, take());
  EXPECT_THAT(files_.at("fragility.json"),
              HasSubstr("Caution: scale factors 0.49 to 5.88; 39 of 40 records above 5."));
  EXPECT_THAT(
      files_.at("fragility_cautions.csv"),
      testing::StartsWith("ID,Caution\nsynthetic.false.moved,moved: scale factors 0.49 to 5.88; "
                          "39 of 40 records above 5\n"));
  export_nrml(*data_, {.limit = "moved"}, take());
  EXPECT_THAT(files_.at("moved.xml"),
              HasSubstr("true: fitted to 240 runs with 40 records, of which "));
  EXPECT_THAT(files_.at("moved.xml"),
              HasSubstr("Caution: scale factors 0.49 to 5.88; 40 of 40 records above 5."));
}

// The rules of DLML 3.1 for a library, in our words: general information, an entry for each row and
// no other, its states those of the row, and references that are listed.
TEST_F(Exports, FollowTheRulesOfTheDamageAndLossModelLibrary) {
  export_pelicun(*data_, {}, take());
  const auto json = nlohmann::json::parse(files_.at("fragility.json"));
  const auto& general = json.at("_GeneralInformation");
  for (const char* key : {"ShortName", "Description", "Version"}) {
    EXPECT_TRUE(general.at(key).is_string()) << key;
    EXPECT_NE(general.at(key), "") << key;
  }
  EXPECT_TRUE(general.at("ComponentGroups").is_object());
  EXPECT_EQ(general.size(), 4u);
  std::istringstream rows(files_.at("fragility.csv"));
  std::string line;
  std::getline(rows, line);
  std::size_t count = 0;
  for (; std::getline(rows, line); ++count) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    EXPECT_TRUE(cells.at(1) == "0" || cells.at(1) == "1") << line;
    const auto& entry = json.at(cells.at(0));
    std::size_t states = 0;
    for (std::size_t i = 6; i < cells.size(); i += 4) {
      if (cells[i].empty()) continue;
      ++states;
      EXPECT_EQ(cells[i], "lognormal");
      EXPECT_GT(std::stod(cells.at(i + 1)), 0);
      EXPECT_GT(std::stod(cells.at(i + 2)), 0);
      const std::string number = std::to_string(states);
      const auto& state = entry.at("LimitStates").at("LS" + number).at("DS" + number);
      EXPECT_TRUE(state.at("Description").is_string());
    }
    EXPECT_EQ(entry.at("LimitStates").size(), states) << line;
    for (const char* key : {"Description", "SuggestedComponentBlockSize", "Comments"})
      EXPECT_TRUE(entry.at(key).is_string()) << key;
    EXPECT_EQ(entry.at("RoundUpToIntegerQuantity"), "True");
    for (const auto& key : entry.at("Reference")) EXPECT_TRUE(json.at("References").contains(key));
  }
  EXPECT_GT(count, 0u);
  EXPECT_EQ(json.size(), count + 2);  // and general information and references
}

TEST_F(Exports, TakeCapacitiesAfterAnIda) {
  data_.reset();  // it has the file open
  SyntheticStudy::write(path_, true, true);
  data_.emplace(path_);
  const ChosenCurves chosen = chosen_curves(*data_, {.configurations = {"true"}});
  ASSERT_EQ(chosen.curves.size(), 1u);
  const auto capacities = statistics::fit_capacities(
      statistics::ida_capacities(data_->observations(0, 1, data_->measure(""))));
  ASSERT_TRUE(capacities.curve);
  EXPECT_EQ(chosen.curves[0].curve.theta, capacities.curve->theta);
  EXPECT_EQ(chosen.curves[0].curve.beta, capacities.curve->beta);
  // The outcomes of the runs alone have another curve: the test can distinguish the two.
  const statistics::FragilityFit fit =
      statistics::fit_fragility(data_->observations(0, 1, data_->measure("")));
  EXPECT_NE(fit.curve->theta, capacities.curve->theta);

  export_responses(*data_, {}, take());  // an IDA has no levels, so no samples at one
  EXPECT_EQ(files_.size(), 2u);
  EXPECT_TRUE(files_.contains("response_false.csv") && files_.contains("response_true.csv"));
}

TEST_F(Exports, CountAnIdaInOneRowForEachConfiguration) {
  data_.reset();  // it has the file open
  SyntheticStudy::write(path_, true, true);
  const StudyOverview overview = study_overview(path_);
  ASSERT_EQ(overview.counts.size(), 2u);
  EXPECT_EQ(overview.counts[0].level, "all");
  EXPECT_EQ(overview.counts[1].runs, 240u);
}

TEST(OutsideMeasure, HasTheNamesAndUnitsOfEachFormat) {
  const auto nrml = nrml_measure("PGV RotD50");
  ASSERT_TRUE(nrml);
  EXPECT_EQ(nrml->name, "PGV");
  EXPECT_EQ(nrml->unit, "cm/s");
  EXPECT_EQ(nrml->unit_in_si, 0.01);
  EXPECT_EQ(nrml_measure("Sa(0.25) geomean")->name, "SA(0.25)");
  EXPECT_FALSE(nrml_measure("Sa(0) geomean"));
  EXPECT_FALSE(nrml_measure("PFA larger"));
  EXPECT_EQ(nrml_measure("FIV3(1) geomean")->name, "FIV3(1.0)");
  EXPECT_EQ(nrml_measure("FIV3(1) geomean")->unit_in_si, 0.01);
  EXPECT_EQ(nrml_measure("CAV larger")->name, "CAV");
  EXPECT_EQ(nrml_measure("CAV larger")->unit_in_si, 9.80665);  // of g s
  EXPECT_EQ(nrml_measure("Arias larger")->name, "IA");
  EXPECT_EQ(nrml_measure("D5-95 larger")->name, "RSD595");
  EXPECT_EQ(nrml_measure("D5-75 larger")->name, "RSD575");
  EXPECT_EQ(nrml_measure("PGD larger")->unit, "cm");
  EXPECT_EQ(dlml_measure("PFA larger")->name, "Peak Floor Acceleration");
  EXPECT_EQ(dlml_measure("PGV larger")->unit, "mps");
  EXPECT_EQ(dlml_measure("Sa(2) geomean")->name, "Spectral Acceleration|2.0");
  EXPECT_FALSE(dlml_measure("PGD larger"));
}

TEST(ExportText, IsQuotedAndPlain) {
  EXPECT_EQ(csv_cell("a, \"b\""), "\"a, \"\"b\"\"\"");
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell(0.1), "0.1");
  EXPECT_EQ(csv_cell(std::numeric_limits<double>::quiet_NaN()), "");
  EXPECT_EQ(csv_line({"", "a"}), ",a\n");
  EXPECT_EQ(plain_identifier("half-locked, floor 4", "x"), "half_locked_floor_4");
  EXPECT_EQ(plain_identifier("-", "x"), "x");
}

}  // namespace
}  // namespace gurney::study
