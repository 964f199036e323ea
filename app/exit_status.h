#pragma once

#include "core/base/error.h"

namespace bosk {

// What the process tells its caller; part of the command line's contract, so the numbers never
// change.
enum class ExitStatus {
  done = 0,
  fault = 1,          // of Bosk's own
  usage = 2,          // the command line itself is wrong
  bad_input = 3,      // don't retry unchanged
  below_quality = 4,  // done, but below the quality that was asked for
  resource = 5,       // memory or disk ran out: retry with more
  temporary = 75,     // retry later
};

inline ExitStatus exit_status(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::bad_input:
      return ExitStatus::bad_input;
    case ErrorKind::resource:
      return ExitStatus::resource;
    case ErrorKind::temporary:
      return ExitStatus::temporary;
  }
  return ExitStatus::fault;
}

}  // namespace bosk
