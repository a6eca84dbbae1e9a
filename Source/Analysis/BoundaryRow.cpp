#include "Analysis/BoundaryRow.h"

#include "Analysis/PanelPotentials.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace idiophone {
namespace {

using Eigen::Vector3d;

/// Distances between centroids in longest edges of the source. Near panels need closed forms, and
/// panels at middle distance need three points.
constexpr double nearDistance = 2.5, middleDistance = 6;
/// The longest edge, in radians of a wave, above which all panels need three points.
constexpr double longEdgeRadians = 1;

/// Points computed together. Array expressions of this size compile to SIMD code on any processor.
using Lanes = Eigen::Array<double, 16, 1>;

struct QuadraturePoint {
    Vector3d barycentric;
    double weight;
};

const std::vector<QuadraturePoint>& centroidRule() {
    static const std::vector<QuadraturePoint> rule{{Vector3d::Constant(1.0 / 3), 1}};
    return rule;
}

/// Exact to the second degree.
const std::vector<QuadraturePoint>& threePointRule() {
    constexpr double a = 2.0 / 3, b = 1.0 / 6, weight = 1.0 / 3;
    static const std::vector<QuadraturePoint> rule{
        {{a, b, b}, weight}, {{b, a, b}, weight}, {{b, b, a}, weight}};
    return rule;
}

/// Exact to the fourth degree (Dunavant 1985), without a point at the centroid.
const std::vector<QuadraturePoint>& sixPointRule() {
    constexpr double a = 0.445948490915965, u = 0.223381589678011;
    constexpr double b = 0.091576213509771, v = 0.109951743655322;
    static const std::vector<QuadraturePoint> rule{{{1 - 2 * a, a, a}, u}, {{a, 1 - 2 * a, a}, u},
                                                   {{a, a, 1 - 2 * a}, u}, {{1 - 2 * b, b, b}, v},
                                                   {{b, 1 - 2 * b, b}, v}, {{b, b, 1 - 2 * b}, v}};
    return rule;
}

/// Cosine and sine of phases from 0 to 1e6, within 1e-12. Computes a quarter of the phase modulo 2π
/// by power series, then doubles the angle twice.
void cosineAndSine(const Lanes& phases, Lanes& cosine, Lanes& sine) {
    constexpr double turn = 2 * std::numbers::pi;
    constexpr double toInteger = 6755399441055744.0; // 1.5·2^52; adding and subtracting it rounds
    const Lanes turns = (phases * (1 / turn) + toInteger) - toInteger;
    const Lanes x = (phases - turns * turn) * 0.25, y = x * x;
    Lanes s =
        x * (1 + y * (-1.0 / 6 +
                      y * (1.0 / 120 +
                           y * (-1.0 / 5040 +
                                y * (1.0 / 362880 + y * (-1.0 / 39916800 + y / 6227020800.0))))));
    Lanes v = // 1 − cos
        y * (0.5 + y * (-1.0 / 24 + y * (1.0 / 720 + y * (-1.0 / 40320 +
                                                          y * (1.0 / 3628800 - y / 479001600)))));
    for (int doubling = 0; doubling < 2; ++doubling) {
        const Lanes half = s;
        s = 2 * half * (1 - v);
        v = 2 * half * half;
    }
    cosine = 1 - v;
    sine = s;
}

} // namespace

std::vector<BoundaryPanel> boundaryPanels(const Mesh& mesh) {
    std::vector<BoundaryPanel> panels;
    for (const auto& face : mesh.faces.rowwise()) {
        BoundaryPanel panel;
        for (int k = 0; k < 3; ++k)
            panel.corners.col(k) = mesh.vertices.row(face(k)).transpose();
        const auto a = panel.corners.col(0), b = panel.corners.col(1), c = panel.corners.col(2);
        panel.centroid = (a + b + c) / 3;
        const Vector3d twiceArea = (b - a).cross(c - a);
        panel.areaM2 = twiceArea.norm() / 2;
        panel.normal = twiceArea.normalized();
        panel.longestEdgeMetres = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
        panels.push_back(panel);
    }
    return panels;
}

struct BoundaryRows::Equation {
    const BoundaryPanel& target;
    double waveNumber, couplingMetres;
};

