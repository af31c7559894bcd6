#include "studies/cli/records_command.h"

#include "studies/cli/records_convert.h"

namespace gurney {

void add_records(CLI::App& app, std::function<int()>& act) {
  CLI::App* const records =
      app.add_subcommand("records", "Look at ground motions, convert, make and transform them");
  records->require_subcommand(1);
  add_records_convert(*records, act);
}

}  // namespace gurney
