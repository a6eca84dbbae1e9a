#include "SolvedBody.h"

#include "Analysis/QuadraticTetrahedra.h"
#include "Analysis/TetMesh.h"
#include "Analysis/TwoLayerShell.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

namespace idiophone::test {
namespace {

Eigen::SparseMatrix<double> rowsKept(const Eigen::SparseMatrix<double>& matrix,
                                     const std::vector<int>& newRow,
                                     Eigen::Index count) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
        for (Eigen::SparseMatrix<double>::InnerIterator it(matrix, column); it; ++it)
            if (newRow[it.row()] >= 0 && newRow[column] >= 0)
                entries.emplace_back(newRow[it.row()], newRow[column], it.value());
    Eigen::SparseMatrix<double> kept(count, count);
    kept.setFromTriplets(entries.begin(), entries.end());
    return kept;
}

SolvedBody solved(VibrationModel model,
                  const Eigen::MatrixXd& points,
                  const FrequencyBand& band,
                  const PointTest& clamped) {
    SolvedBody body;
    std::vector<int> newRow(static_cast<std::size_t>(3 * points.rows()), -1);
    body.points.resize(points.rows(), 3);
    Eigen::Index count = 0;
    for (Eigen::Index p = 0; p < points.rows(); ++p) {
        if (clamped && clamped(points.row(p).transpose()))
            continue;
        for (int axis = 0; axis < 3; ++axis)
            newRow[3 * p + axis] = static_cast<int>(3 * count + axis);
        body.points.row(count++) = points.row(p);
    }
    body.points.conservativeResize(count, 3);
    body.model = {.stiffness = rowsKept(model.stiffness, newRow, 3 * count),
                  .mass = rowsKept(model.mass, newRow, 3 * count),
                  .rowsPerVertex = model.rowsPerVertex};
    auto modes = solveModes(body.model, band);
    INFO((modes ? "" : modes.error().message));
    REQUIRE(modes);
    CHECK(modes->zeroModes == (clamped ? 0 : 6));
    body.modes = std::move(*modes);
    return body;
}

double inHz(double eigenvalue) {
    return std::sqrt(eigenvalue) / (2 * std::numbers::pi);
}

} // namespace

SolvedBody solvedSolid(const Mesh& closedSurface,
                       const ElasticLaw& law,
                       double densityKgPerM3,
                       double targetEdgeMetres,
                       const FrequencyBand& band,
                       const PointTest& clamped) {
    const auto mesh = tetrahedralise(closedSurface, {.targetEdgeMetres = targetEdgeMetres});
    REQUIRE(mesh);
    return solved(quadraticTetrahedra(*mesh, law, densityKgPerM3), mesh->nodes, band, clamped);
}

SolvedBody solvedShell(const Mesh& mesh,
                       const Material& material,
                       double thicknessMetres,
                       const FrequencyBand& band,
                       const PointTest& clamped) {
    const Eigen::MatrixXd offset = layerOffsetMetres(thicknessMetres) * vertexNormals(mesh);
    Eigen::MatrixXd points(2 * mesh.vertexCount(), 3);
    for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
        points.row(2 * v) = mesh.vertices.row(v) + offset.row(v);
        points.row(2 * v + 1) = mesh.vertices.row(v) - offset.row(v);
    }
    return solved(twoLayerShell(mesh, material, thicknessMetres), points, band, clamped);
}

std::vector<double> frequenciesHz(const SolvedBody& body) {
    std::vector<double> result;
    for (const double eigenvalue : body.modes.eigenvalues)
        result.push_back(inHz(eigenvalue));
    return result;
}

double frequencyLikeHz(const SolvedBody& body, const Field& field) {
    Eigen::VectorXd wanted(3 * body.points.rows());
    for (Eigen::Index p = 0; p < body.points.rows(); ++p)
        wanted.segment<3>(3 * p) = field(body.points.row(p).transpose());
    const auto mass = body.model.mass.selfadjointView<Eigen::Lower>();
    const Eigen::VectorXd momentum = mass * wanted;
    const Eigen::VectorXd likeness =
        (body.modes.shapes.transpose() * momentum).cwiseAbs2() / wanted.dot(momentum);
    Eigen::Index best = 0;
    const double greatest = likeness.maxCoeff(&best);
    REQUIRE(greatest >= 0.8);
    return inHz(body.modes.eigenvalues(best));
}

std::vector<double> inPlaneFrequenciesHz(const SolvedBody& body) {
    const auto mass = body.model.mass.selfadjointView<Eigen::Lower>();
    std::vector<double> result;
    for (Eigen::Index mode = 0; mode < body.modes.shapes.cols(); ++mode) {
        Eigen::VectorXd alongZ = Eigen::VectorXd::Zero(3 * body.points.rows());
        for (Eigen::Index p = 0; p < body.points.rows(); ++p)
            alongZ(3 * p + 2) = body.modes.shapes(3 * p + 2, mode);
        if (alongZ.dot(mass * alongZ) < 0.1)
            result.push_back(inHz(body.modes.eigenvalues(mode)));
    }
    return result;
}

} // namespace idiophone::test
