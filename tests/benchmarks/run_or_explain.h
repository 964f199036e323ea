#pragma once

#include <iostream>

#include "core/base/error.h"

namespace bosk {

// The exit status of `run`; 3 and the reason where it throws Error.
inline int run_or_explain(int (*run)(int, char**), int count, char** arguments) {
  try {
    return run(count, arguments);
  } catch (const Error& error) {
    std::cerr << error.what() << "\n";
    return 3;
  }
}

}  // namespace bosk
