// Divides an elimination tree among threads. Internal to Analysis.
#pragma once

#include "Analysis/EliminationTree.h"

namespace idiophone {

/// A subtree: the supernodes from `first` to `root`.
struct TreePart {
    std::size_t first = 0, root = 0;
};

/// Independent parts and the supernodes above them. A small tree is one part for each root.
struct TreeParts {
    std::vector<TreePart> parts;
    std::vector<std::size_t> above; ///< ascending
};

/// Divides a tree until no part has more than a small share of the work. The result does not depend
/// on the machine.
TreeParts treeParts(const EliminationTree& tree, int blockSize);

/// Returns the number of products of blocks that eliminate a supernode.
double productsOf(const Supernode& node);

} // namespace idiophone
