#pragma once

#include "core/billboard/billboard.h"
#include "core/compress/compress.h"
#include "core/package/tree_model.h"

namespace bosk {

// Puts billboards and their coded textures together as what a package holds. Cells that are pruned
// in every view are dropped; metadata.height_m is set from the highest cell that is left (of the
// finest level that has one). Throws Error when the two don't belong together.
TreeModel assemble_tree(const Billboards& billboards, const CodedTextures& textures,
                        const TreeMetadata& metadata);

}  // namespace bosk
