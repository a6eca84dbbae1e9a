#include "Analysis/ModalAnalysis.h"

#include "Analysis/Radiation.h"
#include "Analysis/TwoLayerShell.h"
#include "Geometry/ParametricMesh.h"
#include "Support/GeneratedMeshes.h"
#include "TestMaterials.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <limits>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

AnalysisSettings barSettings() {
    AnalysisSettings settings;
    settings.name = "bar";
    settings.material = referenceWood();
    settings.method = AnalysisMethod::twoLayer;
    settings.thicknessMetres = 0.02;
    settings.maxFrequencyHz = 12000;
    return settings;
}

std::string errorOf(const Mesh& mesh, const AnalysisSettings& settings) {
    const auto object = analyse(mesh, settings);
    return object ? "" : object.error().message;
}

} // namespace

TEST_CASE("An analysed object is complete and names its origin") {
    const auto mesh = sheetMesh(0.4, 0.05, 600);
    const auto object = analyse(mesh, barSettings());
    REQUIRE(object);
    CHECK(object->name == "bar");
    CHECK(object->method == "two-layer");
    CHECK(object->body == BodyKind::shell);
    CHECK(object->bandHz == 12000);
    CHECK(object->shapeVertexCount() == static_cast<std::size_t>(mesh.vertexCount()));
    CHECK(object->vertexCount() == static_cast<std::size_t>(mesh.vertexCount()));
    CHECK(object->faceCount() == static_cast<std::size_t>(mesh.faceCount()));
    CHECK(object->radiation.directions.size() == 2);
    CHECK(object->radiation.frequencyRatios == halfOctaveRatios());
    CHECK(object->provenance.zeroModes == 6);
    CHECK(object->provenance.analysedVertices == mesh.vertexCount());
    CHECK(object->provenance.analysisSeconds > 0);
    CHECK_THAT(object->provenance.software, ContainsSubstring("Idiophone"));
    // The mass and moments of a cuboid: two layers have a solid plate's inertia.
    const double mass = 0.4 * 0.05 * 0.02 * 1000;
    CHECK_THAT(object->mass.massKg, WithinRel(mass, 1e-12));
    for (const double coordinate : object->mass.centreMetres)
        CHECK_THAT(coordinate, WithinAbs(0, 1e-9));
    CHECK_THAT(object->mass.inertiaKgM2[8], WithinRel(mass * (0.16 + 0.0025) / 12, 0.005));
    CHECK_THAT(object->mass.inertiaKgM2[0], WithinRel(mass * (0.0025 + 0.0004) / 12, 0.03));
}

TEST_CASE("Striking at i and listening at j equals striking at j and listening at i") {
    // The displacement at j for a static force at i, Σ φ_i φ_j/λ, is symmetric for the kept modes.
    // Compare with a second, independent basis.
    const auto mesh = icosphereMesh(0.1, 2);
    auto settings = barSettings();
    settings.thicknessMetres = 0.003;
    const auto object = analyse(mesh, settings);
    // The second body has its vertices in reverse order.
    Mesh reversed{mesh.vertices.colwise().reverse(),
                  static_cast<int>(mesh.vertexCount()) - 1 - mesh.faces.array()};
    const auto other = analyse(reversed, settings);
    REQUIRE(object);
    REQUIRE(other);
    REQUIRE(object->modeCount() == other->modeCount());
    const auto response = [](const ModalObject& o, std::size_t i, std::size_t j) {
        double sum = 0;
        const auto at = o.shapesAt(i), to = o.shapesAt(j);
        for (std::size_t mode = 0; mode < o.modeCount(); ++mode)
            sum += static_cast<double>(at[3 * mode]) * static_cast<double>(to[3 * mode + 2]) /
                   o.eigenvalues[mode];
        return sum;
    };
    const auto last = static_cast<std::size_t>(mesh.vertexCount()) - 1;
    double scale = 0;
    for (std::size_t i = 0; i < 20; ++i)
        scale = std::max(scale, std::abs(response(*object, i, i)));
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{3, 90}, {17, 140}, {0, 161}}) {
        // Force along x at i, listening along z at j in one basis; the swapped path in the other.
        double swapped = 0;
        const auto at = other->shapesAt(last - j), to = other->shapesAt(last - i);
        for (std::size_t mode = 0; mode < other->modeCount(); ++mode)
            swapped += static_cast<double>(at[3 * mode + 2]) * static_cast<double>(to[3 * mode]) /
                       other->eigenvalues[mode];
        CHECK_THAT(response(*object, i, j), WithinAbs(swapped, 1e-4 * scale));
    }
}

