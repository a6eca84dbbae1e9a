#include "Analysis/DampingFit.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace idiophone;
using Catch::Approx;

namespace {

std::vector<DecayOfMode> decaysUnder(const DampingLaw& law, int modes) {
    std::vector<DecayOfMode> decays;
    for (int i = 0; i < modes; ++i) {
        const double hz = 150 * std::pow(80.0, double(i) / std::max(modes - 1, 1)); // to 12 kHz
        const double eigenvalue = std::pow(2 * std::numbers::pi * hz, 2);
        decays.push_back({eigenvalue, law.perSecond(eigenvalue) / 2});
    }
    return decays;
}

} // namespace

TEST_CASE("The fitted damping law recovers the constants of exact decays") {
    for (const auto& law :
         {DampingLaw{5, 1e-7, 0}, DampingLaw{0, 3e-7, 0}, DampingLaw{40, 0, 0},
          DampingLaw{0, 0, 0.004}, DampingLaw{5, 0, 0.0006}, DampingLaw{20, 2e-7, 0.002}}) {
        const auto fitted = fittedDamping(decaysUnder(law, 12));
        CAPTURE(law.fluidPerSecond, law.viscoelasticSeconds, law.lossFactor);
        CHECK(fitted.fluidPerSecond == Approx(law.fluidPerSecond).epsilon(1e-3).margin(1e-3));
        CHECK(fitted.viscoelasticSeconds ==
              Approx(law.viscoelasticSeconds).epsilon(1e-3).margin(1e-12));
        CHECK(fitted.lossFactor == Approx(law.lossFactor).epsilon(1e-3).margin(1e-7));
    }
}

TEST_CASE("A fitted damping law follows most decays and not the few that deviate") {
    const DampingLaw law{3, 0, 0.002};
    auto decays = decaysUnder(law, 20);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> error(0.9, 1.1);
    for (auto& each : decays)
        each.decayPerSecond *= error(random);
    decays[4].decayPerSecond *= 10; // a false mode
    decays[13].decayPerSecond *= 6;
    const auto fitted = fittedDamping(decays);
    for (const auto& each : decays)
        CHECK(fitted.perSecond(each.eigenvalue) ==
              Approx(law.perSecond(each.eigenvalue)).epsilon(0.1));
}

TEST_CASE("One decay gives one constant, and none gives no damping") {
    const auto one = fittedDamping(decaysUnder({0, 0, 0.01}, 1));
    const double eigenvalue = decaysUnder({}, 1)[0].eigenvalue;
    CHECK(one.perSecond(eigenvalue) == Approx(0.01 * std::sqrt(eigenvalue)));
    CHECK(fittedDamping({}) == DampingLaw{});
}
