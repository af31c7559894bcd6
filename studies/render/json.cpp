#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/base/printable.h"
#include "engine/base/utf8.h"
#include "studies/render/render.h"

namespace gurney::render {
namespace {

using namespace findings;
using Json = nlohmann::ordered_json;

/// A name of a file may have bytes that are not UTF-8, which JSON cannot have.
Json text(const std::string& of) {
  for (std::string_view rest = of; !rest.empty();) {
    const std::size_t length = utf8_length(rest);
    if (length == 0) return printable(of);
    rest.remove_prefix(length);
  }
  return of;
}

Json texts(const Texts& of) {
  Json all = Json::array();
  for (const std::string& each : of) all.push_back(text(each));
  return all;
}

Json value_json(const Value& value, const Format& format) {
  const auto number = [&](double of) {
    return std::isfinite(of) ? Json(of / format.json_unit) : Json(nullptr);
  };
  const auto numbers = [&](const Numbers& of) {
    Json all = Json::array();
    for (const double each : of) all.push_back(number(each));
    return all;
  };
  if (const auto* of = std::get_if<bool>(&value)) return *of;
  if (const auto* of = std::get_if<std::int64_t>(&value)) return *of;
  if (const auto* of = std::get_if<double>(&value)) return number(*of);
  if (const auto* of = std::get_if<std::string>(&value)) return text(*of);
  if (const auto* of = std::get_if<Counts>(&value)) return *of;
  if (const auto* of = std::get_if<Texts>(&value)) return texts(*of);
  if (const auto* of = std::get_if<std::vector<Texts>>(&value)) {
    Json all = Json::array();
    for (const Texts& each : *of) all.push_back(texts(each));
    return all;
  }
  if (const auto* of = std::get_if<Numbers>(&value)) return numbers(*of);
  if (const auto* of = std::get_if<std::vector<Numbers>>(&value)) {
    Json all = Json::array();
    for (const Numbers& each : *of) all.push_back(numbers(each));
    return all;
  }
  return nullptr;
}

void put(Json& object, const std::string& key, Json value) {
  const std::size_t dot = key.find('.');
  if (dot == std::string::npos)
    object[key] = std::move(value);
  else
    object[key.substr(0, dot)][key.substr(dot + 1)] = std::move(value);
}

/// An object of dotted keys without any value becomes null.
void drop_empty(Json& row, const std::vector<Column>& columns) {
  for (const Column& column : columns) {
    const std::size_t dot = column.key.find('.');
    if (dot == std::string::npos) continue;
    Json& inner = row[column.key.substr(0, dot)];
    if (std::ranges::all_of(inner, [](const Json& each) { return each.is_null(); }))
      inner = nullptr;
  }
}

Json table_json(const Table& table, bool by_name) {
  Json all = by_name ? Json::object() : Json::array();
  for (const auto& row : table.rows) {
    Json object = Json::object();
    for (std::size_t i = by_name ? 1 : 0; i < table.columns.size(); ++i)
      if (!table.columns[i].key.empty())
        put(object, table.columns[i].key,
            value_json(row.at(i).value, row[i].format_in(table.columns[i])));
    drop_empty(object, table.columns);
    if (by_name)
      all[std::get<std::string>(row.front().value)] = std::move(object);
    else
      all.push_back(std::move(object));
  }
  return all;
}

/// Takes the mark at the end of a key.
bool take_mark(std::string& key, const char* mark) {
  if (!key.ends_with(mark)) return false;
  key.resize(key.size() - 2);
  return true;
}

void fill(Json& object, const Section& section) {
  for (const Part& part : section.parts) {
    if (const auto* fact = std::get_if<Fact>(&part); fact && !fact->key.empty())
      object[fact->key] = value_json(fact->value, fact->format);
    if (const auto* list = std::get_if<List>(&part); list && !list->key.empty())
      object[list->key] = texts(list->lines);
    if (const auto* table = std::get_if<Table>(&part); table && !table->key.empty()) {
      std::string key = table->key;
      const bool by_name = take_mark(key, "{}");
      if (key.empty())
        object.update(table_json(*table, by_name));
      else
        object[key] = table_json(*table, by_name);
    }
    const auto* inner = std::get_if<Section>(&part);
    if (inner == nullptr) continue;
    std::string key = inner->key;
    if (key.empty()) {
      fill(object, *inner);
      continue;
    }
    Json of = Json::object();
    fill(of, *inner);
    if (take_mark(key, "[]"))
      object[key].push_back(std::move(of));
    else
      object[key] = std::move(of);
  }
}

/// Names in files may have bytes that are not UTF-8.
std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string json(const Section& section) {
  Json object = Json::object();
  fill(object, section);
  return dumped(object);
}

std::string json(const std::vector<Section>& sections) {
  Json all = Json::array();
  for (const Section& each : sections) {
    Json object = Json::object();
    fill(object, each);
    all.push_back(std::move(object));
  }
  return dumped(all);
}

}  // namespace gurney::render
