#include "Analysis/BoundaryElements.h"

#include "Analysis/Air.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <utility>

namespace idiophone {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
/// Single precision solves these systems to 1e-5, in half of the time and memory.
using Matrix = Eigen::Matrix<std::complex<float>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A part of the velocity with less than this share of its energy is left out.
constexpr double negligibleEnergy = 1e-10;
constexpr Index rowsAtOnce = 96;

/// The edge of equilateral triangles with the same number and area. With a much larger edge, the
/// errors of N would dominate K at low frequencies, because N converges slowest.
double couplingMetresOf(const Mesh& surface) {
    return std::sqrt(4 / std::sqrt(3.0) * faceAreas(surface).mean());
}

/// Returns the faces that have collocation points.
std::vector<int> targetsOf(const SharedUnknowns& unknowns, const SurfaceOrbits& orbits) {
    std::vector<int> faces;
    for (const auto& collocation : unknowns.collocations)
        faces.push_back(orbits.firsts[collocation.orbit]);
    return faces;
}

} // namespace

/// The part of the solution that transforms by one character of the symmetry.
struct BoundaryElements::CharacterSystem {
    Eigen::RowVectorXcd character;  ///< [G]
    std::vector<Index> modes;       ///< indices of the velocities that contain this part
    std::vector<bool> isSilent;     ///< [orbits] where this part is zero by symmetry
    Eigen::MatrixXd realParts;      ///< [orbits×modes] of the velocity
    Eigen::MatrixXd imaginaryParts; ///< [orbits×modes], or empty if the character is real
    Matrix matrix;                  ///< [n×n]
    Eigen::MatrixXcd rightSide;     ///< [n×modes]
};

BoundaryElements::BoundaryElements(const Mesh& surface,
                                   SurfaceSymmetry symmetry,
                                   Index maximumUnknowns)
    : symmetry_(std::move(symmetry)), orbits_(orbitsOf(symmetry_, surface)),
      unknowns_(sharedUnknowns(boundaryPanels(surface), orbits_, maximumUnknowns)),
      rows_(boundaryPanels(surface), targetsOf(unknowns_, orbits_)),
      largestCouplingMetres_(couplingMetresOf(surface)) {}

Eigen::MatrixXd BoundaryElements::arranged(const Eigen::ArrayXd& values) const {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(orbitCount(), symmetryOrder());
    for (Index face = 0; face < faceCount(); ++face)
        result(orbits_.orbits[face], orbits_.elements[face]) = values(face);
    return result;
}

std::vector<bool> BoundaryElements::silentOrbits(const Eigen::RowVectorXcd& character) const {
    std::vector<bool> result = orbits_.areFixed;
    for (std::size_t orbit = 0; orbit < result.size(); ++orbit) {
        if (!result[orbit])
            continue;
        const auto first = static_cast<std::size_t>(orbits_.firsts[orbit]);
        result[orbit] = false;
        for (std::size_t element = 0; element < symmetry_.images.size(); ++element)
            if (symmetry_.images[element][first] == orbits_.firsts[orbit] &&
                std::abs(character(element) - 1.0) > 1e-9)
                result[orbit] = true;
    }
    return result;
}

std::vector<BoundaryElements::CharacterSystem>
BoundaryElements::systemsFor(const Eigen::MatrixXd& normalVelocities) const {
    const Index order = symmetryOrder(), modes = normalVelocities.cols();
    const Eigen::RowVectorXd energies = normalVelocities.colwise().squaredNorm();
    std::vector<CharacterSystem> systems;
    for (Index row = 0; row < order; ++row) {
        CharacterSystem system;
        system.character = symmetry_.characters.row(row);
        const bool isReal = system.character.imag().cwiseAbs().maxCoeff() < 1e-12;
        Eigen::MatrixXd real = Eigen::MatrixXd::Zero(orbitCount(), modes);
        Eigen::MatrixXd imaginary = Eigen::MatrixXd::Zero(isReal ? 0 : orbitCount(), modes);
        for (Index element = 0; element < order; ++element) {
            const auto& images = symmetry_.images[element];
            const Complex share = std::conj(system.character(element)) / static_cast<double>(order);
            for (Index orbit = 0; orbit < orbitCount(); ++orbit) {
                const int image = images[orbits_.firsts[orbit]];
                real.row(orbit) += share.real() * normalVelocities.row(image);
                if (!isReal)
                    imaginary.row(orbit) += share.imag() * normalVelocities.row(image);
            }
        }
        for (Index mode = 0; mode < modes; ++mode)
            if (static_cast<double>(order) *
                    (real.col(mode).squaredNorm() + imaginary.col(mode).squaredNorm()) >
                negligibleEnergy * energies(mode))
                system.modes.push_back(mode);
        if (system.modes.empty())
            continue;
        system.isSilent = silentOrbits(system.character);
        system.realParts = real(Eigen::all, system.modes);
        system.imaginaryParts = imaginary(Eigen::all, system.modes);
        system.matrix = Matrix::Zero(unknownCount(), unknownCount());
        system.rightSide = Eigen::MatrixXcd::Zero(unknownCount(), system.modes.size());
        systems.push_back(std::move(system));
    }
    return systems;
}

