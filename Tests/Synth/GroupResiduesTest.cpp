#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr std::array<float, 3> pushIn{0, 0, -0.5f};

/// Three modes, heard from left and right.
ModalObject radiatingObject() {
    ModalObject object = ringingObject({300, 700, 1900}, 10, {1, 2, 3});
    object.radiation.directions = {{0.8f, -0.6f, 0}, {0.8f, 0.6f, 0}};
    object.radiation.frequencyRatios = {1, 2};
    object.radiation.weights = {{0.2f, 0.1f},  {0.1f, 0.5f}, {-0.1f, 0.3f}, 0, 0, 0,
                                {0.6f, -0.2f}, 0.1f,         {0, 0.4f},     0, 0, 0};
    return object;
}

std::complex<float> residue(const ResonatorParts& parts, std::size_t g) {
    return {parts.scratch.groupResidues[0].re[g], parts.scratch.groupResidues[0].im[g]};
}

} // namespace

TEST_CASE("A near residue is the driven times the listening component of the shape") {
    ResonatorParts parts(ringingObject({300, 700}, 10, {2, 3}));
    StrikePoint oblique;
    oblique.normal = {0.8f, 0, 0.6f};
    REQUIRE(parts.residues.compute(oblique, pushIn, {.nearGain = 10}));
    CHECK(std::abs(residue(parts, 0) - 10 * 0.5f * 0.6f * 4.0f) < 1e-5f);
    CHECK(std::abs(residue(parts, 1) - 10 * 0.5f * 0.6f * 9.0f) < 1e-5f);
    CHECK(residue(parts, 2) == 0.0f); // padding
}

TEST_CASE("A far residue carries the weight of its direction, or of the mean direction in mono") {
    ResonatorParts parts(radiatingObject());
    const auto& weights = parts.object.radiation.weights;
    StrikePoint point;
    for (const std::int32_t direction : {-1, 0, 1}) {
        point.radiationDirection = direction;
        REQUIRE(parts.residues.compute(point, pushIn, {.farGain = 4, .farShare = 1}));
        for (std::size_t g = 0; g < 3; ++g) {
            const std::complex<float> left = weights[g], right = weights[6 + g];
            const auto weight = direction < 0    ? (left + right) / 2.0f
                                : direction == 0 ? left
                                                 : right;
            const float driven = -0.5f * static_cast<float>(g + 1);
            CHECK(std::abs(residue(parts, g) - 4 * driven * weight) < 1e-6f);
        }
    }
}

TEST_CASE("A change of the radiation ratio changes far residues and leaves near ones") {
    ResonatorParts parts(radiatingObject());
    parts.residues.setRadiationRatio(2); // all weights of the table are 0 there
    REQUIRE(parts.residues.compute({}, pushIn, {.farShare = 1}));
    CHECK(residue(parts, 0) == 0.0f);
    REQUIRE(parts.residues.compute({}, pushIn, {.farShare = 0}));
    CHECK(std::abs(residue(parts, 0) - 0.5f) < 1e-6f);
}

TEST_CASE("A blend interpolates the magnitudes of near and far residues") {
    ResonatorParts parts(radiatingObject());
    std::array<std::complex<float>, 3> near, far;
    const auto compute = [&](double farShare, auto& residues) {
        REQUIRE(parts.residues.compute({}, pushIn, {.farGain = 4, .farShare = farShare}));
        for (std::size_t g = 0; g < 3; ++g)
            residues[g] = residue(parts, g);
    };
    std::array<std::complex<float>, 3> blend;
    compute(0, near);
    compute(1, far);
    compute(0.25, blend);
    for (std::size_t g = 0; g < 3; ++g)
        CHECK(std::abs(std::abs(blend[g]) -
                       (0.75f * std::abs(near[g]) + 0.25f * std::abs(far[g]))) < 1e-5f);
}

TEST_CASE("Absurdly large residues are refused and become 0") {
    ResonatorParts parts(ringingObject({300, 700}, 10));
    REQUIRE(parts.residues.compute({}, pushIn, {}));
    CHECK(!parts.residues.compute({}, {0, 0, -2e17f}, {}));
    for (std::size_t g = 0; g < modeBlock; ++g)
        CHECK(residue(parts, g) == 0.0f);
}
