#include "Analysis/UndercutBar.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinRel;

namespace {

/// The material of the reference values below, with nu = 0.25.
const BeamMaterial wood{.youngsModulusPa = 2e10,
                        .shearModulusPa = 8e9,
                        .shearCoefficient = rectangularShearCoefficient(0.25),
                        .densityKgPerM3 = 1000};

UndercutBar uniformBar(double lengthMetres, double heightMetres) {
    return {.lengthMetres = lengthMetres,
            .widthMetres = 0.05,
            .heightMetres = heightMetres,
            .centreHeightMetres = heightMetres,
            .endHeightMetres = heightMetres};
}

double centsOff(double found, double wanted) {
    return std::abs(1200 * std::log2(found / wanted));
}

} // namespace

TEST_CASE("A beam stiff in shear has Euler's and Bernoulli's partials within 1e-4") {
    std::vector<double> nodes;
    for (int k = 0; k <= 48; ++k)
        nodes.push_back(k / 48.0);
    const BeamSection section{.bendingStiffnessNM2 = 1,
                              .shearStiffnessN = 1e7,
                              .massKgPerM = 1,
                              .rotaryInertiaKgM = 1e-7};
    const auto partials = freeBeamFrequenciesHz(
        nodes, [&](double) { return section; }, 4);
    const double betas[] = {4.73004075, 7.85320462, 10.99560784, 14.13716549};
    REQUIRE(partials.size() == 4);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK_THAT(2 * std::numbers::pi * partials[i], WithinRel(betas[i] * betas[i], 1e-4));
}

TEST_CASE("A thick uniform beam has Timoshenko's partials within 1e-4") {
    // 0.4 x 0.05 x 0.02 m, Y 20 GPa, nu 0.25: 569.6 1545.4 2963.4 4765.2 6894.6 Hz.
    const auto partials = bendingFrequenciesHz(uniformBar(0.4, 0.02), wood, 5);
    const double found[] = {569.6, 1545.4, 2963.4, 4765.2, 6894.6};
    for (std::size_t i = 0; i < 5; ++i)
        CHECK_THAT(partials[i], WithinRel(found[i], 1e-4));
}

TEST_CASE("Parabolic arches tune slender beams to 1:3 and 1:4 as tabulated") {
    struct Row {
        double share, second, centre, third, fundamental;
    };
    for (const Row& row : {Row{0.25, 3, 0.844, 5.97, 0.862}, Row{0.30, 3, 0.828, 6.04, 0.832},
                           Row{0.40, 3, 0.775, 6.09, 0.758}, Row{0.25, 4, 0.460, 9.11, 0.484},
                           Row{0.30, 4, 0.410, 9.35, 0.413}, Row{0.40, 4, 0.320, 9.38, 0.298}}) {
        UndercutBar bar = uniformBar(0.3, 3e-3);
        const double uniform = bendingFrequenciesHz(bar, wood, 1)[0];
        bar.archHalfLengthShare = row.share;
        bar.centreHeightMetres = 0.6 * bar.heightMetres;
        const auto tuned =
            tunedArch(bar, wood, {.fundamentalHz = uniform, .secondRatio = row.second});
        REQUIRE(tuned);
        const auto partials = bendingFrequenciesHz(*tuned, wood, 3);
        CHECK_THAT(tuned->centreHeightMetres / tuned->heightMetres, WithinRel(row.centre, 0.004));
        CHECK_THAT(partials[2] / partials[0], WithinRel(row.third, 0.003));
        // f1 at equal length and height: f ~ 1/length².
        CHECK_THAT(std::pow(tuned->lengthMetres / 0.3, 2), WithinRel(row.fundamental, 0.004));
    }
}

TEST_CASE("Three partials are tuned within 0.02 cents, also for orthotropic wood") {
    for (const double shearModulusPa : {5e9, 1.1e9}) {
        BeamMaterial rosewood = wood;
        rosewood.shearModulusPa = shearModulusPa;
        for (const auto& [hz, second, third] :
             {std::array{130.81, 4.0, 10.0}, std::array{261.63, 4.0, 9.6},
              std::array{349.23, 3.0, 6.0}, std::array{698.46, 3.0, 0.0}}) {
            UndercutBar bar = uniformBar(0.4, 0.02);
            bar.centreHeightMetres = 0.012;
            bar.archHalfLengthShare = 0.32;
            const auto tuned = tunedArch(
                bar, rosewood, {.fundamentalHz = hz, .secondRatio = second, .thirdRatio = third});
            INFO(hz << " " << shearModulusPa);
            REQUIRE(tuned);
            const auto partials = bendingFrequenciesHz(*tuned, rosewood, 3);
            CHECK(centsOff(partials[0], hz) < 0.01);
            CHECK(centsOff(partials[1], second * hz) < 0.02);
            if (third > 0)
                CHECK(centsOff(partials[2], third * hz) < 0.02);
            CHECK(tuned->widthMetres == bar.widthMetres);
            CHECK(tuned->heightMetres == bar.heightMetres);
        }
    }
}

TEST_CASE("Thinner ends raise a bar's pitch, and a thinner middle lowers it") {
    const UndercutBar whole = uniformBar(0.3, 0.02);
    UndercutBar ends = whole, middle = whole;
    ends.endHeightMetres = 0.015;
    middle.centreHeightMetres = 0.015;
    const double fundamental = bendingFrequenciesHz(whole, wood, 1)[0];
    CHECK(bendingFrequenciesHz(ends, wood, 1)[0] > 1.02 * fundamental);
    CHECK(bendingFrequenciesHz(middle, wood, 1)[0] < 0.9 * fundamental);
}

TEST_CASE("Unreachable ratios and impossible measures give a one-sentence error") {
    const UndercutBar bar = uniformBar(0.3, 0.02);
    CHECK_THAT(tunedArch(bar, wood, {.fundamentalHz = 440, .secondRatio = 30}).error().message,
               Catch::Matchers::ContainsSubstring("No arch") &&
                   Catch::Matchers::EndsWith(" to 1 : 30."));
    CHECK_FALSE(tunedArch(bar, wood, {.fundamentalHz = 440, .secondRatio = 1.5}));
    CHECK_FALSE(tunedArch(bar, wood, {.fundamentalHz = 0}));
    CHECK_FALSE(tunedArch(bar, wood, {.fundamentalHz = 440, .thirdRatio = 6}));
    UndercutBar arch = bar;
    arch.archHalfLengthShare = 0.6;
    CHECK_FALSE(tunedArch(arch, wood, {.fundamentalHz = 440}));
}
