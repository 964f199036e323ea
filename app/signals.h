#pragma once

#include "core/base/progress.h"

namespace bosk {

// While it lives, SIGINT and SIGTERM cancel `progress`. Should a stage not give way within 4 s, or
// a second signal come, the process ends at once: every file is written atomically, so nothing is
// torn by that.
class CancelOnSignals {
 public:
  explicit CancelOnSignals(Progress& progress);
  ~CancelOnSignals();
  CancelOnSignals(const CancelOnSignals&) = delete;
  CancelOnSignals& operator=(const CancelOnSignals&) = delete;
};

// The signal that came, 0 for none.
int received_signal();

}  // namespace bosk