Result<void> BoundaryElements::assemble(double waveNumber,
                                        std::vector<CharacterSystem>& systems,
                                        const WorkControl& control) const {
    const double coupling = std::min(1 / waveNumber, largestCouplingMetres_);
    const Complex beta(0, -coupling), slopeOfVelocity(0, -waveNumber * airImpedancePaSPerM);
    const auto count = static_cast<Index>(systems.size());
    Eigen::MatrixXcd characters(symmetryOrder(), count);
    for (Index s = 0; s < count; ++s)
        characters.col(s) = systems[s].character.transpose();
    const Eigen::MatrixXcd none = Eigen::MatrixXcd::Zero(rowsAtOnce, orbitCount());
    std::vector<Eigen::MatrixXcd> slopes(systems.size(), none);
    BoundaryRow row;
    const auto equations = static_cast<Index>(unknowns_.collocations.size());
    const auto unknownOf = [&](Index orbit) { return unknowns_.ofOrbits[orbit]; };
    for (Index first = 0; first < equations; first += rowsAtOnce) {
        if (control.isCancelled())
            return cancellation();
        const auto rows = std::span(unknowns_.collocations)
                              .subspan(first, std::min(rowsAtOnce, equations - first));
        // The equations of an unknown follow each other, and their sources are summed.
        std::vector<Index> unknowns;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            const auto [target, share] = rows[r];
            const bool isNew = unknowns.empty() || unknowns.back() != unknownOf(target);
            if (isNew)
                unknowns.push_back(unknownOf(target));
            rows_.fill(static_cast<std::size_t>(first) + r, waveNumber, coupling, row);
            const Eigen::MatrixXcd ofPressure =
                share * (arranged(row.pressureReal) * characters +
                         Complex(0, 1) * (arranged(row.pressureImaginary) * characters));
            const Eigen::MatrixXcd ofSlope =
                share * (arranged(row.slopeReal) * characters +
                         Complex(0, 1) * (arranged(row.slopeImaginary) * characters));
            for (Index s = 0; s < count; ++s) {
                auto& system = systems[s];
                auto source = slopes[s].row(std::ssize(unknowns) - 1);
                if (isNew)
                    source.setZero();
                if (system.isSilent[target])
                    continue;
                auto equation = system.matrix.row(unknownOf(target));
                for (Index orbit = 0; orbit < orbitCount(); ++orbit)
                    if (!system.isSilent[orbit])
                        equation(unknownOf(orbit)) += Matrix::Scalar(ofPressure(orbit, s));
                equation(unknownOf(target)) += static_cast<float>(share / 2);
                source += ofSlope.col(s).transpose();
                source(target) -= share * beta / 2.0;
            }
        }
        for (Index s = 0; s < count; ++s) {
            auto& system = systems[s];
            const auto used = slopes[s].topRows(std::ssize(unknowns));
            Eigen::MatrixXcd sources = used * system.realParts;
            if (system.imaginaryParts.size() > 0)
                sources += Complex(0, 1) * (used * system.imaginaryParts);
            for (std::size_t u = 0; u < unknowns.size(); ++u)
                system.rightSide.row(unknowns[u]) += slopeOfVelocity * sources.row(u);
        }
    }
    // Unknowns without an equation become 0.
    for (auto& system : systems)
        for (Index unknown = 0; unknown < unknownCount(); ++unknown)
            if (system.matrix(unknown, unknown) == Matrix::Scalar(0))
                system.matrix(unknown, unknown) = 1;
    return {};
}

