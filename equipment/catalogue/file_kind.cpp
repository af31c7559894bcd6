#include "equipment/catalogue/file_kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/config/table.h"

namespace gurney::equipment {
namespace {

struct FileKind {
  const char *schema, *name, *command;
};

constexpr const char* kCheck = "gurney equipment check";
constexpr std::array kKinds = {
    FileKind{"gurney-job/1", "a job", "gurney check"},
    FileKind{"gurney-item/1", "an item", kCheck},
    FileKind{"gurney-caster/1", "a caster", kCheck},
    FileKind{"gurney-floor/1", "a floor covering", kCheck},
    FileKind{"gurney-room/1", "a room", kCheck},
    FileKind{"gurney-tether/1", "a kind of tether", kCheck},
    FileKind{"gurney-building/1", "a building",
             "gurney records floor RECORD --floor roof --building"},
    FileKind{"gurney-limit-states/1", "a list of limit states",
             "gurney fragility RESULTS --limit-states"},
    FileKind{"gurney-hazard/1", "a hazard curve", "gurney fragility RESULTS --hazard"}};

std::string named(const std::string& schema) {
  for (const FileKind& kind : kKinds)
    if (schema == kind.schema) return fmt::format("{} (\"{}\")", kind.name, schema);
  return "\"" + schema + "\"";
}

const FileKind* kind_of(const std::string& schema) {
  const auto* const kind = std::ranges::find(
      kKinds, schema, [](const FileKind& each) { return std::string(each.schema); });
  return kind == kKinds.end() ? nullptr : kind;
}

}  // namespace

bool holds_equipment(const std::string& file) {
  config::Document document(file);
  config::Table root = document.root();
  const FileKind* const kind = root.is_text("schema") ? kind_of(root.text("schema")) : nullptr;
  return kind != nullptr && std::string(kind->command) == kCheck;
}

void refuse_other_kind(config::Document& document, const std::string& wanted) {
  config::Table root = document.root();
  if (!root.is_text("schema")) return;
  const std::string schema = root.text("schema");
  const FileKind* const kind = kind_of(schema);
  if (kind == nullptr || schema == wanted) return;
  if (wanted.empty() && std::string(kind->command) == kCheck) return;
  throw Error(
      fmt::format("{}: schema = \"{}\": the file is {}, not {}; the command for it is: {} {}",
                  root.where("schema"), schema, kind->name,
                  wanted.empty() ? "an item, caster, floor covering, room or kind of tether "
                                   "(\"gurney-item/1\" and so on)"
                                 : named(wanted),
                  kind->command, document.path()));
}

}  // namespace gurney::equipment
