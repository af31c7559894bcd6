#include <fmt/format.h>

#include "studies/page/study_page.h"
#include "studies/page/table.h"

namespace gurney::page {

Section assumptions_section(const study::FileOverview& file,
                            const std::optional<study::UndrawnRanges>& undrawn) {
  Table table{fmt::format("{} without a source", counted(file.assumptions.size(), "parameter")),
              {{"Parameter"}, {"Value"}, {"Range"}, {"Reason"}, {"Data file"}}};
  for (const auto& each : file.assumptions)
    table.rows.push_back({each.key, each.value, each.range, each.reason, each.file});
  Html content = paragraph(
      file.assumptions.empty()
          ? "Every parameter has a source."
          : "These parameters have no source. Each has a value, a range in which it may lie, and "
            "the reason for both.");
  content += html(table);
  if (undrawn && undrawn->parameters() > 0)
    content += element("h3", "Uncertainties not propagated") +
               paragraph(
                   "These parameters have a range and were not drawn: the results hold for their "
                   "values, and no scatter of this report includes their ranges.") +
               list(undrawn->lines());
  return {"assumptions", "Assumptions", content};
}

Section provenance_section(const study::FileOverview& file, const std::string& job_text,
                           const Html& more) {
  std::vector<std::pair<std::string, std::string>> named{
      {"Results file", file.path},
      {"Program", "gurney " + file.program_version},
      {"Commit", file.git_commit},
      {"Compiler", file.compiler},
      {"CPU class", file.cpu_class},
      {"Job", file.job_name},
      {"SHA-256 of the job", file.job_sha256},
      {"Seed", file.seed.empty() ? "none: nothing is random" : file.seed}};
  return {"provenance", "Provenance",
          facts(named) +
              paragraph("The same job with the same program on the same class of CPU gives the "
                        "same bytes.") +
              more + folded("The job file", element("pre", job_text, {{"tabindex", "0"}}))};
}

}  // namespace gurney::page
