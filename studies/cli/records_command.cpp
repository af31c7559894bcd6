#include <CLI/CLI.hpp>

#include "studies/cli/commands.h"

namespace gurney::cli {

void add_records(CLI::App& app, std::function<int()>& action) {
  CLI::App* const records =
      app.add_subcommand("records", "Inspect, convert, generate and scale ground motions");
  records->require_subcommand(1);
  for (AddCommand* const add :
       {add_records_info, add_records_plot, add_records_convert, add_records_scale,
        add_records_make, add_records_floor, add_records_model})
    add(*records, action);
}

}  // namespace gurney::cli
