#include "Analysis/TubeTuning.h"

#include "Analysis/Eigensolver.h"
#include "Analysis/LighterMesh.h"
#include "Analysis/ModalAnalysis.h"
#include "Analysis/Pitch.h"
#include "Analysis/Radiation.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/SpreadVertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double toleranceCents = 0.1;
// The number of rows is the same for every length, so that the pitch is a smooth function of the
// length. Twice as many rows would shorten the tubes by 0.5 % and keep the ratios of the modes. The
// lighter mesh has every eighth row with every other vertex.
constexpr int around = 20, rowsOfOne = 8;
constexpr std::array betaLengths{4.73004075,  7.85320462,  10.99560784,
                                 14.13716549, 17.27875966, 20.42035225}; // of a free beam

double meanRadius(const TubeSpecification& tube) {
    return (tube.outerDiameterMetres - tube.wallMetres) / 2;
}

Mesh midSurface(const TubeSpecification& tube, double lengthMetres) {
    return hoopMesh(meanRadius(tube), lengthMetres, around, tube.rows);
}

/// Returns whether a mode bends the tube like a beam: most of its motion moves whole sections
/// sideways.
bool isBending(const Eigen::Ref<const Eigen::VectorXd>& middle,
               const Eigen::VectorXd& vertexMasses) {
    double share = 0; // of the modal mass 1
    for (Eigen::Index first = 0; first < vertexMasses.size(); first += around) {
        Eigen::Vector2d momentum = Eigen::Vector2d::Zero();
        for (Eigen::Index v = first; v < first + around; ++v)
            momentum += vertexMasses(v) * middle.segment<2>(3 * v);
        share += momentum.squaredNorm() / vertexMasses.segment(first, around).sum();
    }
    return share > 0.6;
}

/// Returns λ of bending modes 1 to 6, each the mean of a pair; 0 for those above `highestHz`. There
/// are at least two above the tuned mode.
Result<std::array<double, 6>> bendingEigenvalues(const TubeSpecification& tube,
                                                 double lengthMetres,
                                                 double highestHz,
                                                 const WorkControl& control) {
    const auto model =
        twoLayerShell(midSurface(tube, lengthMetres), tube.material, tube.wallMetres);
    const auto modes = solveModes(model, {.highestHz = highestHz}, control);
    if (!modes)
        return failure(modes.error().message);
    const Eigen::MatrixXd shapes = midSurfaceShapes(modes->shapes);
    const Eigen::VectorXd diagonal = model.mass.diagonal();
    const Eigen::VectorXd vertexMasses = 2 * diagonal(Eigen::seq(0, Eigen::last, 6));
    std::vector<double> bending;
    for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode)
        if (isBending(shapes.col(mode), vertexMasses))
            bending.push_back(modes->eigenvalues(mode));
    std::array<double, 6> pairs{};
    const auto needed = static_cast<std::size_t>(tube.tunedMode) + 2;
    if (bending.size() < 2 * needed)
        return failure("The tube \"" + tube.name + "\" has no " + std::to_string(needed) +
                       " bending modes below " + std::to_string(std::lround(highestHz)) + " Hz.");
    for (std::size_t pair = 0; pair < std::min(bending.size() / 2, pairs.size()); ++pair)
        pairs[pair] = (bending[2 * pair] + bending[2 * pair + 1]) / 2;
    return pairs;
}

/// Returns the radiation of the tube with closed ends. Chimes have a cap, and the air inside moves
/// with the wall. So only the outside radiates; the other side of a sheet would nearly cancel it.
Result<Radiation>
outerRadiation(const Mesh& tube, const ModalObject& object, const WorkControl& control) {
    const auto count = static_cast<int>(tube.vertexCount());
    const int bottom = count, top = count + 1, lastCircle = count - around;
    const auto modes = static_cast<Eigen::Index>(object.modeCount());
    Mesh closed{Eigen::MatrixXd(count + 2, 3), Eigen::MatrixXi(tube.faceCount() + 2 * around, 3)};
    closed.vertices << tube.vertices, tube.vertices.topRows(around).colwise().mean(),
        tube.vertices.bottomRows(around).colwise().mean();
    closed.faces.topRows(tube.faceCount()) = tube.faces;
    for (int k = 0; k < around; ++k) {
        const int next = (k + 1) % around;
        closed.faces.row(tube.faceCount() + 2 * k) << next, k, bottom;
        closed.faces.row(tube.faceCount() + 2 * k + 1) << lastCircle + k, lastCircle + next, top;
    }
    Eigen::MatrixXd shapes = Eigen::MatrixXd::Zero(3 * (count + 2), modes);
    for (int v = 0; v < count; ++v) {
        const auto values = object.shapesAt(v);
        for (Eigen::Index mode = 0; mode < modes; ++mode)
            for (int axis = 0; axis < 3; ++axis)
                shapes(3 * v + axis, mode) = static_cast<double>(values[3 * mode + axis]);
        if (v < around)
            shapes.middleRows<3>(3 * bottom) += shapes.middleRows<3>(3 * v) / around;
        if (v >= lastCircle)
            shapes.middleRows<3>(3 * top) += shapes.middleRows<3>(3 * v) / around;
    }
    const Eigen::VectorXd eigenvalues =
        Eigen::Map<const Eigen::VectorXd>(object.eigenvalues.data(), modes);
    return radiationOf({.mesh = closed,
                        .shapes = shapes,
                        .eigenvalues = eigenvalues,
                        .thicknessMetres = 0,
                        .centreMetres = Eigen::Vector3d(object.mass.centreMetres.data())},
                       {.method = RadiationMethod::exact}, control);
}

