#include "studies/loss/consequences.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/names.h"
#include "engine/base/random/draw.h"
#include "engine/config/nearest_name.h"
#include "engine/config/table.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/data_folder.h"
#include "equipment/catalogue/quantity.h"
#include "studies/limit_states/limit_state_reader.h"

namespace gurney::study {
namespace {

using config::Range;
using config::Table;

constexpr const char* kSchema = "gurney-consequences/1";
const std::vector<std::string> kInjuries = {"none", "minor", "serious"},
                               kServices = {"kept", "check", "lost"};
constexpr int kFirstYear = 1900, kLastYear = 2200;

Consequence read_consequence(Table& in) {
  equipment::Quantities quantities(in);
  Consequence read;
  read.cost_ratio = quantities.number("cost_ratio", Range::not_negative());
  read.days = quantities.number("days", Range::not_negative());
  read.injury = static_cast<Injury>(in.choice("injury", kInjuries));
  read.service = static_cast<Service>(in.choice("service", kServices));
  return read;
}

/// ISO 4217: three capitals. It is printed as it stands, never converted.
std::string read_currency(Table& root) {
  const std::string currency = root.text("currency");
  const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
  if (root.is_text("currency") &&
      !(currency.size() == 3 && std::ranges::all_of(currency, is_capital)))
    root.note("currency",
              " = \"" + currency + "\": must be a code of three capitals, such as \"EUR\"");
  return currency;
}

}  // namespace

const char* name_of(Injury injury) { return kInjuries[static_cast<std::size_t>(injury)].c_str(); }
const char* name_of(Service service) {
  return kServices[static_cast<std::size_t>(service)].c_str();
}

double mean_of(const equipment::StatedQuantity& quantity) {
  return quantity.uncertainty ? quantity.uncertainty->distribution.mean() : quantity.value;
}

double sampled(const equipment::StatedQuantity& quantity, const std::string& name,
               std::uint64_t seed, std::uint64_t sample) {
  if (!quantity.uncertainty) return quantity.value;
  const equipment::Uncertainty& of = *quantity.uncertainty;
  return of.distribution.quantile(Draw(seed, sample).probability(name, of.group));
}

Consequences Consequences::read(const std::string& path) {
  config::Document document(path);
  return read(document);
}

Consequences Consequences::read(config::Document& document) {
  equipment::refuse_other_kind(document, kSchema);
  Table root = document.root();
  root.choice("schema", {kSchema});
  root.text("title", "");
  Consequences all;
  all.path_ = document.path();
  all.currency_ = read_currency(root);
  all.year_ = root.integer("year", kFirstYear, kLastYear);
  if (!root.has("limit_state"))
    root.note("limit_state", ": must be given: tables [[limit_state]]");
  else
    all.states_ = read_limit_states(root);
  for (Table each : root.tables("price")) {
    const std::string item = each.text("item");
    const auto price = equipment::Quantities(each).number("price", Range::positive());
    if (!all.prices_.emplace(item, price).second)
      each.note("item", " = \"" + item + "\": has a price already");
  }
  if (all.prices_.empty()) root.note("price", ": must be given: tables [[price]]");
  const std::vector<std::string> names = names_of(all.states_);
  for (Table each : root.tables("consequence")) {
    Row row{each.choice("limit_state", names), each.texts("items"), read_consequence(each)};
    for (std::size_t i = 0; i < row.items.size(); ++i)
      if (!all.prices_.contains(row.items[i])) {
        const std::string near = config::suggestion(row.items[i], all.priced_items());
        if (each.is_array("items"))
          each.note_element("items", i, ": has no price" + near);
        else
          each.note("items", fmt::format(" = \"{}\": has no price{}", row.items[i], near));
      }
    all.rows_.push_back(std::move(row));
  }
  if (all.rows_.empty()) root.note("consequence", ": must be given: tables [[consequence]]");
  document.finish();
  return all;
}

std::string Consequences::money() const { return fmt::format("{} ({})", currency_, year_); }

const equipment::StatedQuantity* Consequences::price_of(const std::string& item) const {
  const auto found = prices_.find(item);
  return found == prices_.end() ? nullptr : &found->second;
}

std::vector<std::string> Consequences::priced_items() const {
  std::vector<std::string> names;
  for (const auto& [name, price] : prices_) names.push_back(name);
  return names;
}

const Consequence* Consequences::of(const std::string& item, std::size_t state) const {
  const Consequence* found = nullptr;
  for (const Row& row : rows_)
    if (row.state == state &&
        (row.items.empty() || std::ranges::find(row.items, item) != row.items.end()))
      found = &row.consequence;
  return found;
}

std::string usual_consequences() {
  return equipment::find_data_folder().path + "/equipment/consequences.toml";
}

}  // namespace gurney::study
