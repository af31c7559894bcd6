#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/base/printable.h"
#include "studies/cli/commands.h"
#include "studies/doctor/examination.h"
#include "studies/render/wrapped.h"

namespace gurney::cli {
namespace {

using doctor::Finding;

void print_text(const std::vector<Finding>& findings) {
  constexpr std::size_t kIndent = 22;
  for (const Finding& each : findings) {
    fmt::print("{:<8} {:<12} {}\n", name_of(each.state), each.name,
               render::wrapped(printable(each.text), kIndent, kIndent));
    if (!each.advice.empty())
      fmt::print("{:22}-> {}\n", "", render::wrapped(each.advice, kIndent + 3, kIndent + 3));
  }
}

void print_json(const std::vector<Finding>& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& each : findings)
    list.push_back({{"name", each.name},
                    {"state", name_of(each.state)},
                    {"text", each.text},
                    {"advice", each.advice}});
  fmt::print("{}\n", nlohmann::ordered_json{{"findings", list}}.dump(2));
}

int examine(const bool& json) {
  const std::vector<Finding> findings = doctor::examination();
  json ? print_json(findings) : print_text(findings);
  const auto problems = std::ranges::count(findings, Finding::State::kProblem, &Finding::state),
             warnings = std::ranges::count(findings, Finding::State::kWarning, &Finding::state);
  if (!json) fmt::print("\nproblems: {}, warnings: {}\n", problems, warnings);
  return problems > 0 ? 1 : 0;
}

}  // namespace

void add_doctor(Commands& commands) {
  commands.add<bool>({"doctor", "Report whether the program works on this machine",
                      "gurney doctor\n"
                      "gurney doctor --json"},
                     examine, [](Options& add, bool& json) { add("--json", json, "Print JSON"); });
}

}  // namespace gurney::cli