/// Returns vertices on the half towards the listener, +y, about four around for each row along.
std::vector<int> struckVertices(const Mesh& mesh, const TubeSpecification& tube) {
    const double radius = meanRadius(tube);
    std::vector<int> reachable;
    for (int v = 0; v < mesh.vertexCount(); ++v)
        if (mesh.vertices(v, 1) > 0.1 * radius)
            reachable.push_back(v);
    Mesh squeezed = mesh;
    squeezed.vertices.col(2) *= pi * radius / 4 * (tube.shapeVertexCount / 4.0) /
                                (mesh.vertices.col(2).maxCoeff() - mesh.vertices.col(2).minCoeff());
    return spreadVertices(squeezed, reachable, tube.shapeVertexCount);
}

Result<ModalObject>
analysedTube(const TubeSpecification& tube, double lengthMetres, const WorkControl& control) {
    const Mesh mesh = midSurface(tube, lengthMetres);
    auto object = analyse(mesh,
                          {.name = tube.name,
                           .source = tube.source,
                           .material = tube.material,
                           .method = AnalysisMethod::twoLayer,
                           .thicknessMetres = tube.wallMetres,
                           .maxFrequencyHz = tube.maxFrequencyHz},
                          control);
    if (!object)
        return object;
    auto radiation = outerRadiation(mesh, *object, control);
    if (!radiation)
        return failure(radiation.error().message);
    object->radiation = std::move(radiation->table);
    const Mesh lighter =
        hoopMesh(meanRadius(tube), lengthMetres, around / 2, tube.rows / rowsOfOne);
    return withLighterMesh(*object, lighter, struckVertices(lighter, tube));
}

bool isUsable(const TubeSpecification& tube) {
    return tube.noteFrequencyHz >= 20 && tube.wallMetres > 0 &&
           tube.outerDiameterMetres > 4 * tube.wallMetres && tube.shapeVertexCount >= 1 &&
           (tube.tunedMode == 1 || tube.tunedMode == 4) &&
           tube.maxFrequencyHz > 5 * tube.noteFrequencyHz;
}

} // namespace

double slenderTubeLengthMetres(const TubeSpecification& tube, double modeHz) {
    const double betaL = betaLengths[static_cast<std::size_t>(tube.tunedMode) - 1];
    const double gyration = meanRadius(tube) / std::sqrt(2.0);
    const double speed = std::sqrt(tube.material.youngsModulusPa / tube.material.densityKgPerM3);
    return betaL * std::sqrt(gyration * speed / (2 * pi * modeHz));
}

Result<TunedTube> tuneTube(const TubeSpecification& tube, const WorkControl& control) {
    if (const auto material = validated(tube.material); !material)
        return failure(material.error().message);
    if (!isUsable(tube))
        return failure("The tube \"" + tube.name +
                       "\" needs a note of 20 Hz or more, a wall thinner than a quarter of its "
                       "diameter and a band of more than five times its note.");
    const auto tuned = static_cast<std::size_t>(tube.tunedMode) - 1;
    const double targetHz = (tube.tunedMode == 4 ? 2 : 1) * tube.noteFrequencyHz;
    const double highest = 1.1 * std::pow(betaLengths[tuned + 2] / betaLengths[tuned], 2);
    TunedTube result;
    result.lengthMetres = slenderTubeLengthMetres(tube, targetHz);
    double slope = -2; // d log f / d log L of a slender tube
    double previousLength = 0, previousCents = 0;
    for (int step = 0; step < 12; ++step) {
        control.report(0.03 * step, "Tuning the tube");
        const auto bending =
            bendingEigenvalues(tube, result.lengthMetres, highest * targetHz, control.quiet());
        if (!bending)
            return failure(bending.error().message);
        for (std::size_t mode = 0; mode < bending->size(); ++mode)
            result.bendingHz[mode] =
                (*bending)[mode] > 0 ? dampedFrequencyHz((*bending)[mode], tube.material) : 0;
        const double miss = cents(result.bendingHz[tuned], targetHz);
        if (std::abs(miss) <= toleranceCents) {
            auto object = analysedTube(tube, result.lengthMetres, control);
            if (!object)
                return failure(object.error().message);
            result.object = std::move(*object);
            return result;
        }
        if (previousLength > 0)
            slope = (miss - previousCents) / 1200 / std::log2(result.lengthMetres / previousLength);
        previousLength = result.lengthMetres;
        previousCents = miss;
        result.lengthMetres *= std::exp2(-miss / 1200 / slope);
    }
    return failure("The tube \"" + tube.name + "\" could not be tuned.");
}

} // namespace idiophone