Result<Eigen::MatrixXcd> BoundaryElements::surfacePressures(double waveNumber,
                                                            const Eigen::MatrixXd& normalVelocities,
                                                            const WorkControl& control) const {
    auto systems = systemsFor(normalVelocities);
    if (const auto assembled = assemble(waveNumber, systems, control); !assembled)
        return tl::unexpected(assembled.error());
    Eigen::MatrixXcd pressures = Eigen::MatrixXcd::Zero(faceCount(), normalVelocities.cols());
    for (auto& system : systems) {
        if (control.isCancelled())
            return cancellation();
        const Eigen::PartialPivLU<Eigen::Ref<Matrix>> factors(system.matrix);
        const Eigen::MatrixXcd solution =
            factors.solve(system.rightSide.cast<Matrix::Scalar>()).template cast<Complex>();
        for (Index face = 0; face < faceCount(); ++face) {
            const int orbit = orbits_.orbits[face];
            if (system.isSilent[orbit])
                continue;
            pressures(face, system.modes) +=
                system.character(orbits_.elements[face]) * solution.row(unknowns_.ofOrbits[orbit]);
        }
    }
    return pressures;
}

Eigen::MatrixXcd BoundaryElements::planeWaves(double waveNumber,
                                              const Eigen::MatrixXd& directions,
                                              const Eigen::Vector3d& originMetres) const {
    Eigen::MatrixXcd waves(directions.rows(), faceCount());
    for (Index face = 0; face < faceCount(); ++face) {
        const BoundaryPanel& panel = rows_.panels()[face];
        const Complex strength(0, waveNumber * panel.areaM2 / (4 * std::numbers::pi));
        for (Index direction = 0; direction < directions.rows(); ++direction) {
            // The midpoints of the sides integrate exactly to the second degree.
            Complex wave = 0;
            for (int side = 0; side < 3; ++side) {
                const Eigen::Vector3d middle =
                    (panel.corners.col(side) + panel.corners.col((side + 1) % 3)) / 2 -
                    originMetres;
                wave += std::polar(1.0 / 3, waveNumber * directions.row(direction).dot(middle));
            }
            waves(direction, face) = strength * wave;
        }
    }
    return waves;
}

Eigen::MatrixXd BoundaryElements::cosines(const Eigen::MatrixXd& directions) const {
    Eigen::MatrixXd normals(3, faceCount());
    for (Index face = 0; face < faceCount(); ++face)
        normals.col(face) = rows_.panels()[face].normal;
    return directions * normals;
}

Eigen::MatrixXcd BoundaryElements::farField(double waveNumber,
                                            const Eigen::MatrixXd& directions,
                                            const Eigen::Vector3d& originMetres,
                                            const Eigen::MatrixXd& normalVelocities,
                                            const Eigen::MatrixXcd& pressures) const {
    const Eigen::MatrixXcd waves = planeWaves(waveNumber, directions, originMetres);
    return airImpedancePaSPerM * (waves * normalVelocities) +
           waves.cwiseProduct(cosines(directions)) * pressures;
}

Eigen::MatrixXcd BoundaryElements::pressuresAt(double waveNumber,
                                               const Eigen::MatrixXd& pointsMetres,
                                               const Eigen::MatrixXd& normalVelocities,
                                               const Eigen::MatrixXcd& pressures) const {
    const Complex slopeOfVelocity(0, -waveNumber * airImpedancePaSPerM);
    Eigen::MatrixXcd result(pointsMetres.rows(), pressures.cols());
    BoundaryRow row;
    for (Index point = 0; point < pointsMetres.rows(); ++point) {
        // p = K p − S q.
        rows_.fillAt(pointsMetres.row(point).transpose(), waveNumber, row);
        const Eigen::RowVectorXcd ofPressure =
            -(row.pressureReal.cast<Complex>() + Complex(0, 1) * row.pressureImaginary)
                 .matrix()
                 .transpose();
        const Eigen::RowVectorXcd ofSlope =
            (row.slopeReal.cast<Complex>() + Complex(0, 1) * row.slopeImaginary)
                .matrix()
                .transpose();
        result.row(point) =
            ofPressure * pressures + slopeOfVelocity * (ofSlope * normalVelocities.cast<Complex>());
    }
    return result;
}

Eigen::MatrixXcd BoundaryElements::shortWaveField(double waveNumber,
                                                  const Eigen::MatrixXd& directions,
                                                  const Eigen::Vector3d& originMetres,
                                                  const Eigen::MatrixXd& normalVelocities) const {
    const Eigen::MatrixXd visible = (cosines(directions).array() > 0).cast<double>();
    return 2 * airImpedancePaSPerM *
           (planeWaves(waveNumber, directions, originMetres).cwiseProduct(visible) *
            normalVelocities);
}

} // namespace idiophone
