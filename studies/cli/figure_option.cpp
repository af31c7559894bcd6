#include "studies/cli/figure_option.h"

#include <filesystem>

namespace gurney::cli {

void add_figure_option(CLI::App& command, std::string& path, const std::string& description) {
  const CLI::Validator is_svg(
      [](const std::string& given) {
        return std::filesystem::path(given).extension() == ".svg"
                   ? std::string()
                   : given + ": figures are written as SVG; the name must end in .svg";
      },
      "", "svg");
  command.add_option("--figure", path, description + " (.svg)")->check(is_svg);
}

}  // namespace gurney::cli
