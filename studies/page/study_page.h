#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"
#include "studies/analysis/overview.h"
#include "studies/analysis/stored_histories.h"
#include "studies/analysis/study_data.h"
#include "studies/loss/consequences.h"
#include "studies/loss/study_loss.h"
#include "studies/page/html.h"
#include "studies/page/page.h"
#include "studies/report/study_report.h"

namespace gurney::page {

/// What the page of a study is made of. Every number is that of the commands show, fragility and
/// sensitivity.
struct StudyPage {
  explicit StudyPage(const PageRequest& request);

  std::string path, job;   ///< job: path of its file; empty: not known
  std::string unfinished;  ///< as in PageRequest
  study::StudyOverview overview;
  study::StudyData data;
  std::vector<study::FragilityResult> fragilities;  ///< states of a configuration together
  std::vector<report::SensitivityReport> sensitivities;
  std::optional<study::Consequences> consequences;
  std::vector<study::StudyLoss> losses;  ///< one for each configuration; empty: not asked for
  std::optional<JobScene> scene;         ///< of the first configuration
  std::string no_scene;                  ///< why there is none
};

/// Width of a figure that stands beside others [px].
inline constexpr double kNarrow = 430;

/// What a page draws of a study at most; it says so where there is more.
inline constexpr std::size_t kMaxConfigurations = 6, kMaxItems = 4, kMaxMarks = 1500;

// The sections of a study's page, in this order.
Section study_summary(const StudyPage& page);
Section study_design(const StudyPage& page);
Section study_outcomes(const StudyPage& page);
Section study_fragility(const StudyPage& page);
Section study_loss(const StudyPage& page);
Section study_demands(const StudyPage& page);
Section study_sensitivity(const StudyPage& page);
Section study_zones(const StudyPage& page);
Section study_cases(const StudyPage& page);
Section study_failures(const StudyPage& page);
Section study_time_step(const StudyPage& page);
Section study_records(const StudyPage& page);
Section study_methods(const StudyPage& page);

// Sections of studies and of single runs.
Section assumptions_section(const study::FileOverview& file,
                            const std::optional<study::UndrawnRanges>& undrawn);
Section provenance_section(const study::FileOverview& file, const std::string& job_text,
                           const Html& more);

/// The scene from above, unless it is one item on a bare floor, and a drawing of each kind of item.
Html scene_drawings(const JobScene& scene, const std::string& title,
                    const study::UnitSystem& units);

/// The page of the results file of one run.
Document run_document(const PageRequest& request);

/// A column of the table of all runs: numbers, or indices of texts.
struct CaseColumn {
  std::string title;  ///< with its unit
  study::ReportUnit unit{"1", 1};
  bool whole = false;
  std::vector<std::string> texts = {};  ///< not empty: values are their indices
  std::vector<double> values = {};      ///< SI, for each run; NaN: none
};

/// The run itself first; demands are the largest over the items. Columns with one value for all
/// runs are left out, but for the outcome.
std::vector<CaseColumn> case_columns(const study::StudyData& data);

/// The columns as JSON that may stand in a page, with each number as the file has it.
/// @param replay  the command that re-runs a case, but for its number
std::string case_json(const std::vector<CaseColumn>& columns, const std::string& replay);

}  // namespace gurney::page
