#pragma once

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

}  // namespace gurney::cli
