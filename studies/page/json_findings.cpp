#include "studies/page/json_findings.h"

#include <fstream>
#include <limits>

#include "engine/base/error.h"
#include "engine/base/input_file.h"
#include "engine/base/printable.h"
#include "engine/config/json_reader.h"
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
