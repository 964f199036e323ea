#include "app/signals.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>

namespace bosk {
namespace {

constexpr unsigned kPatienceSeconds = 4;

// The one place where a process-wide variable can't be avoided: a signal handler takes no argument.
struct SignalState {
  std::atomic<Progress*> progress{nullptr};
  std::atomic<int> signal{0};
};

SignalState& state() {
  static SignalState only;
  return only;
}

void end_at_once(int) { ::_exit(128 + state().signal.load()); }

void on_signal(int signal) {
  int none = 0;
  if (!state().signal.compare_exchange_strong(none, signal)) end_at_once(signal);
  if (Progress* progress = state().progress.load()) progress->cancel();
  ::alarm(kPatienceSeconds);
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

CancelOnSignals::CancelOnSignals(Progress& progress) {
  state().progress.store(&progress);
  handle(SIGINT, on_signal);
  handle(SIGTERM, on_signal);
  handle(SIGALRM, end_at_once);
}

CancelOnSignals::~CancelOnSignals() { state().progress.store(nullptr); }

int received_signal() { return state().signal.load(); }

}  // namespace bosk
