#include <fmt/format.h>

#include "studies/page/findings_html.h"
#include "studies/page/study_page.h"
#include "studies/report/overview_report.h"

namespace gurney::page {

Section assumptions_section(const study::FileOverview& file,
                            const std::optional<study::UndrawnRanges>& undrawn) {
  Html content = html(report::assumption_findings(file));
  if (!file.assumptions.empty())
    content = folded(
        fmt::format("{} without a source", counted(file.assumptions.size(), "parameter")), content);
  if (undrawn && undrawn->parameters() > 0)
    content += folded(fmt::format("{} with a range, which the study does not draw",
                                  counted(undrawn->parameters(), "parameter")),
                      html(report::undrawn_findings(undrawn)));
  return {"assumptions", "Assumptions", content};
}

Section provenance_section(const study::FileOverview& file, const std::string& job_text,
                           const Html& more) {
  return {"provenance", "Provenance",
          html(report::provenance_findings(file)) +
              paragraph("The same job with the same program on the same class of CPU gives the "
                        "same bytes.") +
              (more.empty() ? more : folded("Data files", more)) +
              folded("The job file", element("pre", job_text, {{"tabindex", "0"}}))};
}

}  // namespace gurney::page
