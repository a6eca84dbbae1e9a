#include "Analysis/BodyModel.h"

#include "Analysis/Eigensolver.h"
#include "Analysis/HeldBody.h"
#include "Analysis/Radiation.h"
#include "Analysis/Soundboard.h"
#include "Analysis/TwoLayerShell.h"
#include "Mesh/ObjectMesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace idiophone {
namespace {

std::string notesOn(const BodyModel& body, const SolveSettings& settings, const Modes& modes) {
    std::string zeroModes, lowModes;
    const Eigen::Index rigid = 6 * Eigen::Index{body.components};
    if (modes.zeroModes > rigid)
        zeroModes = (body.kind == ModelKind::twoLayers
                         ? "The shell is so thin that some of its bending is too slow to be heard: "
                         : "Flat parts bend freely in this method, unlike in a two-layer shell: ") +
                    std::to_string(modes.zeroModes) + " zero modes instead of " +
                    std::to_string(rigid) + ".";
    if (modes.belowBand > 0)
        lowModes = std::to_string(modes.belowBand) + " modes below " +
                   std::to_string(std::lround(settings.lowestFrequencyHz)) + " Hz were left out.";
    return joinedSentences({body.notes, zeroModes, lowModes});
}

std::string noteOnClamps(const ModalObject& object) {
    const auto held = object.clampedVertices.size();
    if (held == 0)
        return {};
    return "Clamps hold " + std::to_string(held) + " of its " +
           std::to_string(object.vertexCount()) + " vertices.";
}

/// Returns the part of each λ that grows with the square of the thickness. Compares λ with
/// Rayleigh's quotient of the mode in a slightly thicker shell, in which the layers move apart as
/// they turn together.
std::vector<double>
bendingParts(const BodyModel& body, const Eigen::VectorXd& eigenvalues, Eigen::MatrixXd shapes) {
    constexpr double ratio = 1.25;
    const auto thicker = twoLayerShell(body.surface, body.material, ratio * body.thicknessMetres);
    for (Eigen::Index row = 0; row < shapes.rows(); row += 6) {
        const Eigen::MatrixXd upper = shapes.middleRows(row, 3),
                              lower = shapes.middleRows(row + 3, 3);
        const Eigen::MatrixXd middle = (upper + lower) / 2, apart = ratio * (upper - lower) / 2;
        shapes.middleRows(row, 3) = middle + apart;
        shapes.middleRows(row + 3, 3) = middle - apart;
    }
    const Eigen::RowVectorXd energy =
        shapes.cwiseProduct(thicker.stiffness.selfadjointView<Eigen::Lower>() * shapes)
            .colwise()
            .sum();
    const Eigen::RowVectorXd mass =
        shapes.cwiseProduct(thicker.mass.selfadjointView<Eigen::Lower>() * shapes).colwise().sum();
    std::vector<double> parts;
    for (Eigen::Index mode = 0; mode < eigenvalues.size(); ++mode)
        parts.push_back(
            std::clamp((energy(mode) / mass(mode) - eigenvalues(mode)) / (ratio * ratio - 1), 0.0,
                       eigenvalues(mode)));
    return parts;
}

/// Returns the mass properties from the kinetic energy of unit motions, exact for the model's mass.
/// Rows 3p, 3p + 1 and 3p + 2 of the model are the displacement of the point in row p of
/// `pointsMetres` [P×3].
MassProperties massPropertiesOf(const VibrationModel& model, const Eigen::MatrixXd& pointsMetres) {
    const Eigen::Index points = pointsMetres.rows();
    const auto mass = model.mass.selfadjointView<Eigen::Lower>();
    Eigen::MatrixXd shifts = Eigen::MatrixXd::Zero(3 * points, 3);
    for (Eigen::Index p = 0; p < points; ++p)
        shifts.middleRows<3>(3 * p).setIdentity();
    const Eigen::MatrixXd momenta = mass * shifts;
    MassProperties result;
    result.massKg = momenta.col(0).dot(shifts.col(0));
    // The momentum of a unit shift along x, weighted by position, is the mass times the centre.
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();
    for (Eigen::Index p = 0; p < points; ++p)
        centre += momenta(3 * p, 0) * pointsMetres.row(p).transpose() / result.massKg;
    Eigen::MatrixXd turns(3 * points, 3);
    for (Eigen::Index p = 0; p < points; ++p) {
        const Eigen::Vector3d arm = pointsMetres.row(p).transpose() - centre;
        for (int axis = 0; axis < 3; ++axis)
            turns.block<3, 1>(3 * p, axis) = Eigen::Vector3d::Unit(axis).cross(arm);
    }
    const Eigen::Matrix3d inertia = turns.transpose() * (mass * turns);
    Eigen::Map<Eigen::Vector3d>(result.centreMetres.data()) = centre;
    Eigen::Map<Eigen::Matrix3d>(result.inertiaKgM2.data()) = inertia; // symmetric: any order
    return result;
}

/// `shapes` [3N×M] covers all vertices; the object keeps those of `vertices`.
void storeModes(const Eigen::VectorXd& eigenvalues,
                const Eigen::MatrixXd& shapes,
                const std::vector<int>& vertices,
                ModalObject& object) {
    object.shapes.reserve(vertices.size() * static_cast<std::size_t>(shapes.cols()) * 3);
    for (const int vertex : vertices)
        for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode)
            for (Eigen::Index axis = 0; axis < 3; ++axis)
                object.shapes.push_back(
                    static_cast<float>(shapes(3 * Eigen::Index{vertex} + axis, mode)));
    object.shapeVertices.assign(vertices.begin(), vertices.end());
    object.eigenvalues.assign(eigenvalues.begin(), eigenvalues.end());
}

