#include "Analysis/PanelPotentials.h"

#include "Analysis/BoundaryRow.h"
#include "Geometry/ParametricMesh.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

Eigen::Matrix3d corners() {
    Eigen::Matrix3d result;
    result << 0.1, 1.2, 0.4, -0.2, 0.3, 1.1, 0.5, 0.2, 0.9;
    return result;
}

Eigen::Vector3d normalOf(const Eigen::Matrix3d& c) {
    return (c.col(1) - c.col(0)).cross(c.col(2) - c.col(0)).normalized();
}

} // namespace

TEST_CASE("The closed forms equal sums over many small triangles") {
    const auto triangle = corners();
    const auto normal = normalOf(triangle);
    const double area =
        (triangle.col(1) - triangle.col(0)).cross(triangle.col(2) - triangle.col(0)).norm() / 2;
    for (const Eigen::Vector3d& point :
         {Eigen::Vector3d(0.6, 0.4, 1.3), Eigen::Vector3d(-1, 0.2, 0),
          Eigen::Vector3d(0.5, 0.5, 0.1)}) {
        constexpr int n = 300;
        double single = 0, layer = 0;
        Eigen::Vector3d singleGradient = Eigen::Vector3d::Zero(), layerGradient = singleGradient;
        const auto add = [&](double u, double v) {
            const Eigen::Vector3d apart = point - triangle * Eigen::Vector3d(1 - u - v, u, v);
            const double r = apart.norm(), share = area / (n * n) / (4 * std::numbers::pi);
            single += share / r;
            layer += share * normal.dot(apart) / std::pow(r, 3);
            singleGradient -= share * apart / std::pow(r, 3);
            layerGradient +=
                share * (normal / std::pow(r, 3) - 3 * normal.dot(apart) * apart / std::pow(r, 5));
        };
        for (int a = 0; a < n; ++a)
            for (int b = 0; a + b < n; ++b) {
                add((a + 1.0 / 3) / n, (b + 1.0 / 3) / n);
                if (a + b + 1 < n)
                    add((a + 2.0 / 3) / n, (b + 2.0 / 3) / n);
            }
        const auto actual = panelPotentials(triangle, normal, point);
        CHECK_THAT(actual.singleLayer, WithinRel(single, 1e-4));
        CHECK_THAT(actual.doubleLayer, WithinRel(layer, 1e-4));
        CHECK((actual.singleLayerGradient - singleGradient).norm() < 1e-4 * singleGradient.norm());
        CHECK((actual.doubleLayerGradient - layerGradient).norm() < 1e-4 * layerGradient.norm());
    }
}

TEST_CASE("Uniform layers on a closed surface give -1 inside, 0 outside, and no field") {
    const auto panels = boundaryPanels(boxMesh({1, 2, 3}, {2, 3, 4}));
    for (const bool isInside : {true, false}) {
        const Eigen::Vector3d point(0.1, isInside ? 0.2 : 1.3, -0.3);
        double layer = 0;
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        for (const auto& panel : panels) {
            const auto potentials = panelPotentials(panel.corners, panel.normal, point);
            layer += potentials.doubleLayer;
            gradient += potentials.doubleLayerGradient;
        }
        CHECK_THAT(layer, WithinAbs(isInside ? -1 : 0, 1e-12));
        CHECK(gradient.norm() < 1e-12);
    }
}

TEST_CASE("In its own plane a triangle's double layer is zero and its field is a finite part") {
    const auto triangle = corners();
    const auto normal = normalOf(triangle);
    const Eigen::Vector3d centroid = triangle.rowwise().mean();
    const auto at = panelPotentials(triangle, normal, centroid);
    CHECK(at.doubleLayer == 0);
    CHECK_THAT(at.singleLayerGradient.dot(normal), WithinAbs(0, 1e-12));
    CHECK(at.doubleLayerGradient.dot(normal) < 0);
    // The value is the limit from either side.
    for (const double side : {-1e-5, 1e-5}) {
        const auto beside = panelPotentials(triangle, normal, centroid + side * normal);
        CHECK_THAT(beside.doubleLayerGradient.dot(normal),
                   WithinRel(at.doubleLayerGradient.dot(normal), 1e-4));
        CHECK_THAT(beside.doubleLayer, WithinAbs(side > 0 ? 0.5 : -0.5, 1e-3));
    }
}
