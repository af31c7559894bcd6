#include "groundmotions/hazard/usgs_answer.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/error.h"

namespace gurney::groundmotions {

using config::Node;

UsgsAnswer::UsgsAnswer(const std::string& path) : document_(path) {
  response_ = document_.tree().find("response");
  if (response_ &&
      (response_->kind == Node::Kind::kArray || response_->kind == Node::Kind::kTable)) {
    old_ = response_->kind == Node::Kind::kArray;
    return;
  }
  const Node* const said = document_.tree().find("message");  // of an answer that is an error
  throw Error(path + ": is no answer of the hazard service of the USGS" +
              (said && said->kind == Node::Kind::kText ? ", but: " + said->text
                                                       : ": it has no 'response'"));
}

void UsgsAnswer::fail(const Node& at, const std::string& message) const {
  throw Error(document_.where(at.place) + ": " + message);
}

const Node& UsgsAnswer::member(const Node& of, const std::string& key, Node::Kind kind) const {
  const Node* const found = of.kind == Node::Kind::kTable ? of.find(key) : nullptr;
  if (!found || found->kind != kind)
    fail(found ? *found : of, fmt::format("{} must be {}", key,
                                          kind == Node::Kind::kText    ? "a text"
                                          : kind == Node::Kind::kArray ? "an array"
                                                                       : "a table"));
  return *found;
}

std::vector<const Node*> UsgsAnswer::results(const std::string& key) const {
  const Node& all = old_ ? *response_ : member(*response_, key, Node::Kind::kArray);
  std::vector<const Node*> found;
  for (const Node& each : all.elements) found.push_back(&each);
  if (found.empty()) fail(all, "is empty");
  return found;
}

const Node& UsgsAnswer::total_of(const Node& result) const {
  const Node& data = member(result, "data", Node::Kind::kArray);
  for (const Node& each : data.elements)
    if (member(each, "component", Node::Kind::kText).text == "Total") return each;
  fail(data, "no component is 'Total'");
}

PublishedMeasure UsgsAnswer::measure_of(const Node& result) const {
  const Node& about = old_ ? member(result, "metadata", Node::Kind::kTable) : result;
  const Node& imt = member(member(about, "imt", Node::Kind::kTable), "value", Node::Kind::kText);
  const PublishedMeasure measure = published_measure(imt.text);
  if (measure.name.empty())
    fail(imt, fmt::format("'{}': must be PGA, PGV or SA with a period, such as SA0P2", imt.text));
  return measure;
}

std::vector<UsgsCurve> UsgsAnswer::curves() const {
  const auto refuse = [&] {
    throw Error(
        document_.path() +
        ": is a disaggregation, one point of a hazard curve; gurney records select takes it "
        "as --target \"disaggregation file=FILE\"");
  };
  if (!old_ && response_->find("disaggs")) refuse();
  std::vector<UsgsCurve> curves;
  for (const Node* result : results("hazardCurves")) {
    const Node& total = total_of(*result);
    if (total.find("summary")) refuse();
    const Node& levels =
        old_
            ? member(member(*result, "metadata", Node::Kind::kTable), "xvalues", Node::Kind::kArray)
            : member(member(total, "values", Node::Kind::kTable), "xs", Node::Kind::kArray);
    const Node& rates =
        old_ ? member(total, "yvalues", Node::Kind::kArray)
             : member(member(total, "values", Node::Kind::kTable), "ys", Node::Kind::kArray);
    if (rates.elements.size() != levels.elements.size())
      fail(rates, fmt::format("has {} values for {} levels", rates.elements.size(),
                              levels.elements.size()));
    curves.push_back({measure_of(*result), &levels, &rates});
  }
  return curves;
}

std::vector<UsgsDisaggregation> UsgsAnswer::disaggregations() const {
  if (!old_ && response_->find("hazardCurves"))
    throw Error(document_.path() + ": is a hazard curve, no disaggregation");
  std::vector<UsgsDisaggregation> found;
  for (const Node* result : results("disaggs"))
    found.push_back({measure_of(*result), &total_of(*result)});
  return found;
}

double UsgsAnswer::summed_up(const UsgsDisaggregation& of, const std::string& summary,
                             const std::vector<std::string>& names,
                             const config::Range& allowed) const {
  for (const Node& part : member(*of.total, "summary", Node::Kind::kArray).elements) {
    if (member(part, "name", Node::Kind::kText).text.find(summary) == std::string::npos) continue;
    for (const Node& each : member(part, "data", Node::Kind::kArray).elements) {
      const std::string& text = member(each, "name", Node::Kind::kText).text;
      if (std::ranges::none_of(names, [&](const auto& name) { return text.ends_with(name); }))
        continue;
      const Node* const value = each.find("value");
      if (!value || !value->is_number() || !allowed.contains(value->number))
        fail(value ? *value : each, fmt::format("value of '{}' must be {}", text, allowed.text()));
      return value->number;
    }
    fail(part, fmt::format("has no '{}'", fmt::join(names, "' or '")));
  }
  fail(*of.total, fmt::format("has no summary '{}'", summary));
}

}  // namespace gurney::groundmotions
