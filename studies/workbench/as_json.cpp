#include "studies/workbench/as_json.h"

#include <nlohmann/json.hpp>

#include "studies/limit_states/limit_state.h"

namespace gurney::workbench {

using Json = nlohmann::json;

namespace {

Json shown(const findings::Fact& fact) {
  if (fact.label.empty() || fact.value.is_missing()) return nullptr;
  return {{"label", fact.label},
          {"value", findings::with_unit(fact.value, fact.format)},
          {"note", fact.note}};
}

Json shown(const findings::Table& table) {
  Json all = Json::array();
  for (const findings::Table& group : findings::groups_of(table)) {
    Json columns = Json::array(), rows = Json::array();
    for (const findings::Column& column : group.columns)
      if (!column.label.empty())
        columns.push_back({{"label", findings::heading(column)}, {"meaning", column.meaning}});
    for (const auto& row : group.rows) {
      Json cells = Json::array();
      for (std::size_t i = 0; i < row.size(); ++i)
        if (!group.columns[i].label.empty())
          cells.push_back(findings::written(row[i].value, row[i].format_in(group.columns[i])));
      rows.push_back(std::move(cells));
    }
    if (!columns.empty() && !rows.empty())
      all.push_back({{"title", group.title}, {"columns", columns}, {"rows", rows}});
  }
  return all.empty() ? Json(nullptr) : Json({{"tables", all}});
}

Json shown(const findings::List& list) {
  if (list.lines.empty() || (list.title.empty() && !list.key.empty())) return nullptr;
  return {{"title", list.title}, {"lines", list.lines}};
}

Json shown(const findings::Sentence& sentence) { return {{"say", sentence.text}}; }

}  // namespace

Json shown(const findings::Section& section) {
  Json parts = Json::array();
  for (const findings::Part& part : section.parts) {
    Json one =
        std::visit([](const auto& each) { return shown(each); },
                   static_cast<const std::variant<findings::Fact, findings::Table, findings::List,
                                                  findings::Sentence, findings::Section>&>(part));
    if (!one.is_null()) parts.push_back(std::move(one));
  }
  return parts.empty() ? Json(nullptr) : Json({{"title", section.title}, {"parts", parts}});
}

Json tree_of(const config::Node& node) {
  using Kind = config::Node::Kind;
  Json tree{{"line", node.place.line}, {"column", node.place.column}};
  switch (node.kind) {
    case Kind::kTable:
      tree["keys"] = Json::object();
      for (const config::Node& each : node.elements) {
        tree["keys"][each.key] = tree_of(each);
        tree["keys"][each.key]["key_line"] = each.key_place.line;
      }
      break;
    case Kind::kArray:
      tree["list"] = Json::array();
      for (const config::Node& each : node.elements) tree["list"].push_back(tree_of(each));
      break;
    case Kind::kBoolean:
      tree["value"] = node.boolean;
      break;
    case Kind::kInteger:
    case Kind::kNumber:
      tree["value"] = node.number;
      break;
    default:
      tree["value"] = node.text;
  }
  return tree;
}

Json limit_states_of(const study::RunFacts& facts, const Response& response) {
  Json all = Json::array();
  const std::vector<study::LimitState> states = study::default_limit_states();
  const study::Values values = study::values_of(facts.scene, response);
  for (std::size_t i = 0; i < states.size(); ++i)
    all.push_back({{"name", states[i].name},
                   {"words", states[i].words},
                   {"exceeded", study::exceeded(states, i, values)}});
  return all;
}

}  // namespace gurney::workbench
