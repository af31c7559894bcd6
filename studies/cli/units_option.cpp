#include "studies/cli/units_option.h"

#include <fmt/format.h>

#include "engine/base/error.h"

namespace gurney::cli {

CLI::Option* add_units_option(CLI::App& command, study::UnitSystem& units, const char* usual) {
  const std::vector<std::string> names = study::UnitSystem::names();
  const auto problem = [](const std::string& name) -> std::string {
    try {
      study::UnitSystem{name};
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  return command
      .add_option_function<std::string>(
          "--units", [&units](const std::string& name) { units = study::UnitSystem(name); },
          fmt::format("Units of what is printed and drawn: {} (default: {})",
                      fmt::join(names, ", "), usual))
      ->check(CLI::Validator(problem, fmt::format("{{{}}}", fmt::join(names, ","))));
}

}  // namespace gurney::cli
