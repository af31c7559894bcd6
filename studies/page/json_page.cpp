#include "studies/page/json_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/input_file.h"
#include "engine/base/printable.h"
#include "engine/config/json_reader.h"
#include "studies/figures/pulling_figures.h"
#include "studies/figures/verification_figures.h"
#include "studies/page/html.h"
#include "studies/report/calibration_report.h"
#include "studies/report/verification_report.h"

namespace gurney::page {
namespace {

using namespace findings;
using config::Node;

/// Reads findings of the shape of an example: its keys, and the kinds of its values.
class FindingsReader {
 public:
  FindingsReader(const config::JsonTree& tree, const std::string& file)
      : tree_(tree), file_(file) {}

  findings::Section section(const Node& object, const findings::Section& example) const {
    findings::Section read(example.key, example.title);
    for (const Part& part : example.parts)
      std::visit([&](const auto& of) { add(object, of, read); },
                 static_cast<const Part::variant&>(part));
    return read;
  }

 private:
  [[noreturn]] void refuse(const Node& node, const std::string& what) const {
    const std::string& pointer = tree_.pointers.at(static_cast<std::size_t>(node.place.line) - 1);
    throw Error(file_ + ":" + (pointer.empty() ? "/" : pointer) + ": " + what);
  }

  const Node& of_kind(const Node& node, Node::Kind kind, const char* what) const {
    if (node.kind != kind) refuse(node, std::string("must be ") + what);
    return node;
  }

  const Node& at(const Node& object, const std::string& key) const {
    const Node* const found = of_kind(object, Node::Kind::kTable, "an object").find(key);
    if (found == nullptr) refuse(object, "lacks \"" + key + "\"");
    return *found;
  }

  static bool is_null(const Node& node) {
    return node.kind == Node::Kind::kOther && node.text == "null";
  }

  double number(const Node& node) const {
    if (is_null(node)) return std::numeric_limits<double>::quiet_NaN();
    if (!node.is_number()) refuse(node, "must be a number");
    return node.number;
  }

  const std::vector<Node>& elements(const Node& node) const {
    return of_kind(node, Node::Kind::kArray, "an array").elements;
  }

  /// A number or a text may be null. An example without a value may be either.
  Value value(const Node& node, const Value& example) const {
    if (std::holds_alternative<bool>(example))
      return of_kind(node, Node::Kind::kBoolean, "true or false").boolean;
    if (std::holds_alternative<std::int64_t>(example)) {
      const std::int64_t count = of_kind(node, Node::Kind::kInteger, "a whole number").integer;
      if (count < 0) refuse(node, "must not be negative");
      return count;
    }
    if (std::holds_alternative<double>(example)) return number(node);
    if (std::holds_alternative<std::string>(example))
      return is_null(node) ? std::string() : of_kind(node, Node::Kind::kText, "a text").text;
    if (std::holds_alternative<Texts>(example)) return texts(node);
    if (std::holds_alternative<std::monostate>(example)) {
      if (is_null(node)) return {};
      return node.kind == Node::Kind::kText ? Value(node.text) : Value(number(node));
    }
    Numbers ends;
    for (const Node& each : elements(node)) ends.push_back(number(each));
    if (ends.size() != 2) refuse(node, "must be two numbers");
    return ends;
  }

  Texts texts(const Node& node) const {
    Texts all;
    for (const Node& each : elements(node))
      all.push_back(of_kind(each, Node::Kind::kText, "a text").text);
    return all;
  }

  void add_row(const Node& object, const Table& example, Table& read) const {
    of_kind(object, Node::Kind::kTable, "an object");
    read.rows.emplace_back();
    for (std::size_t i = 0; i < example.columns.size(); ++i) {
      const std::string& key = example.columns[i].key;
      read.rows.back().emplace_back(
          key.empty() ? Value() : value(at(object, key), example.rows.at(0).at(i).value));
    }
  }

  Table table(const Node& node, const Table& example) const {
    Table read = example;
    read.rows.clear();
    if (example.key.ends_with("{}"))
      for (const Node& each : of_kind(node, Node::Kind::kTable, "an object").elements) {
        add_row(each, example, read);
        read.rows.back().front() = each.key;
      }
    else
      for (const Node& each : elements(node)) add_row(each, example, read);
    return read;
  }

