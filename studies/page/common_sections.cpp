#include "studies/page/findings_html.h"
#include "studies/page/study_page.h"
#include "studies/report/overview_report.h"

namespace gurney::page {

Section assumptions_section(const study::FileOverview& file,
                            const std::optional<study::UndrawnRanges>& undrawn) {
  return {"assumptions", "Assumptions",
          html(report::assumption_findings(file)) + (undrawn && undrawn->parameters() > 0
                                                         ? html(report::undrawn_findings(undrawn))
                                                         : Html{})};
}

Section provenance_section(const study::FileOverview& file, const std::string& job_text,
                           const Html& more) {
  return {"provenance", "Provenance",
          html(report::provenance_findings(file)) +
              paragraph("The same job with the same program on the same class of CPU gives the "
                        "same bytes.") +
              more + folded("The job file", element("pre", job_text, {{"tabindex", "0"}}))};
}

}  // namespace gurney::page
