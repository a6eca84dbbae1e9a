// Modal objects in glTF files. Tests/Console/test_gltf.py compares their sound with the draft.
#include "Gltf/GltfObject.h"
#include "Gltf/ObjectFile.h"
#include "Gltf/PrincipalInertia.h"
#include "Support/SyntheticObject.h"
#include "Support/TestFolder.h"

#include <Eigen/Geometry>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("Moments of inertia come back from their principal axes") {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -3).normalized()).toRotationMatrix();
    const Eigen::Matrix3d inertia = turn * Eigen::Vector3d(1, 2, 5).asDiagonal() * turn.transpose();
    std::array<double, 9> matrix{};
    Eigen::Map<Eigen::Matrix3d>(matrix.data()) = inertia;
    const auto principal = principalInertia(matrix);
    CHECK_THAT(principal.diagonalKgM2[0], WithinAbs(1, 1e-12));
    CHECK_THAT(principal.diagonalKgM2[2], WithinAbs(5, 1e-12));
    const auto again = inertiaMatrix(principal);
    for (std::size_t k = 0; k < 9; ++k)
        CHECK_THAT(again[k], WithinAbs(matrix[k], 1e-12));
}

TEST_CASE("A roughness comes back from its finish") {
    for (const double roughness : {0.0, 0.1, 0.5, 0.9, 1.0})
        CHECK_THAT(roughnessOf(surfaceOf(roughness)), WithinAbs(roughness, 1e-9));
    GltfAcousticSurface surface;
    CHECK_THAT(roughnessOf(surface), WithinAbs(1.0 / 3, 1e-9)); // the draft's defaults: machined
    surface.roughnessMetres = 1e-9;
    CHECK(roughnessOf(surface) == 0);
    surface.roughnessMetres = 1;
    CHECK(roughnessOf(surface) == 1);
}

namespace {

/// Returns a model of three modes at one point.
AudioRigidBodies oneModel(std::vector<double> decaysPerSecond) {
    GltfModalModel model{.name = "model",
                         .frequenciesHz = {300, 100, 200},
                         .decaysPerSecond = std::move(decaysPerSecond),
                         .positions = Eigen::MatrixXd::Zero(1, 3),
                         .shapes = Eigen::MatrixXd::Identity(3, 3),
                         .faces = Eigen::MatrixXi(0, 3),
                         .material = 0,
                         .mass = {}};
    return {.models = {model},
            .materials = {{.name = "", .alphaPerSecond = 6, .betaSeconds = 1e-7}},
            .surfaces = {},
            .nodes = {}};
}

ModalObject objectOfModel(const AudioRigidBodies& audio, const GltfInstance& instance = {}) {
    const auto document = GltfDocument::parse(R"({"asset": {"version": "2.0"}})");
    REQUIRE(document);
    const auto object = objectOf(*document, audio, 0, instance);
    REQUIRE(object);
    return *object;
}

std::vector<double> decaysOfLaw() {
    std::vector<double> decays;
    for (const double hz : {300.0, 100.0, 200.0}) {
        const double square = std::pow(2 * std::numbers::pi * hz, 2);
        decays.push_back((6 + 1e-7 * square) / 2);
    }
    return decays;
}

} // namespace

TEST_CASE("Modes of a glTF model ascend with their shapes, and decays by the law are not stored") {
    const auto object = objectOfModel(oneModel(decaysOfLaw()));
    REQUIRE(object.modeCount() == 3);
    for (std::size_t mode = 0; mode < 3; ++mode)
        CHECK_THAT(object.dampedFrequencyHz(mode), WithinRel(100.0 * double(mode + 1), 1e-9));
    CHECK(object.decaysPerSecond.empty());
    CHECK(object.shapes == std::vector<float>{0, 1, 0, 0, 0, 1, 1, 0, 0});
    CHECK(object.faceCount() == 0);
    CHECK_THAT(object.mass.massKg, WithinRel(1.0, 1e-9)); // 1 over the mean square of the shapes
    CHECK(objectOfModel(oneModel({7, 0, 20})).decayPerSecond(0) == 1e-3);
    CHECK_THAT(objectOfModel(oneModel({7, 1, 20})).decayPerSecond(2), WithinRel(7.0, 1e-12));
}

TEST_CASE("A retuned model changes as a body of another size does") {
    const auto audio = oneModel(decaysOfLaw());
    const auto whole = objectOfModel(audio);
    const auto twice = objectOfModel(audio, {.scale = 2, .isRetuned = true});
    for (std::size_t mode = 0; mode < 3; ++mode) {
        CHECK_THAT(twice.eigenvalues[mode], WithinRel(whole.eigenvalues[mode] / 4, 1e-12));
        CHECK_THAT(twice.decayPerSecond(mode),
                   WithinRel((6 + 1e-7 * twice.eigenvalues[mode]) / 2, 1e-9));
    }
    CHECK_THAT(twice.shapes[1], WithinRel(std::pow(2.0f, -1.5f), 1e-6f));
    const auto placed = objectOfModel(audio, {.scale = 2});
    CHECK(placed.eigenvalues == whole.eigenvalues);
    CHECK(placed.shapes == whole.shapes);
}

TEST_CASE("An object without a mode that rings is not written as glTF") {
    auto object = syntheticObject({100});
    object.extraDecaysPerSecond = {1e4};
    const auto written = writeObject(object, testFolder() / "dead.glb");
    REQUIRE_FALSE(written);
    CHECK_THAT(written.error().message, ContainsSubstring("dead.glb: none of the object's modes"));
    CHECK_FALSE(std::filesystem::exists(testFolder() / "dead.glb"));
    CHECK_THAT(writeObject(syntheticObject({100}), "x.gltf").error().message,
               ContainsSubstring("not as .gltf"));
}
