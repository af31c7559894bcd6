#include "studies/templates/templates.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "embedded/caster_toml.h"
#include "embedded/item_toml.h"
#include "embedded/job_toml.h"
#include "embedded/pull_csv.h"
#include "embedded/room_toml.h"
#include "embedded/study_toml.h"
#include "engine/base/error.h"
#include "engine/base/toml_string.h"
#include "engine/base/units.h"

namespace gurney::templates {
namespace {

struct Template {
  const char* kind;
  std::string_view text;
  const char* name;  ///< the line that names it
};
constexpr Template kTemplates[] = {{"job", embedded::job_toml, "title = \"my first job\""},
                                   {"item", embedded::item_toml, "name = \"my item\""},
                                   {"caster", embedded::caster_toml, "name = \"my caster\""},
                                   {"room", embedded::room_toml, "name = \"my room\""},
                                   {"study", embedded::study_toml, "title = \"my first study\""}};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// @param option  that asks for it
/// @throws Error where a template has no such line
void replace_line(std::string& text, const std::string& option, const std::string& from,
                  const std::string& to) {
  require(text.find(from) != std::string::npos, "this kind of file has no use for " + option);
  replace_all(text, from, to);
}

std::string quoted(const std::string& text) {
  const bool plain = std::ranges::none_of(text, [](unsigned char each) {
    return each == '"' || each == '\\' || each < ' ' || each == 127;
  });
  require(plain, text + ": must have no quotation marks, backslashes and control characters");
  return '"' + text + '"';
}

}  // namespace

const std::vector<std::string>& kinds() {
  static const std::vector<std::string> kKinds = {"job",  "item",  "caster",
                                                  "room", "study", "calibration"};
  return kKinds;
}

std::string file_text(const std::string& kind, const Wishes& wishes) {
  const auto* const found = std::ranges::find(kTemplates, kind, &Template::kind);
  require(found != std::end(kTemplates), "no template of a " + kind);
  std::string text(found->text);
  const std::string key = std::string(found->name).substr(0, std::string(found->name).find('"'));
  replace_line(text, "a name", found->name, key + quoted(wishes.name));
  replace_all(text, "NAME", wishes.name);
  if (!wishes.item.empty())
    replace_line(text, "--item", "equipment = \"icu_ventilator\"",
                 "equipment = " + toml_string(wishes.item));
  if (!wishes.caster.empty())
    replace_line(text, "--caster", "type = \"R100\"", "type = " + toml_string(wishes.caster));
  if (!wishes.room.empty())
    replace_line(text, "--room", "# [room]\n# file = \"icu_bay\"",
                 "[room]\nfile = " + toml_string(wishes.room));
  if (!wishes.record.empty())
    replace_line(
        text, "--record",
        "# A synthetic motion, never recorded. For a record of your own write instead, for "
        "example,\n#   file = [\"RSN1_H1.AT2\", \"RSN1_H2.AT2\", \"RSN1_UP.AT2\"]\n"
        "synthetic = { kind = \"clough_penzien\", seed = 1 }\n",
        wishes.record);
  if (!wishes.suite.empty()) {
    replace_line(text, "--from",
                 "# Synthetic motions, never recorded. For records of your own: gurney new study " +
                     wishes.name + " --from FOLDER\nsynthetic = { kind = \"clough_penzien\" }\n",
                 wishes.suite);
    replace_line(text, "--from", "synthetic_records = 10\n", "");
  }
  if (!wishes.component.empty())
    replace_line(text, "--from", "component = \"larger\"",
                 "component = " + toml_string(wishes.component));
  return text;
}

std::string pull_text(double resistance) {
  // Phases II and III: (M + J) a_2 = F - f_r, (M + J) a_3 = f_r, with the M and J of the header
  // (docs/calibration.md).
  constexpr double kMass = 50, kAdded = 0.5, kForce = 30, kHeld = 1, kPulled = 2, kStep = 0.01;
  const double friction = resistance * kMass * kStandardGravity,
               pulled = (kForce - friction) / (kMass + kAdded),
               coasting = friction / (kMass + kAdded), speed = pulled * kPulled,
               rest = kHeld + kPulled + speed / coasting;
  std::string text(embedded::pull_csv);
  for (int i = 0; i * kStep < rest; ++i) {
    const double time = i * kStep, second = std::clamp(time - kHeld, 0.0, kPulled),
                 third = std::max(0.0, time - kHeld - kPulled);
    const double moved =
        pulled * second * second / 2 + speed * third - coasting * third * third / 2;
    text += fmt::format("{:.2f},{:.1f},{:.2f}\n", time, third > 0 ? 0 : kForce, 1000 * moved);
  }
  return text;
}

}  // namespace gurney::templates
