#include "Analysis/UndercutBar.h"

#include "Object/NumberText.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

namespace idiophone {
namespace {

constexpr int elements = 48; ///< of the beam
constexpr double lowestCentreShare = 0.05, highestExponent = 12;

/// Returns ascending nodes that include the arch's edges.
std::vector<double> beamNodes(const UndercutBar& bar) {
    const double half = bar.lengthMetres / 2, edge = bar.archHalfLengthShare * bar.lengthMetres;
    const int inArch =
        std::clamp(static_cast<int>(std::lround(elements * edge / half)), 2, elements - 4) / 2 * 2;
    const int inEnd = (elements - inArch) / 2;
    std::vector<double> nodes;
    for (int k = 0; k < inEnd; ++k)
        nodes.push_back(std::lerp(-half, -edge, static_cast<double>(k) / inEnd));
    for (int k = 0; k < inArch; ++k)
        nodes.push_back(std::lerp(-edge, edge, static_cast<double>(k) / inArch));
    for (int k = 0; k <= inEnd; ++k)
        nodes.push_back(std::lerp(edge, half, static_cast<double>(k) / inEnd));
    return nodes;
}

/// The unknowns are logarithms, which keep the dimensions positive.
Eigen::VectorXd unknownsOf(const UndercutBar& bar, Eigen::Index count) {
    const Eigen::Vector3d all(std::log(bar.lengthMetres),
                              std::log(bar.centreHeightMetres / bar.heightMetres),
                              std::log(bar.archExponent));
    return all.head(count);
}

UndercutBar withUnknowns(UndercutBar bar, const Eigen::VectorXd& unknowns) {
    bar.lengthMetres = std::exp(unknowns(0));
    if (unknowns.size() > 1)
        bar.centreHeightMetres = bar.heightMetres * std::exp(unknowns(1));
    if (unknowns.size() > 2)
        bar.archExponent = std::exp(unknowns(2));
    return bar;
}

bool isPossible(const UndercutBar& bar) {
    return bar.lengthMetres > 0 && bar.lengthMetres < 100 && bar.widthMetres > 0 &&
           bar.heightMetres > 0 && bar.endHeightMetres > 0 &&
           bar.centreHeightMetres <= bar.heightMetres * (1 + 1e-9) &&
           bar.centreHeightMetres >= lowestCentreShare * bar.heightMetres &&
           bar.archHalfLengthShare >= 0.1 && bar.archHalfLengthShare <= 0.49 &&
           bar.archExponent >= 1 && bar.archExponent <= highestExponent;
}

/// Returns logarithms of the fundamental and the ratios over their targets, one per unknown.
Eigen::VectorXd missOf(const UndercutBar& bar,
                       const BeamMaterial& material,
                       const PartialTargets& targets,
                       Eigen::Index count) {
    const auto partials = bendingFrequenciesHz(bar, material, 3);
    const Eigen::Vector3d all(std::log(partials[0] / targets.fundamentalHz),
                              std::log(partials[1] / partials[0] / targets.secondRatio),
                              std::log(partials[2] / partials[0] / targets.thirdRatio));
    return all.head(count);
}

} // namespace

double heightMetresAt(const UndercutBar& bar, double xMetres) {
    const double edge = bar.archHalfLengthShare * bar.lengthMetres, x = std::abs(xMetres);
    if (x < edge)
        return bar.centreHeightMetres +
               (bar.heightMetres - bar.centreHeightMetres) * std::pow(x / edge, bar.archExponent);
    return std::lerp(bar.heightMetres, bar.endHeightMetres,
                     (x - edge) / (bar.lengthMetres / 2 - edge));
}

std::vector<double>
bendingFrequenciesHz(const UndercutBar& bar, const BeamMaterial& material, int count) {
    const auto section = [&](double x) -> BeamSection {
        const double height = heightMetresAt(bar, x), area = bar.widthMetres * height;
        const double secondMoment = area * height * height / 12;
        return {.bendingStiffnessNM2 = material.youngsModulusPa * secondMoment,
                .shearStiffnessN = material.shearCoefficient * material.shearModulusPa * area,
                .massKgPerM = material.densityKgPerM3 * area,
                .rotaryInertiaKgM = material.densityKgPerM3 * secondMoment};
    };
    return freeBeamFrequenciesHz(beamNodes(bar), section, count);
}

Result<UndercutBar>
tunedArch(const UndercutBar& start, const BeamMaterial& material, const PartialTargets& targets) {
    if (!isPossible(start) || !(targets.fundamentalHz > 0) || targets.secondRatio < 0 ||
        targets.thirdRatio < 0 || (targets.thirdRatio > 0 && targets.secondRatio == 0))
        return failure("A bar to be tuned needs positive measures, an arch within it and a pitch.");
    const Eigen::Index count = targets.count();
    const auto missAt = [&](const Eigen::VectorXd& unknowns) {
        return missOf(withUnknowns(start, unknowns), material, targets, count);
    };
    Eigen::VectorXd unknowns = unknownsOf(start, count);
    Eigen::VectorXd miss = missAt(unknowns);
    constexpr double hundredthOfACent = 5.8e-6;
    for (int step = 0; step < 60; ++step) {
        if (miss.cwiseAbs().maxCoeff() < hundredthOfACent)
            return withUnknowns(start, unknowns);
        Eigen::MatrixXd slope(count, count);
        constexpr double h = 1e-4;
        for (Eigen::Index k = 0; k < count; ++k) {
            Eigen::VectorXd moved = unknowns;
            moved(k) -= h; // towards a deeper arch, which always exists
            slope.col(k) = (miss - missAt(moved)) / h;
        }
        const Eigen::VectorXd direction = slope.partialPivLu().solve(-miss);
        // Halve the step until the shape is possible and its error smaller.
        double share = std::min(1.0, 0.5 / std::max(direction.cwiseAbs().maxCoeff(), 1e-12));
        for (; share > 1e-3; share /= 2) {
            const Eigen::VectorXd there = unknowns + share * direction;
            if (!isPossible(withUnknowns(start, there)))
                continue;
            const Eigen::VectorXd missThere = missAt(there);
            if (missThere.norm() < miss.norm()) {
                unknowns = there;
                miss = missThere;
                break;
            }
        }
        if (share <= 1e-3)
            break;
    }
    std::string ratios = "1";
    for (const double ratio : {targets.secondRatio, targets.thirdRatio})
        if (ratio > 0)
            ratios += " : " + numberText(ratio);
    return failure("No arch of this kind brings the partials of the bar to " + ratios + ".");
}

} // namespace idiophone
