#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "engine/base/printable.h"

namespace gurney::cli {

/// Opens what of standard input, output and error the program was started without, so that no file
/// of a study gets their numbers. Standard output then refuses what is written to it.
void open_standard_files();

/// Writes to standard error. Where that is full or closed the text is lost and the work goes on.
void write_error(const std::string& text);

/// Writes lines to standard error, with what a terminal would obey made visible and long ones cut.
template <class... Values>
void print_error(fmt::format_string<Values...> format, Values&&... values) {
  write_error(shortened(printable(fmt::format(format, std::forward<Values>(values)...))));
}

}  // namespace gurney::cli
