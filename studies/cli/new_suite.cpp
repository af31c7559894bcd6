#include "studies/cli/new_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/error.h"
#include "engine/base/units.h"
#include "groundmotions/scaling/scale.h"
#include "groundmotions/suites/suite.h"
#include "studies/render/wrapped.h"

namespace gurney::cli {
namespace {

namespace fs = std::filesystem;
using groundmotions::Direction;

using Components = std::array<bool, 3>;

/// A record that can be read.
struct Found {
  std::string name;
  std::vector<std::string> files;
  Components components = {};
  double factor = 0;  ///< that brings it to the highest level of the template
};

struct Readable {
  std::vector<Found> records;
  std::vector<std::string> refused;
};

/// The highest level of the template, as PGA of the larger horizontal.
constexpr double kHighestLevel = 1 * kStandardGravity;  // [m/s2]

double factor_of(const groundmotions::Record& record) {
  double peak = 0;
  for (const Direction direction : {Direction::kH1, Direction::kH2})
    if (record[direction])
      peak = std::max(peak, record[direction]->acceleration.cwiseAbs().maxCoeff());
  return peak > 0 ? kHighestLevel / peak : 0;
}

Readable readable(const groundmotions::Suite& suite) {
  Readable found;
  for (const groundmotions::Refusal& refusal : suite.refused)
    found.refused.push_back(text_of(refusal));
  for (const groundmotions::SuiteRecord& entry : suite.records) try {
      const groundmotions::Record record = groundmotions::read_record(entry);
      Found one{.name = entry.name, .files = {}, .components = {}, .factor = factor_of(record)};
      for (const Direction direction : groundmotions::kDirections)
        one.components[static_cast<std::size_t>(direction)] = record[direction].has_value();
      for (const groundmotions::RecordFile& file : entry.files) one.files.push_back(file.path);
      found.records.push_back(std::move(one));
    } catch (const Error& error) {
      found.refused.emplace_back(error.what());
    }
  return found;
}

std::string lacking(const Found& record, const Components& wanted) {
  std::vector<const char*> names;
  for (const Direction direction : groundmotions::kDirections) {
    const auto i = static_cast<std::size_t>(direction);
    if (wanted[i] && !record.components[i]) names.push_back(name_of(direction));
  }
  return fmt::format("{}", fmt::join(names, " and "));
}

/// All three components, or both horizontals, if more than half of the records have them; else
/// what all have.
Components components_for(const std::vector<Found>& records) {
  for (const Components& wanted : {Components{true, true, true}, Components{true, true, false}}) {
    const auto complete = std::ranges::count_if(
        records, [&](const Found& record) { return lacking(record, wanted).empty(); });
    if (2 * complete > std::ssize(records)) return wanted;
  }
  Components common = {true, true, true};
  for (const Found& record : records)
    for (std::size_t i = 0; i < 3; ++i) common[i] = common[i] && record.components[i];
  return common;
}

/// Why a record is not in the study; empty: it is.
std::string unfit(const Found& record, const Components& wanted) {
  if (const std::string missing = lacking(record, wanted); !missing.empty())
    return "it has no " + missing;
  if (record.factor > groundmotions::kDubiousFactor)
    return fmt::format("the highest level needs a factor of {:.3g}, more than {:g}", record.factor,
                       groundmotions::kDubiousFactor);
  return {};
}

std::string seen_from(const fs::path& file, const fs::path& path) {
  return fs::absolute(path).lexically_normal().lexically_proximate(
      fs::absolute(file).lexically_normal().parent_path());
}

std::string comment(const std::string& text) {
  std::string lines = "# " + render::wrapped(text, 2, 2);
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
  require(!found.records.empty(), fmt::format("{}: no record can be read\n{}", folder.string(),
                                              fmt::join(found.refused, "\n")));
  const Components wanted = components_for(found.records);
  std::vector<std::string> names, left_out;
  std::string files, spare;
  for (const Found& record : found.records) {
    const std::string reason = unfit(record, wanted);
    if (reason.empty()) names.push_back(record.name);
    if (!reason.empty()) left_out.push_back(record.name + ": " + reason);
    for (const std::string& each : record.files)
      (reason.empty() ? files : spare) +=
          fmt::format("  {}\"{}\",\n", reason.empty() ? "" : "# ", seen_from(file, each));
  }
  require(!names.empty(), fmt::format("{}: no record is fit for the study\n{}", folder.string(),
                                      fmt::join(left_out, "\n")));
  std::string text = comment(fmt::format("{} records: {}", names.size(), fmt::join(names, ", ")));
  for (const std::string& reason : found.refused) text += comment("excluded: " + reason);
  for (const std::string& reason : left_out) text += comment("excluded: " + reason);
  if (found.refused.empty() && left_out.empty())
    text += fmt::format("suite = \"{}\"\n", seen_from(file, folder));
  else
    text += "suite = [\n" + files + spare + "]\n";
  if (!unit.empty()) text += fmt::format("unit = \"{}\"\n", unit);
  const auto [x, y, z] = wanted;
  if (!x || !y || !z)
    text += fmt::format("use = \"{}{}{}\"  # components that every record has\n", x ? "x" : "",
                        y ? "y" : "", z ? "z" : "");
  wishes.suite = text;
  if (!x || !y) wishes.component = x ? "h1" : y ? "h2" : "vertical";
  std::string answer = fmt::format("{} records", names.size());
  if (!found.refused.empty())
    answer = fmt::format("{} of {} records; {} states why the others are excluded{}", names.size(),
                         found.records.size() + found.refused.size(), file.string(),
                         unit.empty() ? " (no unit in them: --unit g)" : "");
  for (const std::string& reason : left_out) answer += "\n         excluded: " + reason;
  for (const Found& record : found.records)
    if (const std::string missing = lacking(record, {true, true, true});
        !missing.empty() && !(x && y && z) && unfit(record, wanted).empty())
      answer += fmt::format("\n         {} has no {}", record.name, missing);
  return answer;
}

}  // namespace gurney::cli