TEST_CASE("Eigenvalues scale exactly with Y/rho and the inverse square of the size") {
    const auto mesh = sheetMesh(0.4, 0.05, 300);
    const auto settings = barSettings();
    const auto object = analyse(mesh, settings);
    REQUIRE(object);

    auto stiff = settings;
    stiff.material.youngsModulusPa *= 4;
    stiff.material.densityKgPerM3 /= 4;
    stiff.maxFrequencyHz *= 4;
    stiff.lowestFrequencyHz *= 4;
    const auto stiffer = analyse(mesh, stiff);
    REQUIRE(stiffer);
    REQUIRE(stiffer->modeCount() == object->modeCount());

    auto halved = settings;
    halved.thicknessMetres /= 2;
    halved.maxFrequencyHz *= 2;
    halved.lowestFrequencyHz *= 2;
    const auto half = analyse({mesh.vertices / 2, mesh.faces}, halved);
    REQUIRE(half);
    REQUIRE(half->modeCount() == object->modeCount());
    for (std::size_t i = 0; i < object->modeCount(); ++i) {
        CHECK_THAT(stiffer->eigenvalues[i], WithinRel(16 * object->eigenvalues[i], 1e-9));
        CHECK_THAT(half->eigenvalues[i], WithinRel(4 * object->eigenvalues[i], 1e-9));
        // Gains scale with 1/√mass: the masses are a quarter and an eighth.
        CHECK_THAT(std::abs(stiffer->shapesAt(5)[3 * i + 2]),
                   WithinAbs(2 * std::abs(object->shapesAt(5)[3 * i + 2]), 1e-4));
    }
}

TEST_CASE("The same input gives the same object bit for bit") {
    for (const auto& mesh : {sheetMesh(0.4, 0.05, 300), icosphereMesh(0.1, 3)}) {
        const auto first = analyse(mesh, barSettings()), second = analyse(mesh, barSettings());
        REQUIRE(first);
        REQUIRE(second);
        CHECK(first->eigenvalues == second->eigenvalues);
        CHECK(first->shapes == second->shapes);
        CHECK(first->radiation == second->radiation);
    }
}

TEST_CASE("The spring-mass model of a box warns of zero modes; the two-layer model has only six") {
    const auto mesh = boxMesh({0.4, 0.05, 0.02}, {20, 4, 2});
    auto settings = barSettings();
    settings.thicknessMetres = 0.005;
    settings.method = AnalysisMethod::springMass;
    const auto literal = analyse(mesh, settings);
    REQUIRE(literal);
    CHECK(literal->provenance.zeroModes == 164);
    CHECK_THAT(literal->provenance.notes, ContainsSubstring("164 zero modes"));
    settings.method = AnalysisMethod::twoLayer;
    const auto layered = analyse(mesh, settings);
    REQUIRE(layered);
    CHECK(layered->provenance.zeroModes == 6);
    CHECK_THAT(layered->provenance.notes, !ContainsSubstring("zero modes"));
}

TEST_CASE("Open, non-manifold and separate meshes are analysed") {
    const auto sheet = sheetMesh(0.2, 0.1, 150);
    Mesh crossed{Eigen::MatrixXd(2 * sheet.vertexCount(), 3),
                 Eigen::MatrixXi(2 * sheet.faceCount(), 3)}; // two sheets that cross
    crossed.vertices << sheet.vertices, sheet.vertices.col(0), sheet.vertices.col(2),
        sheet.vertices.col(1);
    crossed.faces << sheet.faces, sheet.faces.array() + static_cast<int>(sheet.vertexCount());
    auto settings = barSettings();
    settings.thicknessMetres = 0.003;
    const auto cross = analyse(crossed, settings);
    REQUIRE(cross);
    CHECK_THAT(cross->provenance.notes, ContainsSubstring("More than two faces meet at"));
    CHECK(cross->provenance.zeroModes == 6);

    auto apart = crossed;
    apart.vertices.bottomRows(sheet.vertexCount()).col(1).array() += 1;
    const auto two = analyse(apart, settings);
    REQUIRE(two);
    CHECK(two->provenance.zeroModes == 12);
    settings.largestComponentOnly = true;
    const auto one = analyse(apart, settings);
    REQUIRE(one);
    CHECK(one->provenance.zeroModes == 6);
}

