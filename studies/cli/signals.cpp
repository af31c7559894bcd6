#include "studies/cli/signals.h"

#include <signal.h>
#include <unistd.h>

#include <string_view>

namespace gurney::cli {
namespace {

extern "C" void leave(int signal_number) {
  constexpr std::string_view kMessage = "gurney: interrupted\n";
  [[maybe_unused]] const auto ignored = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  _exit(128 + signal_number);
}

volatile sig_atomic_t noted = 0;

extern "C" void note(int signal_number) {
  if (noted != 0) leave(signal_number);
  noted = signal_number;
}

void handle_with(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

sigset_t interruptions() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

}  // namespace

void handle_signals() {
  handle_with(leave);
  signal(SIGXFSZ, SIG_IGN);
}

void note_interruptions() { handle_with(note); }

int interruption() { return noted; }

SignalsHeld::SignalsHeld() {
  const sigset_t set = interruptions();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

SignalsHeld::~SignalsHeld() {
  const sigset_t set = interruptions();
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace gurney::cli
