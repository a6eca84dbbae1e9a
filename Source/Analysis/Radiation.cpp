#include "Analysis/Radiation.h"

#include "Analysis/Air.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace idiophone {
namespace {

constexpr double lowestAudibleHz = 20, highestAudibleHz = 22000;

/// P points with the area and the normal of their share of the surface.
struct RadiatingSurface {
    Eigen::MatrixXd pointsMetres;       ///< [P×3] from the centre of mass
    Eigen::MatrixXd vectorAreasM2;      ///< [P×3] A n
    std::vector<Eigen::Index> vertices; ///< [P] whose motion each point shares
    double areaM2 = 0;
};

/// [N] whether the component that a vertex belongs to has an edge without exactly two faces.
std::vector<bool> openVertices(const Mesh& mesh) {
    const auto components = connectedComponents(mesh);
    const auto componentOf = [&](Eigen::Index vertex) {
        return static_cast<std::size_t>(
            components.componentOfVertex[static_cast<std::size_t>(vertex)]);
    };
    std::vector<bool> isOpen(static_cast<std::size_t>(components.count), false);
    for (const auto& edge : uniqueEdges(mesh))
        if (edge.faceCount != 2)
            isOpen[componentOf(edge.a)] = true;
    std::vector<bool> result;
    for (Eigen::Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
        result.push_back(isOpen[componentOf(vertex)]);
    return result;
}

/// [N×3] a third of A n of the faces at each vertex: exact for a closed surface, where it sums to
/// zero, and at edges, where a vertex has no one normal.
Eigen::MatrixXd vertexVectorAreas(const Mesh& mesh) {
    Eigen::MatrixXd areas = Eigen::MatrixXd::Zero(mesh.vertexCount(), 3);
    for (const auto& face : mesh.faces.rowwise()) {
        const Eigen::RowVector3d a = mesh.vertices.row(face(0)), b = mesh.vertices.row(face(1)),
                                 c = mesh.vertices.row(face(2));
        const Eigen::RowVector3d third = (b - a).cross(c - a) / 6;
        for (const int corner : face)
            areas.row(corner) += third;
    }
    return areas;
}

RadiatingSurface radiatingSurface(const RadiatingBody& body) {
    const Mesh& mesh = body.mesh;
    const auto areas = vertexAreas(mesh);
    const auto vectorAreas = vertexVectorAreas(mesh), normals = vertexNormals(mesh);
    const auto isOpen = openVertices(mesh);
    const Eigen::Index points =
        mesh.vertexCount() +
        (body.thicknessMetres > 0 ? std::ranges::count(isOpen, true) : Eigen::Index{0});
    RadiatingSurface surface{Eigen::MatrixXd(points, 3), Eigen::MatrixXd(points, 3), {}, 0};
    const auto add = [&](Eigen::Index vertex, double side, double offsetMetres) {
        const auto point = static_cast<Eigen::Index>(surface.vertices.size());
        surface.pointsMetres.row(point) = mesh.vertices.row(vertex) -
                                          body.centreMetres.transpose() +
                                          side * offsetMetres * normals.row(vertex);
        surface.vectorAreasM2.row(point) = side * vectorAreas.row(vertex);
        surface.vertices.push_back(vertex);
        surface.areaM2 += areas(vertex);
    };
    for (Eigen::Index vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        const bool isSheet = body.thicknessMetres > 0 && isOpen[static_cast<std::size_t>(vertex)];
        add(vertex, 1, isSheet ? body.thicknessMetres / 2 : 0);
        if (isSheet)
            add(vertex, -1, body.thicknessMetres / 2);
    }
    return surface;
}

/// A n·φ of each point [P] for one mode.
Eigen::VectorXd
normalFlows(const RadiatingBody& body, const RadiatingSurface& surface, Eigen::Index mode) {
    Eigen::VectorXd flows(surface.vectorAreasM2.rows());
    for (Eigen::Index point = 0; point < flows.size(); ++point)
        flows(point) = surface.vectorAreasM2.row(point) *
                       body.shapes.block<3, 1>(
                           3 * surface.vertices[static_cast<std::size_t>(point)], mode);
    return flows;
}

/// A plane wave from one direction at the surface's points.
struct PlaneWave {
    double waveNumber = 0;   ///< k in rad/m
    Eigen::ArrayXcd phasors; ///< [P] e^{jk d·x}
};

/// By squaring the wave an octave below where `lower` holds it: sines take most of the time.
PlaneWave planeWave(double waveNumber,
                    const Eigen::VectorXd& distancesMetres,
                    const std::vector<PlaneWave>& lower) {
    PlaneWave wave{waveNumber, Eigen::ArrayXcd(distancesMetres.size())};
    const auto octaveBelow = std::ranges::find_if(lower, [&](const PlaneWave& other) {
        return std::abs(2 * other.waveNumber - waveNumber) <= 1e-12 * waveNumber;
    });
    if (octaveBelow != lower.end()) {
        wave.phasors = octaveBelow->phasors.square();
        return wave;
    }
    const Eigen::ArrayXd phases = waveNumber * distancesMetres.array();
    wave.phasors.real() = phases.cos();
    wave.phasors.imag() = phases.sin();
    return wave;
}

/// Fills the table's weights of one mode with those flows [P]; `distancesMetres` [P×D].
void addMode(const Eigen::VectorXd& flows,
             const Eigen::MatrixXd& distancesMetres,
             double eigenvalue,
             Eigen::Index mode,
             Eigen::Index modeCount,
             RadiationTable& table) {
    auto* row = table.weights.data() + mode;
    for (Eigen::Index direction = 0; direction < distancesMetres.cols(); ++direction) {
        std::vector<PlaneWave> waves;
        for (const double ratio : table.frequencyRatios) {
            const double omega = ratio * std::sqrt(eigenvalue);
            const double waveNumber = std::clamp(omega, 2 * std::numbers::pi * lowestAudibleHz,
                                                 2 * std::numbers::pi * highestAudibleHz) /
                                      speedOfSoundMetresPerSecond;
            if (waves.empty() || waves.back().waveNumber != waveNumber)
                waves.push_back(planeWave(waveNumber, distancesMetres.col(direction), waves));
            const std::complex<double> sum = (waves.back().phasors * flows.array()).sum();
            *row = std::complex<float>(std::complex<double>(0, omega * airDensityKgPerM3) /
                                       (4 * std::numbers::pi) * sum);
            row += modeCount;
        }
    }
}

std::string
faultOf(const RadiatingBody& body, const RadiationSettings& settings, double surfaceAreaM2) {
    if (body.shapes.rows() != 3 * body.mesh.vertexCount() ||
        body.shapes.cols() != body.eigenvalues.size() || body.shapes.cols() == 0)
        return "The mode shapes to be heard do not belong to the mesh.";
    if (settings.directions.empty() || settings.frequencyRatios.empty())
        return "Radiation needs a direction and a frequency ratio.";
    if (!(surfaceAreaM2 > 0))
        return "The surface has no area to radiate from.";
    return {};
}

} // namespace

std::vector<Eigen::Vector3d> stereoDirections() {
    constexpr double degree = std::numbers::pi / 180, elevation = 40 * degree;
    std::vector<Eigen::Vector3d> directions;
    for (const double azimuth : {115 * degree, 65 * degree})
        directions.emplace_back(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    return directions;
}

std::vector<Eigen::Vector3d> directionsAllAround() {
    auto directions = stereoDirections();
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x != 0 || y != 0 || z != 0)
                    directions.push_back(Eigen::Vector3d(x, y, z).normalized());
    return directions;
}

std::vector<double> halfOctaveRatios() {
    std::vector<double> ratios;
    for (int step = -4; step <= 4; ++step)
        ratios.push_back(std::exp2(step / 2.0));
    return ratios;
}

Result<RadiationTable> radiationOf(const RadiatingBody& body,
                                   const RadiationSettings& settings,
                                   const WorkControl& control) {
    const auto surface = radiatingSurface(body);
    if (const auto fault = faultOf(body, settings, surface.areaM2); !fault.empty())
        return failure(fault);
    RadiationTable table{
        .directions = {}, .frequencyRatios = settings.frequencyRatios, .weights = {}};
    Eigen::MatrixXd distancesMetres(surface.pointsMetres.rows(),
                                    static_cast<Eigen::Index>(settings.directions.size()));
    for (const auto& direction : settings.directions) {
        const Eigen::Vector3d unit = direction.normalized();
        distancesMetres.col(static_cast<Eigen::Index>(table.directions.size())) =
            surface.pointsMetres * unit;
        const Eigen::Vector3f single = unit.cast<float>();
        table.directions.push_back({single.x(), single.y(), single.z()});
    }
    const Eigen::Index modeCount = body.eigenvalues.size();
    table.weights.resize(settings.directions.size() * settings.frequencyRatios.size() *
                         static_cast<std::size_t>(modeCount));
    for (Eigen::Index mode = 0; mode < modeCount; ++mode) {
        if (control.isCancelled())
            return cancellation();
        addMode(normalFlows(body, surface, mode), distancesMetres, body.eigenvalues(mode), mode,
                modeCount, table);
    }
    return table;
}

} // namespace idiophone
