#include "studies/cli/records_command.h"

#include "studies/cli/records_convert.h"
#include "studies/cli/records_floor.h"
#include "studies/cli/records_info.h"
#include "studies/cli/records_make.h"
#include "studies/cli/records_plot.h"
#include "studies/cli/records_scale.h"

namespace gurney::cli {

void add_records(CLI::App& app, std::function<int()>& act) {
  CLI::App* const records =
      app.add_subcommand("records", "Inspect, convert, generate and scale ground motions");
  records->require_subcommand(1);
  add_records_info(*records, act);
  add_records_plot(*records, act);
  add_records_convert(*records, act);
  add_records_scale(*records, act);
  add_records_make(*records, act);
  add_records_floor(*records, act);
}

}  // namespace gurney::cli
