#include "studies/cli/show_command.h"

#include <fmt/format.h>

#include "studies/analysis/overview.h"
#include "studies/report/overview_report.h"

namespace gurney {
namespace {

template <class Overview>
int show(const Overview& overview, bool json) {
  fmt::print("{}", json ? overview_json(overview) : overview_text(overview));
  return 0;
}

}  // namespace

int show_command(const ShowOptions& options) {
  if (is_study_file(options.file)) return show(study_overview(options.file), options.json);
  return show(run_overview(options.file), options.json);
}

}  // namespace gurney
