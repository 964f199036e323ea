#include "core/project/pack_options.h"

namespace bosk {

Options describe(PackOptions& options) {
  return {{"name", "", "what the tree is called in its package", &options.name, 0, 0, {}},
          {"licence",
           "",
           "under which the package may be used, such as CC-BY-4.0",
           &options.licence,
           0,
           0,
           {}},
          {"credit", "", "whom to name as the author", &options.credit, 0, 0, {}}};
}

}  // namespace bosk
