// Tests where the objects of a kit stand in the picture.
#include "Editor/ObjectShelf.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using enum KeyboardForm;

TEST_CASE("Objects of mixed forms stand on a shelf, and keyboards with a guest do not") {
    CHECK(keyboardForm({0.3, 0.04, 0.02}, false) == bar);
    CHECK(keyboardForm({0.04, 0.04, 1.2}, false) == chime);
    CHECK(keyboardForm({0.05, 0.01, 0.001}, true) == tine);
    CHECK(keyboardForm({0.1, 0.1, 0.05}, false) == other);
    CHECK(standOnShelf(std::vector{bar, other, chime}));
    CHECK(standOnShelf(std::vector{bar, bar, other}));
    CHECK_FALSE(standOnShelf(std::vector{bar, bar, bar, other}));
    CHECK_FALSE(standOnShelf(std::vector{other, other}));
}

TEST_CASE("Objects on a shelf stand on the floor beside each other, in rows, small ones enlarged") {
    std::vector<Eigen::Vector3d> sizes;
    for (int i = 0; i < 24; ++i)
        sizes.emplace_back(0.02 * (1 + i % 7), 0.03 * (1 + i % 4), 0.05 * (1 + i % 3));
    sizes.emplace_back(2, 1, 0.5);
    const auto places = shelfPlaces(sizes);
    REQUIRE(places.size() == sizes.size());
    double width = 0, depth = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Eigen::Vector3d size = places[i].scale * sizes[i];
        CHECK(places[i].middle.z() == size.z() / 2);
        width = std::max(width, 2 * std::abs(places[i].middle.x()) + size.x());
        depth = std::max(depth, places[i].middle.y() + size.y() / 2);
        for (std::size_t j = 0; j < i; ++j) {
            const Eigen::Vector3d apart = (places[i].middle - places[j].middle).cwiseAbs();
            const Eigen::Vector3d reach = (size + places[j].scale * sizes[j]) / 2;
            CHECK((apart.x() > reach.x() || apart.y() > reach.y()));
        }
    }
    CHECK(width < 4 * depth);
    CHECK(depth < 4 * width);
    CHECK(places.back().scale < 0.5);
    CHECK(places.front().scale > 1);
    CHECK(shelfPlaces({}).empty());
}
