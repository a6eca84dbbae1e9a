#include "Analysis/BarTuning.h"

#include "Analysis/Eigensolver.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/ParametricMesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double toleranceCents = 0.02; // of the promised 0.05

/// The first bending mode of a free-free beam at x in −1/2 … 1/2 (Euler-Bernoulli; its sign and
/// size do not matter).
double freeBeamShape(double x) {
    constexpr double beta = 4.730040744862704;
    return std::cos(beta * x) / std::cos(beta / 2) + std::cosh(beta * x) / std::cosh(beta / 2);
}

struct Fundamental {
    Eigen::Index mode = 0;
    double eigenvalue = 0;
};

/// Among the lowest modes the one most like a beam's first bending, by the modal assurance
/// criterion: twist and sideways bending may lie near or below it.
Result<Fundamental> findFundamental(const BarSpecification& bar,
                                    const Mesh& mesh,
                                    double lengthMetres,
                                    double highestHz,
                                    const AnalysisControl& control) {
    const auto model = twoLayerShell(mesh, bar.material, bar.heightMetres);
    const auto modes = solveModes(model, {.lowestHz = 20, .highestHz = highestHz}, control);
    if (!modes)
        return failure(modes.error().message);
    const Eigen::MatrixXd shapes = midSurfaceShapes(modes->shapes);
    const Eigen::VectorXd masses = model.mass.diagonal();
    Fundamental best;
    double greatest = 0.5; // less likeness is another mode
    for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode) {
        double cross = 0, own = 0, ideal = 0;
        for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
            const double mass = masses(6 * v);
            const double theory = freeBeamShape(mesh.vertices(v, 0) / lengthMetres);
            cross += mass * theory * shapes(3 * v + 2, mode);
            own += mass * shapes.col(mode).segment<3>(3 * v).squaredNorm();
            ideal += mass * theory * theory;
        }
        if (const double likeness = cross * cross / (own * ideal); likeness > greatest) {
            greatest = likeness;
            best = {mode, modes->eigenvalues(mode)};
        }
    }
    if (best.eigenvalue == 0)
        return failure("The bar \"" + bar.name + "\" has no bending mode below " +
                       std::to_string(std::lround(highestHz)) + " Hz.");
    return best;
}

bool isUsable(const BarSpecification& bar) {
    return bar.targetFrequencyHz >= 20 && bar.targetFrequencyHz * 2 <= bar.maxFrequencyHz &&
           bar.widthMetres > 0 && bar.heightMetres > 0 && bar.vertexCount >= 20 &&
           bar.vertexCount <= twoLayerVertexLimit && bar.shapeVertexCount >= 1;
}

} // namespace

double cents(double frequencyHz, double referenceHz) {
    return 1200 * std::log2(frequencyHz / referenceHz);
}

double dampedFrequencyHz(double eigenvalue, const Material& material) {
    const double alpha = material.damping.perSecond(eigenvalue) / 2;
    return std::sqrt(std::max(0.0, eigenvalue - alpha * alpha)) / (2 * std::numbers::pi);
}

double estimatedBarLengthMetres(const BarSpecification& bar) {
    const double speed = std::sqrt(bar.material.youngsModulusPa / bar.material.densityKgPerM3);
    const double nu = bar.material.poissonRatio, h = bar.heightMetres;
    double length = 0, correction = 1;
    for (int step = 0; step < 100; ++step) {
        length = std::sqrt(1.02792 * h * speed / (bar.targetFrequencyHz * std::sqrt(correction)));
        const double q = std::pow(h / length, 2); // T1 of ASTM E1876, eq. 2
        correction = 1 + 6.585 * (1 + 0.0752 * nu + 0.8109 * nu * nu) * q - 0.868 * q * q -
                     8.340 * (1 + 0.2023 * nu + 2.173 * nu * nu) * q * q /
                         (1 + 6.338 * (1 + 0.1408 * nu + 1.536 * nu * nu) * q);
    }
    return length;
}

std::vector<int>
evenSheetVertices(const Mesh& sheet, double lengthMetres, double widthMetres, int count) {
    // Odd numbers of rows and columns, so that the middle lines are among them.
    const int rows =
        2 * std::max(1, static_cast<int>(std::sqrt(count * widthMetres / lengthMetres) / 2)) + 1;
    const int columns = 2 * std::max(1, count / rows / 2) + 1;
    std::vector<int> chosen;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            const Eigen::RowVector3d point(
                (static_cast<double>(i) / (columns - 1) - 0.5) * lengthMetres,
                (static_cast<double>(j) / (rows - 1) - 0.5) * widthMetres, 0);
            Eigen::Index nearest = 0;
            (sheet.vertices.rowwise() - point).rowwise().squaredNorm().minCoeff(&nearest);
            chosen.push_back(static_cast<int>(nearest));
        }
    std::ranges::sort(chosen);
    const auto repeated = std::ranges::unique(chosen);
    chosen.erase(repeated.begin(), repeated.end());
    return chosen;
}

Result<TunedBar> tuneBar(const BarSpecification& bar, const AnalysisControl& control) {
    if (const auto material = validated(bar.material); !material)
        return failure(material.error().message);
    if (!isUsable(bar))
        return failure("The bar \"" + bar.name +
                       "\" needs a pitch from 20 Hz to half of its band, positive measures and 20 "
                       "to " +
                       std::to_string(twoLayerVertexLimit) + " vertices.");
    const AnalysisControl quiet{.progress = {}, .cancelled = control.cancelled};
    double length = estimatedBarLengthMetres(bar);
    // One grid for all lengths: the pitch is then a smooth function of the length.
    const SheetGrid grid = sheetGrid(length, bar.widthMetres, bar.vertexCount);
    TunedBar result;
    double slope = -2; // d log f / d log L of a slender bar
    double previousLength = 0, previousCents = 0;
    for (int step = 0; step < 12; ++step) {
        control.report(0.03 * step, "Tuning the bar");
        result.mesh = sheetMesh(length, bar.widthMetres, grid);
        const auto fundamental =
            findFundamental(bar, result.mesh, length, 1.5 * bar.targetFrequencyHz, quiet);
        if (!fundamental)
            return failure(fundamental.error().message);
        result.lengthMetres = length;
        result.bendingMode = fundamental->mode;
        result.fundamentalHz = dampedFrequencyHz(fundamental->eigenvalue, bar.material);
        const double miss = cents(result.fundamentalHz, bar.targetFrequencyHz);
        if (std::abs(miss) <= toleranceCents) {
            auto object = analyse(result.mesh,
                                  {.name = bar.name,
                                   .source = "rectangular bar, a sheet of its height",
                                   .material = bar.material,
                                   .method = AnalysisMethod::twoLayer,
                                   .thicknessMetres = bar.heightMetres,
                                   .maxFrequencyHz = bar.maxFrequencyHz,
                                   .shapeVertices = evenSheetVertices(
                                       result.mesh, length, bar.widthMetres, bar.shapeVertexCount)},
                                  control);
            if (!object)
                return failure(object.error().message);
            result.object = std::move(*object);
            return result;
        }
        if (previousLength > 0)
            slope = (miss - previousCents) / 1200 / std::log2(length / previousLength);
        previousLength = length;
        previousCents = miss;
        length *= std::exp2(-miss / 1200 / slope);
    }
    return failure("The bar \"" + bar.name + "\" could not be tuned to " +
                   std::to_string(bar.targetFrequencyHz) + " Hz.");
}

} // namespace idiophone