/// Stores which vertices are held, what the support takes, and what its board radiates. The object
/// has a mass, and the radiation of its own surface or none.
void storeSupport(const BodyModel& body,
                  const std::vector<bool>& held,
                  const Modes& modes,
                  ModalObject& object) {
    if (held.empty())
        return;
    const int rows = body.kind == ModelKind::twoLayers ? 6 : 3;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (int vertex = 0; vertex < body.surface.vertexCount(); ++vertex)
        if (held[static_cast<std::size_t>(rows * vertex)]) {
            object.clampedVertices.push_back(vertex);
            place += body.surface.vertices.row(vertex);
        }
    place /= std::max<double>(1, static_cast<double>(object.clampedVertices.size()));
    const auto resistance = body.support.resistanceNsPerM, quality = body.support.quality,
               board = body.support.boardKgPerM2;
    if (!resistance && !quality && !board)
        return;
    const auto forces = supportForces(body.model, held, modes);
    const double taking = resistance ? *resistance
                          : quality  ? resistanceOf(*quality, forces, modes.eigenvalues)
                                     : 0;
    if (taking > 0)
        object.extraDecaysPerSecond = supportDecays(forces, modes.eigenvalues, taking);
    if (board && !object.radiation.empty())
        addBoard(object.radiation, modes.eigenvalues, forces.row(2),
                 place - Eigen::Vector3d(object.mass.centreMetres.data()), *board);
}

/// [3N×M] displacements of the surface for shapes of the model.
Eigen::MatrixXd surfaceShapes(const BodyModel& body, const Eigen::MatrixXd& shapes) {
    if (body.kind == ModelKind::twoLayers)
        return midSurfaceShapes(shapes);
    return shapes.topRows(3 * body.surface.vertexCount());
}

/// Returns the share of the modes in the time of an analysis, the rest is the radiation's
/// (measured).
double shareOfModes(const BodyModel& body, RadiationMethod method) {
    if (body.kind == ModelKind::twoLayers)
        return 0.15;
    return method == RadiationMethod::exact ? 0.4 : 0.65;
}

} // namespace

std::string joinedSentences(std::initializer_list<std::string> sentences) {
    std::string text;
    for (const std::string& sentence : sentences)
        if (!sentence.empty())
            text += (text.empty() ? "" : " ") + sentence;
    return text;
}

Result<ModalObject> solveBody(const BodyModel& body,
                              const SolveSettings& settings,
                              const WorkControl& control,
                              Eigen::MatrixXcd* nearPressures) {
    const double modesShare = shareOfModes(body, settings.radiation);
    const auto start = std::chrono::steady_clock::now();
    const auto held = heldRows(body);
    if (!held)
        return tl::unexpected(held.error());
    const FrequencyBand band{.lowestHz = settings.lowestFrequencyHz,
                             .highestHz = settings.maxFrequencyHz,
                             .maximumModes = settings.maximumModes,
                             .threads = settings.threads};
    const auto solving = control.part(0, modesShare);
    const auto modes = solveHeldModes(body.model, *held, band, solving);
    if (!modes)
        return tl::unexpected(modes.error());
    if (modes->eigenvalues.size() == 0)
        return failure("The object has no mode between " +
                       std::to_string(std::lround(settings.lowestFrequencyHz)) + " and " +
                       std::to_string(std::lround(settings.maxFrequencyHz)) +
                       " Hz; check its size and its unit.");
    ModalObject object;
    object.name = settings.name;
    object.material = body.material;
    object.body = body.body;
    object.thicknessMetres = body.thicknessMetres;
    object.method = body.method;
    object.bandHz = settings.maxFrequencyHz;
    const Eigen::MatrixXd shapes = surfaceShapes(body, modes->shapes);
    storeModes(modes->eigenvalues, shapes,
               settings.shapeVertices.empty() ? allVertices(body.surface) : settings.shapeVertices,
               object);
    if (body.kind == ModelKind::twoLayers)
        object.bending = bendingParts(body, modes->eigenvalues, modes->shapes);
    setMesh(object, body.surface);
    object.mass = massPropertiesOf(body.model, body.pointsMetres);
    std::string radiationNotes;
    if (!settings.listeningDirections.empty()) {
        auto radiation =
            radiationOf({.mesh = body.surface,
                         .shapes = shapes,
                         .eigenvalues = modes->eigenvalues,
                         .thicknessMetres = body.thicknessMetres,
                         .centreMetres = Eigen::Vector3d(object.mass.centreMetres.data())},
                        {.directions = settings.listeningDirections,
                         .method = settings.radiation,
                         .nearPointsMetres = settings.nearPointsMetres,
                         .threads = settings.threads},
                        control.part(modesShare, 1));
        if (!radiation)
            return tl::unexpected(radiation.error());
        object.radiation = std::move(radiation->table);
        radiationNotes = std::move(radiation->notes);
        if (nearPressures != nullptr)
            *nearPressures = std::move(radiation->nearPressures);
    }
    storeSupport(body, *held, *modes, object);
    object.provenance = {
        .source = settings.source,
        .software = "Idiophone " IDIOPHONE_VERSION,
        .notes = joinedSentences(
            {notesOn(body, settings, *modes), noteOnClamps(object), radiationNotes}),
        .analysisSeconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
        .analysedVertices = body.surface.vertexCount(),
        .zeroModes = modes->zeroModes};
    return validated(std::move(object));
}

} // namespace idiophone
