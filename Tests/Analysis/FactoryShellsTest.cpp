// Tests of the stored bells, bowls, discs and blocks against what is known of real ones.
#include "Analysis/FactoryShells.h"

#include "Analysis/FactoryObjects.h"
#include "Analysis/SlitShell.h"
#include "StoredObject.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

double frequencyHz(const ModalObject& object, std::size_t mode) {
    return std::sqrt(object.eigenvalues[mode]) / (2 * std::numbers::pi);
}

/// Returns the frequencies of the pairs of modes, which have waves around the axis, ascending.
std::vector<double> pairsHz(const ModalObject& object) {
    std::vector<double> pairs;
    for (std::size_t mode = 1; mode < object.modeCount(); ++mode)
        if (frequencyHz(object, mode) < 1.005 * frequencyHz(object, mode - 1))
            pairs.push_back(frequencyHz(object, mode));
    return pairs;
}

/// Checks that each ratio of a partial to the lowest pair is that of some pair.
void checkRatios(const std::string& name, std::initializer_list<double> ratios, double tolerance) {
    const auto pairs = pairsHz(stored(name));
    REQUIRE(pairs.size() >= ratios.size());
    for (const double ratio : ratios) {
        INFO(name << " at " << ratio);
        const bool isFound = std::ranges::any_of(
            pairs, [&](double hz) { return std::abs(hz / pairs.front() / ratio - 1) < tolerance; });
        CHECK(isFound);
    }
}

} // namespace

TEST_CASE("The singing bowl has the partials of a measured bowl within 1 %") {
    // Inácio, Henrique & Antunes 2006, a bowl of 180 mm.
    checkRatios("singing-bowl", {1, 2.778, 5.181, 8.163, 11.66}, 0.01);
}

TEST_CASE("The wine glass has the first four partials of a measured glass within 5 %") {
    checkRatios("wine-glass", {1, 2.32, 4.25, 6.63}, 0.05);
}

TEST_CASE("The crotale's hub brings its second pair near the octave") {
    // A flat disc has 2.33 (Leissa); Deutsch, Ramirez & Moore 2004 ascribe the octave to the hub.
    checkRatios("crotale", {1, 2}, 0.05);
}

TEST_CASE("The crotale's post damps the mode that moves its hub, and no mode with waves around") {
    const auto crotale = stored("crotale");
    const auto postsLoss = [&](std::size_t mode) {
        return crotale.decayPerSecond(mode) -
               crotale.material.damping.perSecond(crotale.eigenvalues[mode]) / 2;
    };
    CHECK(postsLoss(0) < 0.01);
    CHECK(postsLoss(1) < 0.01);
    CHECK(frequencyHz(crotale, 2) < 1.6 * frequencyHz(crotale, 0)); // (0,1)
    CHECK(postsLoss(2) > 20);
}

TEST_CASE("The church bell has hum, prime, tierce, quint and nominal within 2 %") {
    checkRatios("church-bell", {1, 2, 2.4, 3, 4}, 0.02);
}

TEST_CASE("Wood and air of the blocks share their two lowest modes around the cavity's resonance") {
    for (const auto* name : {"temple-block", "wood-block"}) {
        INFO(name);
        const auto block = stored(name);
        REQUIRE(block.isShared(0));
        CHECK(sharingPartner(block, 0) == 1);
        const auto shape =
            std::ranges::find(factoryShells(), std::string_view(name), &FactoryShape::name);
        const double airHz = slitShell(shape->wall(), shape->isSlit).cavity.frequencyHz();
        CHECK(frequencyHz(block, 0) < airHz);
        CHECK(frequencyHz(block, 1) > airHz);
        // Sunohara et al. 2005: 176 wooden drums have their two peaks at 1 : 1.15 on average.
        const double ratio = frequencyHz(block, 1) / frequencyHz(block, 0);
        CHECK((ratio > 1.1 && ratio < 1.25));
    }
}

TEST_CASE("The finger cymbal made again is the stored one") {
    const auto anew = makeFactoryObject("finger-cymbal");
    const auto before = stored("finger-cymbal");
    REQUIRE(anew);
    REQUIRE(anew->modeCount() == before.modeCount());
    for (std::size_t mode = 0; mode < before.modeCount(); ++mode)
        CHECK_THAT(anew->eigenvalues[mode], WithinRel(before.eigenvalues[mode], 1e-6));
}
