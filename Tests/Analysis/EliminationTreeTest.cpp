#include "Analysis/EliminationTree.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <random>
#include <set>

using namespace idiophone;

namespace {

/// Returns a lower triangle with a full diagonal and about `perColumn` random entries per column.
Eigen::SparseMatrix<double> randomPlaces(int n, double perColumn, unsigned seed) {
    std::mt19937 generator(seed);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        entries.emplace_back(i, i, 1);
    for (int k = 0; k < static_cast<int>(perColumn * n); ++k) {
        const int a = static_cast<int>(generator() % n), b = static_cast<int>(generator() % n);
        entries.emplace_back(std::max(a, b), std::min(a, b), 1);
    }
    Eigen::SparseMatrix<double> places(n, n);
    places.setFromTriplets(entries.begin(), entries.end());
    return places;
}

/// Returns, for each unknown, the later unknowns that it couples to once all unknowns before it are
/// eliminated. Eliminates explicitly.
std::vector<std::set<int>> fill(const Eigen::SparseMatrix<double>& places,
                                const std::vector<int>& place) {
    std::vector<std::set<int>> below(place.size());
    for (int column = 0; column < places.outerSize(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator e(places, column); e; ++e)
            if (e.row() != column)
                below[std::min(place[e.row()], place[column])].insert(
                    std::max(place[e.row()], place[column]));
    for (auto& own : below)
        if (!own.empty())
            below[*own.begin()].insert(std::next(own.begin()), own.end());
    return below;
}

} // namespace

TEST_CASE("The elimination order has every unknown once, and its inverse is correct") {
    const auto places = randomPlaces(300, GENERATE(0.0, 0.8, 2.5), 2);
    const auto tree = eliminationTree(places, 3);
    REQUIRE(tree.original.size() == 300);
    REQUIRE(tree.place.size() == 300);
    for (int i = 0; i < 300; ++i)
        CHECK(tree.place[tree.original[i]] == i);
}

TEST_CASE("Supernodes cover all fill, and at most four fifths of their entries are zeros") {
    const auto places = randomPlaces(400, GENERATE(0.5, 1.0, 1.6), GENERATE(1u, 2u));
    const int blockSize = GENERATE(1, 6);
    const auto tree = eliminationTree(places, blockSize);
    const auto needed = fill(places, tree.place);
    std::size_t stored = 0, filled = 0;
    int next = 0;
    for (const auto& node : tree.supernodes) {
        REQUIRE(node.first == next);
        next += node.width;
        CHECK(std::ranges::is_sorted(node.below));
        for (int i = node.first; i < next; ++i) {
            filled += needed[i].size();
            stored += static_cast<std::size_t>(next - i - 1) + node.below.size();
            for (const int j : needed[i])
                REQUIRE((j < next || std::ranges::binary_search(node.below, j)));
        }
    }
    CHECK(next == 400);
    CHECK(stored + 400 <= 5 * (filled + 400));
}

TEST_CASE("A supernode's parent comes after it, takes all its rows and lists it as a child") {
    const auto tree = eliminationTree(randomPlaces(400, 1.3, 4), 3);
    std::size_t children = 0, withParent = 0;
    for (int s = 0; s < static_cast<int>(tree.supernodes.size()); ++s) {
        const auto& node = tree.supernodes[s];
        children += node.children.size();
        CHECK((node.parent < 0) == node.below.empty());
        if (node.parent < 0)
            continue;
        ++withParent;
        REQUIRE(node.parent > s);
        const auto& parent = tree.supernodes[node.parent];
        CHECK(std::ranges::count(parent.children, s) == 1);
        for (const int row : node.below)
            CHECK(((row >= parent.first && row < parent.first + parent.width) ||
                   std::ranges::binary_search(parent.below, row)));
    }
    CHECK(children == withParent);
}

TEST_CASE("A tree is eliminated with almost no fill") {
    const int n = 500;
    std::mt19937 generator(9);
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        entries.emplace_back(i, i, 1);
    for (int i = 1; i < n; ++i)
        entries.emplace_back(i, static_cast<int>(generator() % i), 1);
    Eigen::SparseMatrix<double> places(n, n);
    places.setFromTriplets(entries.begin(), entries.end());
    int filled = 0;
    for (const auto& below : fill(places, eliminationTree(places, 1).place))
        filled += static_cast<int>(below.size());
    CHECK(filled >= n - 1);
    CHECK(filled < 1.2 * n); // minimum degrees are approximate
}
