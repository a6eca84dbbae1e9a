#include "Analysis/NestedDissection.h"

#include "Analysis/EliminationTree.h"
#include "Analysis/TreeParts.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <numeric>
#include <random>

using namespace idiophone;

namespace {

using Pattern = Eigen::SparseMatrix<double>;

Pattern symmetricPattern(int n, const std::vector<std::pair<int, int>>& pairs) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < n; ++i)
        entries.emplace_back(i, i, 1);
    for (const auto& [a, b] : pairs) {
        entries.emplace_back(a, b, 1);
        entries.emplace_back(b, a, 1);
    }
    Pattern pattern(n, n);
    pattern.setFromTriplets(entries.begin(), entries.end());
    return pattern;
}

/// Returns a cube of `side`³ unknowns, each coupled to the up to 26 around it.
Pattern cube(int side) {
    std::vector<std::pair<int, int>> pairs;
    const int n = side * side * side;
    for (int a = 0; a < n; ++a)
        for (const int plane : {0, 1})
            for (int row = plane == 0 ? 0 : -1; row <= 1; ++row)
                for (int column = plane == 0 && row == 0 ? 1 : -1; column <= 1; ++column) {
                    const int x = a % side + column, y = a / side % side + row,
                              z = a / side / side + plane;
                    if (x >= 0 && x < side && y >= 0 && y < side && z < side)
                        pairs.emplace_back(a, (z * side + y) * side + x);
                }
    return symmetricPattern(n, pairs);
}

bool isPermutation(std::vector<int> order, int n) {
    std::vector<int> all(n);
    std::iota(all.begin(), all.end(), 0);
    std::ranges::sort(order);
    return order == all;
}

double productsOf(const EliminationTree& tree) {
    double sum = 0;
    for (const auto& node : tree.supernodes)
        sum += idiophone::productsOf(node);
    return sum;
}

} // namespace

TEST_CASE("Nested dissection orders every unknown once, whatever hangs together") {
    const int n = 3000;
    std::mt19937 generator(4);
    std::vector<std::pair<int, int>> pairs;
    const int edges = GENERATE(0, 2000, 9000);
    for (int k = 0; k < edges; ++k)
        pairs.emplace_back(generator() % n, generator() % n);
    CHECK(isPermutation(nestedDissectionOrder(symmetricPattern(n, pairs)), n));
}

TEST_CASE("Nested dissection orders a star and a complete graph") {
    const int n = 400;
    std::vector<std::pair<int, int>> star, complete;
    for (int a = 1; a < n; ++a) {
        star.emplace_back(0, a);
        for (int b = 0; b < a; ++b)
            complete.emplace_back(a, b);
    }
    for (const auto& pairs : {star, complete})
        CHECK(isPermutation(nestedDissectionOrder(symmetricPattern(n, pairs)), n));
}

TEST_CASE("A cube in halves takes at most a third of the products that it takes plane by plane") {
    const int side = 20;
    const double n = side * side * side, band = side * side + side + 1;
    CHECK(productsOf(eliminationTree(cube(side), 3)) < n * band * band / 2 / 3);
}

TEST_CASE("Parts of a tree are closed, and together with those above hold each supernode once") {
    const int side = GENERATE(6, 20);
    const auto tree = eliminationTree(cube(side), 3);
    const auto [parts, above] = treeParts(tree, 3);
    std::vector<int> owners(tree.supernodes.size(), -1);
    for (std::size_t part = 0; part < parts.size(); ++part)
        for (std::size_t s = parts[part].first; s <= parts[part].root; ++s) {
            CHECK(owners[s] == -1);
            owners[s] = static_cast<int>(part);
        }
    for (std::size_t part = 0; part < parts.size(); ++part) {
        double work = 0;
        for (std::size_t s = parts[part].first; s <= parts[part].root; ++s) {
            work += idiophone::productsOf(tree.supernodes[s]);
            if (s != parts[part].root)
                CHECK(owners[tree.supernodes[s].parent] == static_cast<int>(part));
        }
        if (side == 20)
            CHECK(work <= productsOf(tree) / 20);
    }
    CHECK(above.empty() == (side == 6));
    CHECK(std::ranges::count(owners, -1) == std::ssize(above));
    for (const std::size_t s : above)
        CHECK(owners[s] == -1);
}