  void add(const Node& object, const Fact& of, findings::Section& read) const {
    Fact fact = of;
    if (!of.key.empty()) fact.value = value(at(object, of.key), of.value);
    read.parts.emplace_back(fact);
  }
  void add(const Node& object, const List& of, findings::Section& read) const {
    List list = of;
    list.lines = texts(at(object, of.key));
    read.add(std::move(list));
  }
  void add(const Node& object, const Table& of, findings::Section& read) const {
    const std::string key = of.key.substr(0, of.key.find('{'));
    if (key != kAnyKey) return void(read.add(table(at(object, key), of)));
    for (const Node& each : of_kind(object, Node::Kind::kTable, "an object").elements) {
      Table named = table(each, of);
      named.key = each.key;
      read.add(std::move(named));
    }
  }
  void add(const Node&, const Sentence& of, findings::Section& read) const {
    read.parts.emplace_back(of);
  }
  void add(const Node& object, const findings::Section& of, findings::Section& read) const {
    if (of.key.empty())
      read.add(section(object, of));
    else if (!of.key.ends_with("[]"))
      read.add(section(at(object, of.key), of));
    else
      for (const Node& each : elements(at(object, of.key.substr(0, of.key.size() - 2))))
        read.add(section(of_kind(each, Node::Kind::kTable, "an object"), of));
  }

