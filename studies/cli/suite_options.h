#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <utility>

#include "engine/base/error.h"
#include "engine/base/number_text.h"
#include "engine/config/document.h"
#include "engine/config/table.h"
#include "studies/cli/inline_table.h"

namespace gurney::cli {

/// Two numbers apart by a colon, 0 < low < high. @throws Error for anything else.
inline std::pair<double, double> span_of(const char* option, const std::string& text) {
  const auto colon = std::min(text.find(':'), text.size());
  const double low = number(text.substr(0, colon)).value_or(0);
  const double high = number(text.substr(std::min(colon + 1, text.size()))).value_or(0);
  require(0 < low && low < high,
          fmt::format("{} {}: must be LOW:HIGH with 0 < LOW < HIGH", option, text));
  return {low, high};
}

/// The value of an option such as --target "asce7 sds_g=1 sd1_g=0.6", read as a table.
/// @param table  name of the table in errors
/// @param first  key of the first word, which stands without it
/// @param read   Table& -> optional, empty where it noted an error
/// @throws Error with all errors, in terms of the option as it was typed.
template <class Read>
auto read_table_option(const std::string& option, const std::string& text, const std::string& table,
                       const std::string& first, const Read& read) {
  try {
    config::Document document(table + " = " + inline_table(first, words_of(text)) + "\n", option);
    config::Table root = document.root();
    auto in = root.table(table);
    auto value = in ? read(*in) : std::nullopt;
    document.finish();
    return *value;
  } catch (const Error& error) {
    throw Error(option_error(option, text, table, error.what()));
  }
}

}  // namespace gurney::cli
