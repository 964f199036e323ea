#include "ui/workstation/worker_priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace bosk {
namespace {

constexpr int kNiceness = 10;  // the interface thread runs at 0; 19 would starve

}  // namespace

void yield_to_interface() {
  // On Linux niceness belongs to a thread
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNiceness);
}

}  // namespace bosk