TEST_CASE("A shell thicker than its mesh is wide gets a warning") {
    auto settings = barSettings();
    settings.maxFrequencyHz = 2000; // only the notes are read
    auto sheet = sheetMesh(0.4, 0.05, 100);
    if (GENERATE(false, true)) {
        const Eigen::Vector3d axis = Eigen::Vector3d(1, 2, 3).normalized();
        const Eigen::AngleAxisd turn(0.7, axis);
        sheet.vertices *= turn.toRotationMatrix().transpose();
    }
    const auto notesAt = [&](double thicknessMetres) {
        settings.thicknessMetres = thicknessMetres;
        return analyse(sheet, settings)->provenance.notes;
    };
    CHECK_THAT(notesAt(3), ContainsSubstring("3000 mm is thicker than its mesh is wide, 50 mm"));
    CHECK_THAT(notesAt(0.06), ContainsSubstring("60 mm is thicker than its mesh is wide, 50 mm"));
    for (const double plausibleMetres : {0.003, 0.02, 0.05})
        CHECK_THAT(notesAt(plausibleMetres), !ContainsSubstring("thicker than"));
}

TEST_CASE("If vertices are chosen, only they have shapes, equal to those of a full analysis") {
    const auto mesh = sheetMesh(0.4, 0.05, 300);
    auto settings = barSettings();
    const auto all = analyse(mesh, settings);
    settings.shapeVertices = {200, 3, 77, 3};
    const auto some = analyse(mesh, settings);
    REQUIRE(all);
    REQUIRE(some);
    CHECK(some->shapeVertices == std::vector<std::int32_t>{3, 77, 200});
    for (std::size_t row = 0; row < 3; ++row)
        CHECK(std::ranges::equal(some->shapesAt(row), all->shapesAt(static_cast<std::size_t>(
                                                          some->shapeVertices[row]))));
    CHECK(some->radiation == all->radiation); // radiation still covers the whole surface
    settings.shapeVertices = {-1};
    CHECK_THAT(errorOf(mesh, settings), ContainsSubstring("does not exist"));
}

TEST_CASE("Inputs that cannot be analysed give a one-sentence error") {
    const auto mesh = icosphereMesh(0.1, 2);
    const auto settings = barSettings();
    const auto with = [&](auto change) {
        auto changed = settings;
        change(changed);
        return errorOf(mesh, changed);
    };
    CHECK_THAT(with([](auto& s) { s.thicknessMetres = 0; }), ContainsSubstring("thickness"));
    CHECK_THAT(with([](auto& s) { s.thicknessMetres = std::numeric_limits<double>::quiet_NaN(); }),
               ContainsSubstring("thickness"));
    CHECK_THAT(with([](auto& s) { s.maxFrequencyHz = 10; }), ContainsSubstring("band"));
    CHECK_FALSE(with([](auto& s) { s.material.densityKgPerM3 = -1; }).empty());
    CHECK_THAT(with([](auto& s) { s.maximumModes = 3; }), ContainsSubstring("limit of 3"));
    CHECK_THAT(with([](auto& s) { s.maxFrequencyHz = 25; }), ContainsSubstring("no mode between"));
    CHECK_THAT(errorOf({mesh.vertices, Eigen::MatrixXi(0, 3)}, settings),
               ContainsSubstring("no faces"));
    auto broken = mesh;
    broken.vertices(7, 1) = std::numeric_limits<double>::infinity();
    CHECK_THAT(errorOf(broken, settings), ContainsSubstring("not a finite number"));
    auto springs = settings;
    springs.method = AnalysisMethod::springMass;
    CHECK_THAT(errorOf(gridPlateMesh(1, 1, 200, 200), springs), ContainsSubstring("at most 40000"));
}

TEST_CASE("A soup of a million triangles is refused before the analysis") {
    CHECK_THAT(errorOf(triangleSoup(), barSettings()), ContainsSubstring("simplify the mesh"));
}

TEST_CASE("A set flag cancels the analysis") {
    const std::atomic<bool> cancelled = true;
    const auto object =
        analyse(icosphereMesh(0.1, 3), barSettings(), {.progress = {}, .cancelled = &cancelled});
    REQUIRE_FALSE(object);
    CHECK(object.error().message == cancelledMessage);
}

TEST_CASE("Methods are found by their names") {
    for (const auto method :
         {AnalysisMethod::twoLayer, AnalysisMethod::springMass, AnalysisMethod::vanGelder})
        CHECK(findMethod(methodName(method)) == method);
    CHECK_FALSE(findMethod("guess"));
}
