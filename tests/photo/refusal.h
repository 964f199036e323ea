#pragma once

#include <string>

#include "core/base/error.h"

namespace bosk::testing_cameras {

// The message of the Error that the call throws; says so when it throws none.
template <class Call>
std::string refusal_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "(no Error)";
}

}  // namespace bosk::testing_cameras