BoundaryRows::NearPair BoundaryRows::nearPair(const BoundaryPanel& target,
                                              const BoundaryPanel& source) {
    const auto statics = panelPotentials(source.corners, source.normal, target.centroid);
    const double height = source.normal.dot(target.centroid - source.centroid);
    const double adjoint = target.normal.dot(statics.singleLayerGradient);
    return {.singleLayer = statics.singleLayer,
            .doubleLayer = statics.doubleLayer,
            .adjoint = adjoint,
            .hypersingular = target.normal.dot(statics.doubleLayerGradient),
            .doubleLayerOfK2 = height * statics.singleLayer / 2,
            .hypersingularOfK2 =
                (target.normal.dot(source.normal) * statics.singleLayer + height * adjoint) / 2};
}

BoundaryRows::Surroundings BoundaryRows::surroundingsOf(const BoundaryPanel& target) const {
    Surroundings result;
    for (int source = 0; source < std::ssize(panels_); ++source) {
        const BoundaryPanel& panel = panels_[source];
        const double edges = (panel.centroid - target.centroid).norm() / panel.longestEdgeMetres;
        if (edges < nearDistance) {
            result.near.push_back(source);
            result.pairs.push_back(nearPair(target, panel));
        } else if (edges < middleDistance) {
            result.middle.push_back(source);
        }
    }
    return result;
}

BoundaryRows::BoundaryRows(std::vector<BoundaryPanel> panels, std::vector<int> targets)
    : panels_(std::move(panels)), targets_(std::move(targets)), all_(panels_.size()) {
    std::iota(all_.begin(), all_.end(), 0);
    const auto addPoints = [](const BoundaryPanel& panel, const auto& rule, auto& points) {
        for (const auto& point : rule)
            points.push_back(
                {panel.corners * point.barycentric, panel.normal, point.weight * panel.areaM2});
    };
    for (const BoundaryPanel& panel : panels_) {
        addPoints(panel, centroidRule(), onePoint_);
        addPoints(panel, threePointRule(), threePoints_);
        addPoints(panel, sixPointRule(), sixPoints_);
        longestEdgeMetres_ = std::max(longestEdgeMetres_, panel.longestEdgeMetres);
    }
    for (const int target : targets_)
        surroundings_.push_back(surroundingsOf(panels_[target]));
}