  const config::JsonTree& tree_;
  const std::string& file_;
};

figures::Range range_of(const Table& table, std::size_t row, const char* key, double over) {
  const auto& ends = std::get<Numbers>(value_in(table, row, key));
  return {ends[0] / over, ends[1] / over};
}

Html load_drawing(const Table& constants, const Table& pulls) {
  std::vector<figures::LoadLine> lines;
  for (std::size_t i = 0; i < constants.rows.size(); ++i) {
    if (text_in(constants, i, "name") != "rolling_resistance") continue;
    const std::string &caster = text_in(constants, i, "caster"),
                      &floor = text_in(constants, i, "floor");
    const double value = number_in(constants, i, "value");
    figures::LoadLine line{fmt::format("{} on {}: Cr/R {:.4g}", caster, floor, value),
                           value,
                           range_of(constants, i, "interval_95", 1),
                           range_of(constants, i, "prediction_95", 1),
                           {},
                           {}};
    for (std::size_t k = 0; k < pulls.rows.size(); ++k) {
      if (text_in(pulls, k, "caster") != caster || text_in(pulls, k, "floor") != floor) continue;
      line.load.push_back(number_in(pulls, k, "normal_force_n"));
      line.resistance.push_back(number_in(pulls, k, "resistance_n"));
    }
    lines.push_back(line);
  }
  if (pulls.rows.empty() || lines.empty()) return {};
  return html(Drawing{"loads", figures::load_figure({.width = 480}, lines),
                      "Rolling resistance of the pulls, and the fitted lines f_r = (Cr/R) N.",
                      "Marks are pulls for calibration; lines start at the origin. The numbers are "
                      "in the table of pulls below."});
}

Html residual_drawing(const Table& constants, const Table& values) {
  std::vector<figures::ResidualRow> rows;
  for (std::size_t i = 0; i < constants.rows.size(); ++i) {
    const std::string& about = text_in(constants, i, "constant");
    const double value = number_in(constants, i, "value");
    rows.push_back({about,
                    {},
                    range_of(constants, i, "interval_95", value),
                    range_of(constants, i, "prediction_95", value)});
    for (std::size_t k = 0; k < values.rows.size(); ++k)
      if (text_in(values, k, "constant") == about &&
          value_in(values, k, "lower_bound") == value_in(constants, i, "lower_bound"))
        rows.back().trials.push_back({number_in(values, k, "value") / value,
                                      number_in(values, k, "standard_error") / value,
                                      text_in(values, k, "use") == "validation"});
  }
  return html(Drawing{"residuals", figures::residual_figure({.width = 480}, rows),
                      "Values of the single trials against the constants.",
                      "One row for each constant. The numbers are in the table of residuals."});
}

Table keys_table() {
  return {"",
          "What a caster file takes from the constants",
          {{"", "constant"}, {"", "key"}, {"", "value there"}},
          {{"Cr/R", "tread.rolling_resistance_mm",
            "times the radius of the wheel; the scatter is its lognormal distribution"},
           {"mu_s, mu_k", "tread.static_friction, tread.kinetic_friction",
            "as they are; without a distribution, as mu_s must not be below mu_k in any draw"},
           {"swivel torque over N", "tread.patch_width_mm",
            "4 (torque over N less T/N) / mu_s, with the swivel friction T of the base"},
           {"Cr/R at start, e", "none", "e belongs into [contact] of the item"}}};
}

Html texts_of(const Table& files) {
  Html all;
  for (std::size_t i = 0; i < files.rows.size(); ++i)
    all += folded(text_in(files, i, "file"),
                  element("pre", text_in(files, i, "text"), {{"tabindex", "0"}}));
  return all.empty() ? all : paragraph("All other keys are those of the base.") + all;
}

constexpr const char* kMethods =
    "The logarithm of a trial's value is the sum of the constant's logarithm, a scatter between "
    "trials and the error of the measurement. The estimate is by least squares weighted with both "
    "variances, the scatter by Paule & Mandel (1982, J. Res. Natl. Bur. Stand. 87, 377-385), the "
    "interval by Student's t with the covariance of Knapp & Hartung (2003, Statistics in Medicine "
    "22, 2693-2710). Rolling resistance of a pull is that of Xu, Ma & Kurata (2022, 5th SPONSE "
    "workshop): from the force and the accelerations while pulled and while coasting.";

Section tolerances(const std::vector<figures::ToleranceRow>& rows) {
  const std::string title = "Use of the tolerances";
  if (rows.empty()) return {"tolerances", title, {}};
  return {"tolerances", title,
          html(Drawing{"tolerances", figures::tolerance_figure({.width = 900}, rows),
                       "Error over tolerance of every check, by group.",
                       "One row for each group of closed forms; marks left of the dashed line "
                       "passed. The same numbers are in the tables below."})};
}

Document calibration_document(const findings::Section& of) {
  const Table& constants = *find<Table>(of, "constants");
  Document document{of.title,
                    fmt::format("{} from {}", counted(constants.rows.size(), "constant"),
                                counted(std::stoul(text_of(of, "trials")), "trial")),
                    sections_of(of, {"summary", "trials", "fit", "diagnostics", "validation",
                                     "casters", "provenance"}),
                    {}};
  Html& fit = document.sections.at(2).content;
  fit = element("div",
                load_drawing(constants, *find<Table>(of, "pulls")) +
                    residual_drawing(constants, *find<Table>(of, "values")),
                {{"class", "figures"}}) +
        fit;
  Html& casters = document.sections.at(5).content;
  casters = html(keys_table()) + casters + texts_of(*find<Table>(of, "caster_files"));
  document.sections.insert(document.sections.end() - 1,
                           {"methods", "Methods", element("p", kMethods, {{"class", "methods"}})});
  return document;
}

Document verification_document(const findings::Section& facts) {
  const auto cases = report::verified_cases(facts);
  std::vector<figures::ToleranceRow> rows;
  for (const findings::Section* each : cases) {
    const std::string group = text_of(*each, "group");
    auto row = std::ranges::find(rows, group, &figures::ToleranceRow::label);
    if (row == rows.end()) row = rows.insert(rows.end(), {group, {}});
    const auto& checks = *findings::find<findings::Table>(*each, "checks");
    for (std::size_t i = 0; i < checks.rows.size(); ++i)
      row->used.push_back(report::used_of(checks, i));
  }
  const std::string groups = counted(rows.size(), "group");
  for (figures::ToleranceRow& row : rows)
    row.label += fmt::format(" ({})", counted(row.used.size(), "check"));
  const findings::Section of = report::verification_findings(facts);
  Document document{of.title,
                    fmt::format("{} in {}: {}", counted(cases.size(), "case"), groups,
                                text_of(facts, "passed") == "yes" ? "all passed" : "FAILED"),
                    sections_of(of, {"summary", "cases", "forms", "checks", "provenance"}),
                    {}};
  document.sections.insert(document.sections.begin() + 1, tolerances(rows));
  document.sections.at(4).content =
      folded("Every check, parameters, other solvers", document.sections.at(4).content);
  document.sections.back().content += paragraph(
      "The same program on the same class of CPU gives the same numbers, with any number of "
      "threads. gurney verify CASE prints a case in full, --figures draws computed and reference "
      "over time, --draw tries other parameters.");
  return document;
}

}  // namespace

bool is_json(const std::string& path) {
  require_regular_file(path);
  std::ifstream file(path, std::ios::binary);
  char first = 0;
  return file >> first && first == '{';
}

Document json_document(const std::string& path) {
  const config::JsonTree tree = config::read_json(read_input_file(path), path);
  const Node* const found = tree.root.find("schema");
  const std::string schema = found == nullptr ? "" : found->text;
  const FindingsReader reader(tree, path);
  if (schema == "gurney-calibration/1")
    return calibration_document(report::calibration_findings(
        reader.section(tree.root, report::example_of_calibration_facts())));
  if (schema == "gurney-verification/1")
    return verification_document(
        reader.section(tree.root, report::example_of_verification_facts()));
  throw Error(
      path + ": " +
      (schema.empty() ? "is JSON without a schema"
                      : "is JSON with schema = \"" + printable(schema) + "\"") +
      "; a report is made of a results file (HDF5), of calibration.json of gurney calibrate "
      "-o (\"gurney-calibration/1\"), or of what gurney verify --json prints "
      "(\"gurney-verification/1\")");
}

}  // namespace gurney::page
