#include "Analysis/EliminationTree.h"

#include "Analysis/NestedDissection.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace idiophone {
namespace {

using Pattern = Eigen::SparseMatrix<double>;

constexpr Eigen::Index minimumDegreeUpTo =
    6000; ///< unknowns; nested dissection gains nothing below

std::vector<int> inverse(const std::vector<int>& order) {
    std::vector<int> place(order.size());
    for (int i = 0; i < static_cast<int>(order.size()); ++i)
        place[order[i]] = i;
    return place;
}

/// Returns the parent of each unknown in the elimination tree, or −1 (Liu 1986).
std::vector<int> parents(const Pattern& symmetric, const std::vector<int>& original) {
    const auto place = inverse(original);
    std::vector<int> parent(original.size(), -1), ancestor(original.size(), -1);
    for (int k = 0; k < static_cast<int>(original.size()); ++k)
        for (Pattern::InnerIterator entry(symmetric, original[k]); entry; ++entry)
            for (int i = place[entry.row()]; i >= 0 && i < k;) {
                const int next = ancestor[i];
                ancestor[i] = k;
                if (next < 0)
                    parent[i] = k;
                i = next;
            }
    return parent;
}

/// Returns an order in which every subtree is contiguous.
std::vector<int> postorder(const std::vector<int>& parent) {
    const int n = static_cast<int>(parent.size());
    std::vector<std::vector<int>> children(n);
    std::vector<int> stack, order;
    for (int i = n; i-- > 0;)
        (parent[i] < 0 ? stack : children[parent[i]]).push_back(i);
    // Depth first, children before parents.
    while (!stack.empty()) {
        const int node = stack.back();
        if (children[node].empty()) {
            order.push_back(node);
            stack.pop_back();
        } else {
            std::vector<int> next;
            next.swap(children[node]);
            stack.insert(stack.end(), next.begin(), next.end());
        }
    }
    return order;
}

/// Returns the later unknowns coupled to each one, merged from its children in the tree.
std::vector<std::vector<int>> structures(const Pattern& symmetric, const EliminationTree& tree) {
    const int n = static_cast<int>(tree.original.size());
    std::vector<std::vector<int>> below(n), children(n);
    std::vector<int> flag(n, -1);
    for (int k = 0; k < n; ++k) {
        flag[k] = k;
        const auto meet = [&](int i) {
            if (i > k && flag[i] != k) {
                flag[i] = k;
                below[k].push_back(i);
            }
        };
        for (Pattern::InnerIterator entry(symmetric, tree.original[k]); entry; ++entry)
            meet(tree.place[entry.row()]);
        for (const int child : children[k])
            std::ranges::for_each(below[child], meet);
        std::ranges::sort(below[k]);
        if (!below[k].empty())
            children[below[k].front()].push_back(k);
    }
    return below;
}

/// Returns whether larger dense matrices make up for work on zeros (CHOLMOD's rule).
bool isWorthJoining(double zeros, double entries, int scalarColumns) {
    const double share = zeros / entries;
    return share == 0 || (scalarColumns <= 12 && share < 0.8) ||
           (scalarColumns <= 32 && share < 0.2) || (scalarColumns <= 96 && share < 0.05);
}

std::vector<Supernode> supernodes(std::vector<std::vector<int>> below, int blockSize) {
    std::vector<Supernode> nodes;
    std::vector<double> zeros;
    for (int k = 0; k < static_cast<int>(below.size()); ++k) {
        Supernode node{
            .first = k, .width = 1, .parent = -1, .below = std::move(below[k]), .children = {}};
        double zero = 0;
        while (!nodes.empty()) {
            const auto& child = nodes.back();
            if (child.below.empty() || child.below.front() > k)
                break;
            const double width = child.width + node.width;
            const double rows = static_cast<double>(node.width + node.below.size());
            const double more = child.width * (rows - static_cast<double>(child.below.size())) +
                                zeros.back() + zero;
            const double entries =
                width * (width + 1) / 2 + width * static_cast<double>(node.below.size());
            if (!isWorthJoining(more, entries, static_cast<int>(width) * blockSize))
                break;
            node.first = child.first;
            node.width = static_cast<int>(width);
            zero = more;
            nodes.pop_back();
            zeros.pop_back();
        }
        nodes.push_back(std::move(node));
        zeros.push_back(zero);
    }
    return nodes;
}

void joinFamilies(EliminationTree& tree) {
    std::vector<int> owner(tree.original.size());
    for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s)
        std::fill_n(owner.begin() + tree.supernodes[s].first, tree.supernodes[s].width, s);
    for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s)
        if (auto& node = tree.supernodes[s]; !node.below.empty()) {
            node.parent = owner[node.below.front()];
            tree.supernodes[node.parent].children.push_back(s);
        }
}

} // namespace

EliminationTree eliminationTree(const Eigen::SparseMatrix<double>& places, int blockSize) {
    const Pattern transposed = places.transpose();
    const Pattern symmetric = places.cwiseAbs() + transposed.cwiseAbs();
    EliminationTree tree;
    tree.original = symmetric.cols() > minimumDegreeUpTo ? nestedDissectionOrder(symmetric)
                                                         : minimumDegreeOrder(symmetric);
    std::vector<int> ordered;
    for (const int i : postorder(parents(symmetric, tree.original)))
        ordered.push_back(tree.original[i]);
    tree.original = std::move(ordered);
    tree.place = inverse(tree.original);
    tree.supernodes = supernodes(structures(symmetric, tree), blockSize);
    joinFamilies(tree);
    return tree;
}

} // namespace idiophone
