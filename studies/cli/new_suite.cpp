#include "studies/cli/new_suite.h"

#include <fmt/format.h>

#include <array>

#include "engine/base/error.h"
#include "groundmotions/suites/suite.h"
#include "studies/report/wrapped.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;
using groundmotions::Direction;

/// What can be read of a suite, and which components all of that has.
struct Readable {
  std::vector<std::string> names, files, refused;
  std::array<bool, 3> components = {true, true, true};
};

Readable readable(const groundmotions::Suite& suite) {
  Readable found;
  for (const groundmotions::Refusal& refusal : suite.refused)
    found.refused.push_back(text_of(refusal));
  for (const groundmotions::SuiteRecord& entry : suite.records) try {
      const groundmotions::Record record = groundmotions::read_record(entry);
      for (const Direction direction : groundmotions::kDirections)
        if (!record[direction]) found.components[static_cast<std::size_t>(direction)] = false;
      found.names.push_back(entry.name);
      for (const groundmotions::RecordFile& file : entry.files) found.files.push_back(file.path);
    } catch (const Error& error) {
      found.refused.emplace_back(error.what());
    }
  return found;
}

std::string seen_from(const fs::path& file, const fs::path& path) {
  return fs::absolute(path).lexically_normal().lexically_proximate(
      fs::absolute(file).lexically_normal().parent_path());
}

std::string comment(const std::string& text) {
  std::string lines = "# " + report::wrapped(text, 2, 2);
  for (std::size_t at = lines.find("\n  "); at != std::string::npos;
       at = lines.find("\n  ", at + 3))
    lines.replace(at, 3, "\n# ");
  return lines + "\n";
}

}  // namespace

std::string use_records(const fs::path& folder, const std::string& unit, const fs::path& file,
                        templates::Wishes& wishes) {
  groundmotions::ReadOptions options;
  options.unit = unit;
  const Readable found = readable(groundmotions::read_suite({folder}, options));
  require(!found.names.empty(), fmt::format("{}: no record can be read\n{}", folder.string(),
                                            fmt::join(found.refused, "\n")));
  std::string text =
      comment(fmt::format("{} records: {}", found.names.size(), fmt::join(found.names, ", ")));
  for (const std::string& reason : found.refused) text += comment("excluded: " + reason);
  if (found.refused.empty()) {
    text += fmt::format("suite = \"{}\"\n", seen_from(file, folder));
  } else {
    text += "suite = [\n";
    for (const std::string& each : found.files)
      text += fmt::format("  \"{}\",\n", seen_from(file, each));
    text += "]\n";
  }
  if (!unit.empty()) text += fmt::format("unit = \"{}\"\n", unit);
  const auto [x, y, z] = found.components;
  if (!x || !y || !z)
    text += fmt::format("use = \"{}{}{}\"  # components that every record has\n", x ? "x" : "",
                        y ? "y" : "", z ? "z" : "");
  wishes.suite = text;
  if (!x || !y) wishes.component = x ? "h1" : y ? "h2" : "vertical";
  if (found.refused.empty()) return fmt::format("{} records", found.names.size());
  return fmt::format("{} of {} records; {} states why the others are excluded{}",
                     found.names.size(), found.names.size() + found.refused.size(), file.string(),
                     unit.empty() ? " (no unit in them: --unit g)" : "");
}

}  // namespace gurney::cli
