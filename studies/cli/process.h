#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "engine/base/printable.h"

namespace gurney::cli {

/// From now on SIGINT and SIGTERM end the program with 130 and 143 (128 + number) and a word on
/// stderr, and a write beyond the largest file size is an error instead of a signal.
void handle_signals();

/// From now on the first SIGINT or SIGTERM is only noted, for work that ends by itself soon; the
/// second ends the program as before.
void note_interruptions();

/// The signal that was noted; 0: none.
int interruption();

/// While one exists, SIGINT and SIGTERM wait: files are not left half-written.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
};

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
