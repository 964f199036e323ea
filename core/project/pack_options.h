#pragma once

#include <string>

#include "core/base/options.h"

namespace bosk {

// What the package says about the tree.
struct PackOptions {
  std::string name;  // `bosk new` sets it to the project folder's name
  std::string licence, credit;
};
Options describe(PackOptions& options);

}  // namespace bosk
