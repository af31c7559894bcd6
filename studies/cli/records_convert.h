#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace gurney::cli {

/// Adds `gurney records convert`: records in any format to Gurney's CSV or to AT2, processed on the
/// way. @param act  is set to what the command does, once it is chosen
void add_records_convert(CLI::App& records, std::function<int()>& act);

}  // namespace gurney::cli
