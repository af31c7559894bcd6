#include "studies/report/report_table.h"

#include <fmt/format.h>

#include <cmath>

namespace gurney::report {
namespace {

std::string with(const std::string& spec, const auto& value) {
  return fmt::format(fmt::runtime("{:" + spec + "}"), value);
}

std::string written(const ReportColumn& column, const ReportTable::Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* count = std::get_if<std::size_t>(&cell)) return std::to_string(*count);
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? with(column.form, column.factor * number) : "-";
}

/// `|` would end a cell.
std::string escaped(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
    text.insert(at, "\\");
  return text;
}

}  // namespace

std::string ReportTable::text() const {
  std::string all;
  const auto line = [&](const auto& cell_of) {
    std::string cells;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (!columns_[i].title.empty())
        cells += (cells.empty() ? "" : " ") + with(columns_[i].align, cell_of(i));
    all += cells + "\n";
  };
  line([&](std::size_t i) { return columns_[i].title; });
  for (const std::vector<Cell>& row : rows_)
    line([&](std::size_t i) { return written(columns_[i], row.at(i)); });
  return all;
}

std::string ReportTable::markdown() const {
  std::string all;
  const auto line = [&](const auto& cell_of) {
    all += '|';
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (!columns_[i].title.empty()) all += " " + cell_of(i) + " |";
    all += '\n';
  };
  line([&](std::size_t i) { return columns_[i].title; });
  line([](std::size_t) { return std::string("---"); });
  for (const std::vector<Cell>& row : rows_)
    line([&](std::size_t i) { return escaped(written(columns_[i], row.at(i))); });
  return all;
}

nlohmann::ordered_json ReportTable::json() const {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const std::vector<Cell>& row : rows_) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < columns_.size(); ++i)
      if (!columns_[i].key.empty())
        std::visit([&](const auto& value) { object[columns_[i].key] = value; }, row.at(i));
    all.push_back(std::move(object));
  }
  return all;
}

}  // namespace gurney::report
