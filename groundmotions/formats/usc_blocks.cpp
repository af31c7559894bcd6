
#include <cmath>

#include "engine/base/units.h"
#include "groundmotions/formats/fortran_fields.h"
#include "groundmotions/formats/numbers.h"
#include "groundmotions/formats/orientation.h"
#include "groundmotions/formats/readers.h"
#include "groundmotions/formats/stated.h"
#include "groundmotions/formats/words.h"

namespace gurney::groundmotions {

namespace {

constexpr std::size_t kHeaderLines = 7;

struct Block {
  std::size_t first_line = 0;
  std::string text[kHeaderLines];
  std::string type;  ///< "AC", "VL", "DP"
  std::optional<double> rate, count, azimuth;
};

Block block_at(const SourceFile& file, std::size_t line) {
  Block block{.first_line = line, .text = {}, .type = {}, .rate = {}, .count = {}, .azimuth = {}};
  for (std::size_t i = 0; i < kHeaderLines && line + i < file.lines().size(); ++i) {
    const std::string text = block.text[i] = upper(file.lines()[line + i].substr(0, 200));
    if (const auto at = text.find("DATA TYPE="); at != std::string::npos)
      block.type = trimmed(text.substr(at + 10));
    if (const auto rate = number_after(text, "SAMPLES/SEC")) block.rate = rate;
    if (const auto count = number_after(text, "NO OF POINTS")) block.count = count;
    if (const auto azimuth = number_after(text, "COMPONENT")) block.azimuth = azimuth;
  }
  return block;
}

void take_facts(const SourceFile& file, const Block& block, Component& component) {
  component.name = trimmed(file.lines()[block.first_line + 1]);
  component.header = {{"station", std::string(trimmed(file.lines()[block.first_line]))},
                      {"event", std::string(trimmed(file.lines()[block.first_line + 2]))},
                      {"filter", std::string(trimmed(file.lines()[block.first_line + 3]))}};
  const bool labelled = orient_by_label(component.name, component);
  if (!labelled && block.azimuth && *block.azimuth >= 0 && *block.azimuth <= 360)
    component.azimuth = std::fmod(*block.azimuth, 360) * kRadiansPerDegree;
}

}  // namespace

bool recognises_usc_blocks(const SourceFile& file) {
  const Block block = block_at(file, 0);
  return !block.type.empty() && block.rate;
}

/// @returns the acceleration of each component of the file.
/// @throws Error if a block has not the number of samples it states, or no block is acceleration.
std::vector<Component> read_usc_blocks(const SourceFile& file, const ReadOptions& options) {
  FileErrors errors(file);
  FieldReader fields(file, errors);
  const FortranFormat format = *fortran_format("10F8.2");
  std::vector<Component> components;
  for (std::size_t line = 0; line < file.lines().size() && !errors.any();) {
    if (trimmed(file.lines()[line]).empty()) {
      ++line;
      continue;
    }
    const Block block = block_at(file, line);
    const std::size_t first = line + 1;
    if (block.type.empty() || !block.rate || !block.count || !(*block.rate > 0) ||
        !(*block.count >= 2 && *block.count <= 1e7 && *block.count == std::floor(*block.count))) {
      errors.add(first, 1,
                 "no header of a block here: 7 lines with SAMPLES/SEC= above 0, DATA TYPE= and "
                 "NO OF POINTS= above 1");
      break;
    }
    line += kHeaderLines;
    auto values = fields.read(line, static_cast<std::size_t>(*block.count), format,
                              EmptyField::kError, "samples");
    if (block.type != "AC") {
      if (!components.empty())
        components.back().header.emplace_back("also in the file", "data type " + block.type);
      continue;
    }
    const std::size_t unit_line = first + kHeaderLines - 1;
    const auto unit =
        agreed_unit(unit_in(block.text[kHeaderLines - 1]), unit_line, options, errors);
    Component component;
    component.unit = unit.name;
    component.time_step = agreed_time_step(1 / *block.rate, first + 5, options, errors);
    component.acceleration = scaled(values, unit.to_si);
    take_facts(file, block, component);
    components.push_back(component);
  }
  if (!errors.any() && components.empty())
    errors.add(1, 1,
               "this file holds velocity (VL) or displacement (DP) only; a record must be "
               "acceleration (DATA TYPE=AC)");
  errors.throw_if_any();
  return components;
}

}  // namespace gurney::groundmotions
