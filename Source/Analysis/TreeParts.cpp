#include "Analysis/TreeParts.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr double largestPart = 1.0 / 24;  ///< share of the work
constexpr double smallTreeProducts = 4e7; ///< less would not pay for threads

} // namespace

double productsOf(const Supernode& node) {
    double sum = 0;
    for (int i = 0; i < node.width; ++i)
        sum += std::pow(node.width - i + static_cast<double>(node.below.size()), 2) / 2;
    return sum;
}

TreeParts treeParts(const EliminationTree& tree, int blockSize) {
    const std::size_t count = tree.supernodes.size();
    std::vector<double> work(count);
    std::vector<std::size_t> first(count);
    double all = 0;
    for (std::size_t s = 0; s < count; ++s) {
        const auto& node = tree.supernodes[s];
        const double own = productsOf(node);
        all += own;
        work[s] += own;
        first[s] = node.children.empty() ? s : first[node.children.front()]; // contiguous
        if (node.parent >= 0)
            work[node.parent] += work[s];
    }
    const bool isSmall = all * std::pow(blockSize, 3) < smallTreeProducts;
    std::vector<bool> isAbove(count);
    TreeParts result;
    for (std::size_t s = count; s-- > 0;) {
        const int parent = tree.supernodes[s].parent;
        if (parent >= 0 && !isAbove[parent])
            continue;
        isAbove[s] = !isSmall && work[s] > largestPart * all;
        if (isAbove[s])
            result.above.push_back(s);
        else
            result.parts.push_back({first[s], s});
    }
    std::ranges::reverse(result.above);
    std::ranges::reverse(result.parts);
    return result;
}

} // namespace idiophone
