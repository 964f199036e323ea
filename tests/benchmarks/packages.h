#pragma once

#include <memory>
#include <vector>

#include "core/package/reader.h"
#include "core/render/prepared_tree.h"

namespace bosk {

// Packages named on the command line, ready for drawing.
struct Packages {
  std::vector<TreeModel> models;
  std::vector<std::shared_ptr<const PreparedTree>>
      trees;  // of the models, which stay where they are
};

inline Packages load_packages(int count, char** paths) {
  Packages packages;
  packages.models.reserve(std::size_t(count));
  packages.trees.reserve(std::size_t(count));
  for (int i = 0; i < count; ++i) packages.models.push_back(load_tree(paths[i]));
  for (const TreeModel& model : packages.models)
    packages.trees.push_back(std::make_shared<PreparedTree>(model));
  return packages;
}

}  // namespace bosk
