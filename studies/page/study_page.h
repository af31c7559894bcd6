#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/analysis/fragility_result.h"
#include "studies/analysis/overview.h"
#include "studies/analysis/stored_histories.h"
#include "studies/page/document.h"
#include "studies/page/job_scene.h"
#include "studies/page/page.h"
#include "studies/report/sensitivity_report.h"

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
  std::optional<JobScene> scene;  ///< of the first configuration
  std::string no_scene;           ///< why there is none
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
Section study_demands(const StudyPage& page);
Section study_sensitivity(const StudyPage& page);
Section study_zones(const StudyPage& page);
Section study_cases(const StudyPage& page);
Section study_failures(const StudyPage& page);
Section study_time_step(const StudyPage& page);
Section study_records(const StudyPage& page);
Section study_methods(const StudyPage& page);

// Of studies and of single runs.
Section assumptions_section(const study::FileOverview& file,
                            const std::optional<study::UndrawnRanges>& undrawn);
Section provenance_section(const study::FileOverview& file, const std::string& job_text,
                           const Html& more);

/// Sentences for the methods of a paper, and the publications that they name.
struct Methods {
  std::vector<std::string> sentences, sources;
};
Methods methods_of(const StudyPage& page);

/// Curves of the limit states that have one.
Html figure_of_curves(const StudyPage& page);

/// The scene from above, unless it is one item on a bare floor, and a drawing of each kind of item.
Html scene_drawings(const JobScene& scene, const std::string& title,
                    const study::UnitSystem& units);

}  // namespace gurney::page