template <bool isRemainder>
void BoundaryRows::add(const Equation& equation,
                       std::span<const int> sources,
                       std::span<const Point> points,
                       BoundaryRow& row) const {
    const auto [target, k, coupling] = equation;
    const std::size_t perSource = points.size() / panels_.size();
    const std::size_t count = sources.size() * perSource;
    constexpr std::size_t lanes = Lanes::SizeAtCompileTime;
    for (std::size_t first = 0; first < count; first += lanes) {
        Lanes x, y, z, nx, ny, nz, weight;
        std::array<int, lanes> owners{};
        const std::size_t used = std::min(lanes, count - first);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            // Unused lanes repeat the last point; their results are ignored.
            const std::size_t at = first + std::min(lane, used - 1);
            owners[lane] = sources[at / perSource];
            const Point& point = points[owners[lane] * perSource + at % perSource];
            const auto i = static_cast<Eigen::Index>(lane);
            x(i) = point.place.x(), y(i) = point.place.y(), z(i) = point.place.z();
            nx(i) = point.normal.x(), ny(i) = point.normal.y(), nz(i) = point.normal.z();
            weight(i) = point.weight;
        }
        const Vector3d &centre = target.centroid, &normal = target.normal;
        x = centre.x() - x;
        y = centre.y() - y;
        z = centre.z() - z;
        const Lanes inverseSquare = 1 / (x * x + y * y + z * z);
        const Lanes inverse = inverseSquare.sqrt();
        const Lanes phase = k * (inverse / inverseSquare);
        const Lanes toSource = nx * x + ny * y + nz * z; // R·n_y
        const Lanes toTarget = normal.x() * x + normal.y() * y + normal.z() * z;
        const Lanes normals = normal.x() * nx + normal.y() * ny + normal.z() * nz;
        const Lanes product = toTarget * toSource * inverseSquare;
        Lanes cosine, sine;
        cosineAndSine(phase, cosine, sine);

        // All times w/4πr: the wave e^{−jkr}, the dipole factor (1 + jkr) e^{−jkr}, and the factor
        // of `product` in N.
        Lanes waveReal = cosine, waveImaginary = -sine;
        Lanes dipoleReal = cosine + phase * sine, dipoleImaginary = phase * cosine - sine;
        const Lanes phaseSquare = phase * phase;
        Lanes crossReal = phaseSquare * cosine - 3 * dipoleReal;
        const Lanes crossImaginary = -phaseSquare * sine - 3 * dipoleImaginary;
        Lanes adjointReal = dipoleReal;
        if constexpr (isRemainder) {
            waveReal -= 1;
            adjointReal -= 1;
            dipoleReal -= 1 + phaseSquare / 2;
            crossReal += 3 + phaseSquare / 2;
        }
        const Lanes scale = weight * inverse * (1 / (4 * std::numbers::pi));
        const Lanes steep = scale * inverseSquare;
        const Lanes pressureReal =
            steep * (coupling * -(normals * dipoleImaginary + product * crossImaginary) -
                     toSource * dipoleReal);
        const Lanes pressureImaginary =
            steep *
            (coupling * (normals * dipoleReal + product * crossReal) - toSource * dipoleImaginary);
        const Lanes slopeReal = steep * toTarget * coupling * dipoleImaginary - scale * waveReal;
        const Lanes slopeImaginary =
            -steep * toTarget * coupling * adjointReal - scale * waveImaginary;
        for (std::size_t lane = 0; lane < used; ++lane) {
            const auto i = static_cast<Eigen::Index>(lane);
            const Eigen::Index source = owners[lane];
            row.pressureReal(source) += pressureReal(i);
            row.pressureImaginary(source) += pressureImaginary(i);
            row.slopeReal(source) += slopeReal(i);
            row.slopeImaginary(source) += slopeImaginary(i);
        }
    }
}

void BoundaryRows::fill(std::size_t target,
                        double waveNumber,
                        double couplingMetres,
                        BoundaryRow& row) const {
    fill({panels_[targets_[target]], waveNumber, couplingMetres}, surroundings_[target], row);
}

void BoundaryRows::fillAt(const Vector3d& pointMetres, double waveNumber, BoundaryRow& row) const {
    BoundaryPanel target;
    target.centroid = pointMetres;
    target.normal = Vector3d::UnitZ();
    fill({target, waveNumber, 0}, surroundingsOf(target), row);
}

void BoundaryRows::fill(const Equation& equation,
                        const Surroundings& around,
                        BoundaryRow& row) const {
    const auto& [target, waveNumber, couplingMetres] = equation;
    for (auto* part :
         {&row.pressureReal, &row.pressureImaginary, &row.slopeReal, &row.slopeImaginary})
        part->setZero(panels_.size());
    const auto clear = [&](int source) {
        row.pressureReal(source) = row.pressureImaginary(source) = 0;
        row.slopeReal(source) = row.slopeImaginary(source) = 0;
    };

    if (waveNumber * longestEdgeMetres_ > longEdgeRadians) {
        add<false>(equation, all_, threePoints_, row);
    } else {
        add<false>(equation, all_, onePoint_, row);
        std::ranges::for_each(around.middle, clear);
        add<false>(equation, around.middle, threePoints_, row);
    }
    std::ranges::for_each(around.near, clear);
    add<true>(equation, around.near, sixPoints_, row);
    const double k2 = waveNumber * waveNumber;
    for (std::size_t n = 0; n < around.near.size(); ++n) {
        const int source = around.near[n];
        const NearPair& pair = around.pairs[n];
        row.pressureReal(source) -= pair.doubleLayer + k2 * pair.doubleLayerOfK2;
        row.pressureImaginary(source) +=
            couplingMetres * (pair.hypersingular + k2 * pair.hypersingularOfK2);
        row.slopeReal(source) -= pair.singleLayer;
        row.slopeImaginary(source) += couplingMetres * pair.adjoint;
    }
}

} // namespace idiophone
