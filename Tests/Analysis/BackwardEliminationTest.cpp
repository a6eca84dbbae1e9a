#include "Analysis/BackwardElimination.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>

using namespace idiophone;
using Catch::Matchers::WithinAbs;

namespace {

/// Columns: two equal ones, one that is not in the data, and one in it with factor 2.
BackwardElimination<double, 1> example() {
    Eigen::MatrixXd columns(4, 4);
    columns << 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1;
    const Eigen::Vector4d data(3, 3, 0, 2);
    BackwardElimination<double, 1> elimination;
    elimination.add(columns.transpose() * columns, columns.transpose() * data);
    return elimination;
}

} // namespace

TEST_CASE("Elimination keeps one of two equal candidates and drops those without energy") {
    auto elimination = example();
    CHECK(elimination.ownEnergy(0, 0) < 1e-6);
    elimination.run(Eigen::MatrixXd::Constant(4, 1, 0.1), 4);
    CHECK(elimination.keeps(0) != elimination.keeps(1));
    CHECK_FALSE(elimination.keeps(2));
    CHECK(elimination.keeps(3));
    const Eigen::Index twin = elimination.keeps(0) ? 0 : 1;
    CHECK_THAT(elimination.factor(twin, 0), WithinAbs(3, 1e-4));
    CHECK_THAT(elimination.factor(3, 0), WithinAbs(2, 1e-4));
    CHECK_THAT(elimination.ownEnergy(twin, 0), WithinAbs(18, 1e-3));
}

TEST_CASE("Elimination keeps the candidates of greatest energy if there are too many") {
    auto elimination = example();
    elimination.run(Eigen::MatrixXd::Constant(4, 1, 1e-30), 1);
    CHECK(elimination.keeps(0) != elimination.keeps(1));
    CHECK_FALSE(elimination.keeps(3));
}
