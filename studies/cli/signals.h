#pragma once

namespace gurney {

/// From now on SIGINT and SIGTERM end the program with 130 and 143 (128 + number) and a word on
/// stderr, and a write beyond the largest file size is an error instead of a signal.
void handle_signals();

/// While one exists, SIGINT and SIGTERM wait: files are not left half-written.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
};

}  // namespace gurney
