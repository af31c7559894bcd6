#include "groundmotions/formats/plain_column.h"

#include <fmt/format.h>

#include "groundmotions/acceleration_unit.h"
#include "groundmotions/formats/mistakes.h"
#include "groundmotions/formats/numbers.h"

namespace gurney {

namespace {

bool is_content(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && line[0] != '#';
}

}  // namespace

bool recognises_plain_column(const SourceFile& file) {
  for (std::string_view line : file.lines()) {
    if (!is_content(line)) continue;
    line = trimmed(line);
    return take_number(line).has_value() && line.find_first_of(",;") == std::string_view::npos;
  }
  return false;
}

std::vector<Component> read_plain_column(const SourceFile& file, const ReadOptions& options) {
  Mistakes mistakes(file.name());
  if (options.unit.empty())
    mistakes.add(fmt::format(
        "a plain column of numbers does not state its unit; state it as unit = \"...\" ({})",
        kAccelerationUnits));
  if (!options.time_step)
    mistakes.add("a plain column of numbers does not state its time step; state it as time_step_s");

  NumberReader reader(file, mistakes);
  for (std::size_t i = 0; i < file.lines().size(); ++i) {
    if (!is_content(file.lines()[i])) continue;
    const std::size_t count = reader.read_line(i);
    if (count > 1)
      mistakes.add(i + 1, 1,
                   fmt::format("{} numbers on a line, 1 is allowed: several could be samples, "
                               "a time and a sample, or components; use docs/formats/record_csv.md",
                               count));
  }
  reader.check_end();
  const auto& values = reader.values();
  if (!mistakes.any() && values.size() < 2)
    mistakes.add(fmt::format("{} samples are no record (2 at least)", values.size()));
  mistakes.throw_if_any();

  const AccelerationUnit unit = *acceleration_unit(options.unit);
  Component component;
  component.time_step = *options.time_step;
  component.unit = unit.name;
  component.acceleration =
      unit.to_si *
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  return {component};
}

}  // namespace gurney
