#include "Analysis/MeasuredObject.h"

#include "Analysis/DampingFit.h"
#include "Mesh/ObjectMesh.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double usualMassKg = 0.2;
constexpr double samePlaceMetres = 1e-6;

/// Returns [places, modes] amplitudes. Strikes at one place become one row, the root of their mean
/// energy. `distinct` receives the places.
MatrixXd amplitudesAt(const RecordingFit& fit,
                      const std::vector<Vector3d>& places,
                      std::vector<Vector3d>& distinct) {
    std::vector<std::size_t> placeOf;
    for (const auto& place : places) {
        const auto known = std::ranges::find_if(distinct, [&](const Vector3d& other) {
            return (place - other).norm() < samePlaceMetres;
        });
        placeOf.push_back(known - distinct.begin());
        if (known == distinct.end())
            distinct.push_back(place);
    }
    MatrixXd energies = MatrixXd::Zero(distinct.size(), fit.modes.size());
    VectorXd strikes = VectorXd::Zero(energies.rows());
    for (std::size_t r = 0; r < placeOf.size(); ++r) {
        strikes(placeOf[r]) += 1;
        for (Index i = 0; i < energies.cols(); ++i) {
            const double amplitude = fit.modes[i].amplitudes[r];
            energies(placeOf[r], i) += amplitude * amplitude;
        }
    }
    return (strikes.cwiseInverse().asDiagonal() * energies).cwiseSqrt();
}

struct CarriedModes {
    PointCarrier carrier;
    MatrixXd amplitudes; ///< [places, modes]
};

Result<CarriedModes> carriedModes(const RecordingFit& fit,
                                  std::span<const StruckPlace> places,
                                  const std::optional<Mesh>& mesh) {
    std::vector<Vector3d> points, distinct; // a radius is a point on the x axis
    std::size_t radiusCount = 0;
    for (const auto& place : places) {
        if (const auto* point = std::get_if<std::array<double, 3>>(&place))
            points.emplace_back(point->data());
        else
            points.emplace_back(std::get<double>(place), 0, 0);
        radiusCount += std::holds_alternative<double>(place) ? 1 : 0;
    }
    if (radiusCount != 0 && radiusCount != places.size())
        return failure("Some recordings are struck at points and some at radii: give all of them "
                       "X,Y,Z or all a radius.");
    MatrixXd amplitudes = amplitudesAt(fit, points, distinct);
    if (radiusCount == 0)
        return CarriedModes{mesh ? carriedBy(*mesh, std::span<const Vector3d>(distinct))
                                 : carrierThrough(distinct),
                            std::move(amplitudes)};
    std::vector<Index> order(distinct.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {}, [&](Index i) { return distinct[i].x(); });
    std::vector<double> radii;
    for (const Index i : order)
        radii.push_back(distinct[i].x());
    return CarriedModes{mesh ? carriedBy(*mesh, std::span<const double>(radii))
                             : discOfRadii(radii),
                        amplitudes(order, Eigen::all)};
}

Material materialOf(const RecordingFit& fit, const MeasuredObjectSettings& settings) {
    if (settings.material)
        return *settings.material;
    // Only the damping is audible. The other constants are those of steel.
    std::vector<DecayOfMode> decays;
    for (const auto& mode : fit.modes)
        decays.push_back({mode.eigenvalue(), mode.decayPerSecond});
    Material material = *findMaterial("Steel");
    material.name = "Measured";
    material.damping = fittedDamping(decays);
    material.source = "damping fitted to recordings; all else is that of steel";
    return material;
}

/// The mass is distributed equally over the vertices.
MassProperties
massOf(const Mesh& mesh, const Material& material, const MeasuredObjectSettings& settings) {
    MassProperties mass;
    mass.massKg = usualMassKg;
    if (settings.massKg)
        mass.massKg = *settings.massKg;
    else if (settings.mesh && settings.material && isClosed(uniqueEdges(mesh)) &&
             signedVolumeM3(mesh) > 0)
        mass.massKg = signedVolumeM3(mesh) * material.densityKgPerM3;
    const Eigen::RowVector3d centre = mesh.vertices.colwise().mean();
    const MatrixXd offsets = mesh.vertices.rowwise() - centre;
    const Eigen::Matrix3d spread =
        mass.massKg / static_cast<double>(mesh.vertexCount()) * offsets.transpose() * offsets;
    const Eigen::Matrix3d inertia = spread.trace() * Eigen::Matrix3d::Identity() - spread;
    Eigen::Map<Eigen::RowVector3d>(mass.centreMetres.data()) = centre;
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(mass.inertiaKgM2.data()) = inertia;
    return mass;
}

/// The shapes point along the normals, as strikes do.
void setShapes(const CarriedModes& carried, double massKg, ModalObject& object) {
    const double strongest = carried.amplitudes.colwise().mean().maxCoeff();
    const MatrixXd squares = carried.carrier.weights * carried.amplitudes / (strongest * massKg);
    const auto normals = vertexNormals(object);
    for (Index vertex = 0; vertex < squares.rows(); ++vertex)
        for (Index mode = 0; mode < squares.cols(); ++mode)
            for (std::size_t axis = 0; axis < 3; ++axis)
                object.shapes.push_back(static_cast<float>(std::sqrt(squares(vertex, mode))) *
                                        normals[vertex * 3 + axis]);
}

} // namespace

Result<ModalObject> measuredObject(const RecordingFit& fit,
                                   std::span<const StruckPlace> places,
                                   const MeasuredObjectSettings& settings) {
    if (settings.mesh && settings.mesh->faceCount() == 0)
        return failure("The mesh has no faces.");
    if (fit.modes.empty())
        return failure("There are no modes to make an object of.");
    if (places.empty() || std::ranges::any_of(fit.modes, [&](const MeasuredMode& mode) {
            return mode.amplitudes.size() != places.size();
        }))
        return failure("Every recording needs the place that it was struck at, and there are " +
                       std::to_string(places.size()) + " places.");
    const auto carried = carriedModes(fit, places, settings.mesh);
    if (!carried)
        return tl::unexpected(carried.error());
    const Mesh& mesh = carried->carrier.mesh;
    ModalObject object;
    object.name = settings.name;
    object.material = materialOf(fit, settings);
    object.method = "measured";
    object.mass = massOf(mesh, object.material, settings);
    // Sort by λ: heavy damping can give the damped frequencies another order.
    std::vector<Index> order(fit.modes.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, {}, [&](Index i) { return fit.modes[i].eigenvalue(); });
    for (const Index i : order) {
        object.eigenvalues.push_back(fit.modes[i].eigenvalue());
        object.decaysPerSecond.push_back(fit.modes[i].decayPerSecond);
    }
    object.bandHz = std::sqrt(object.eigenvalues.back()) / (2 * std::numbers::pi);
    setMesh(object, mesh);
    const auto all = allVertices(mesh);
    object.shapeVertices.assign(all.begin(), all.end());
    setShapes({carried->carrier, carried->amplitudes(Eigen::all, order)}, object.mass.massKg,
              object);
    object.provenance = {.source = settings.source,
                         .software = "Idiophone " IDIOPHONE_VERSION,
                         .notes = {},
                         .analysisSeconds = 0,
                         .analysedVertices = carried->amplitudes.rows(),
                         .zeroModes = 0};
    return validated(std::move(object));
}

} // namespace idiophone
