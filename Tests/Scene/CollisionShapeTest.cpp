// Tests the collision shapes of bodies by the bodies that hit them.
#include "Instrument/ObjectLibrary.h"
#include "Scene/SceneAssets.h"
#include "Scene/TestBodies.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <tuple>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;

namespace {

constexpr double stepsPerSecond = 2000;
constexpr double ballRadius = 0.005;

/// Returns the place of a ball after its fall onto a fixed body at the origin.
Eigen::Vector3d
ballAfter(double seconds, const RigidWorld::Kind& fixed, const Eigen::Vector3d& from) {
    RigidWorld world({fixed, ballKind(ballRadius, {.restitution = 0})}, stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const auto ball = world.add(1, at(from));
    while (world.seconds() < seconds)
        world.step();
    return world.centre(ball);
}

/// Returns the lower half of a thin sphere about the origin.
std::shared_ptr<ModalObject> bowl(double radiusMetres, double thicknessMetres) {
    Mesh mesh = icosphereMesh(radiusMetres, 4);
    Eigen::Index kept = 0;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const auto height = mesh.vertices(mesh.faces.row(face).transpose(), 2).maxCoeff();
        if (height < 0)
            mesh.faces.row(kept++) = mesh.faces.row(face).eval();
    }
    mesh.faces.conservativeResize(kept, 3);
    auto object = objectOf(mesh, "Steel");
    object->body = BodyKind::shell;
    object->thicknessMetres = thicknessMetres;
    return object;
}

/// Returns a mesh that has one triangle many times.
Mesh heap(Eigen::Index faces) {
    Mesh mesh{Eigen::MatrixXd{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}, Eigen::MatrixXi(faces, 3)};
    mesh.faces.rowwise() = Eigen::RowVector3i(0, 1, 2);
    return mesh;
}

/// Returns layers of parallel bars that do not touch, along two axes in turn.
Mesh lattice(int bars) {
    Mesh mesh{Eigen::MatrixXd(6 * bars * bars, 3), Eigen::MatrixXi(2 * bars * bars, 3)};
    const double pitch = 1.0 / bars;
    int face = 0;
    for (int layer = 0; layer < 2 * bars; ++layer)
        for (int bar = 0; bar < bars; ++bar, ++face) {
            const double y = bar * pitch, z = layer * pitch / 2;
            Eigen::Matrix3d corners{{0, y, z}, {1, y, z}, {1, y + pitch / 10, z}};
            if (layer % 2 == 1)
                corners.col(0).swap(corners.col(1));
            mesh.vertices.middleRows(3 * face, 3) = corners;
            mesh.faces.row(face) << 3 * face, 3 * face + 1, 3 * face + 2;
        }
    return mesh;
}

/// Adds a face at this distance along each axis.
Mesh withFaceAt(double metres, Mesh mesh) {
    const auto first = mesh.vertexCount(), faces = mesh.faceCount();
    mesh.vertices.conservativeResize(first + 3, 3);
    mesh.vertices.bottomRows(3).setConstant(metres);
    mesh.vertices.bottomRightCorner(2, 2).diagonal().array() += 1;
    mesh.faces.conservativeResize(faces + 1, 3);
    mesh.faces.row(faces).setLinSpaced(static_cast<int>(first), static_cast<int>(first + 2));
    return mesh;
}

/// Returns a heap whose faces share no vertices.
Mesh looseHeap(Eigen::Index faces) {
    Mesh mesh{heap(1).vertices.replicate(faces, 1), Eigen::MatrixXi(faces, 3)};
    for (Eigen::Index face = 0; face < faces; ++face)
        mesh.faces.row(face).setLinSpaced(static_cast<int>(3 * face),
                                          static_cast<int>(3 * face + 2));
    return mesh;
}

BodyTemplate surfaceKind() {
    BodyTemplate kind;
    kind.name = "floor";
    kind.object = "floor.modal";
    kind.form = BodyForm::surface;
    kind.isFixed = true;
    return kind;
}

} // namespace

TEST_CASE("A ball falls through a round or flat ring, but not through its section or a hull") {
    const double radius = 0.05;
    const bool isRound = GENERATE(true, false);
    const auto object = isRound ? objectOf(torusMesh(radius, 0.005, 48, 12), "Steel")
                                : objectOf(tubeMesh(0.06, 0.04, 0.004, 64), "Steel");
    const double top = isRound ? 0.005 : 0.002;
    const auto ring = kindOf(object, BodyForm::ring, true, {});
    CHECK(ballAfter(0.5, ring, {0, 0, 0.1}).z() < -1);
    const double turn = GENERATE(0.0, 0.7, 2.0);
    const auto onTop =
        ballAfter(0.1, ring, {radius * std::cos(turn), radius * std::sin(turn), 0.03});
    CHECK_THAT(onTop.z(), WithinAbs(top + ballRadius, 2e-3));
    const auto hull = kindOf(object, BodyForm::hull, true, {});
    CHECK_THAT(ballAfter(0.5, hull, {0, 0, 0.1}).z(), WithinAbs(top + ballRadius, 1e-3));
}

TEST_CASE("A shape is as high as its mesh") {
    const auto box = boxMesh({0.05, 0.03, 0.02}, {4, 4, 4});
    const auto [mesh, form, shareLost] = GENERATE_COPY(
        std::tuple{box, BodyForm::hull, 0.03},
        std::tuple{icosphereMesh(0.02, 4), BodyForm::hull, 0.08}, // a hull keeps few corners
        std::tuple{icosphereMesh(0.02, 3), BodyForm::sphere, 0.03},
        std::tuple{tubeMesh(0.02, 0.01, 0.05, 48), BodyForm::cylinder, 0.03},
        std::tuple{box, BodyForm::ground, 0.03});
    INFO(static_cast<int>(form));
    const double top = mesh.vertices.col(2).maxCoeff();
    const auto ball = ballAfter(0.1, kindOf(objectOf(mesh, "Steel"), form, true, {}), {0, 0, 0.04});
    CHECK_THAT(ball.z(), WithinAbs(top + ballRadius, shareLost * top));
}

TEST_CASE("A rolling cylinder keeps its speed") {
    const double radius = 0.02, length = 0.06, speed = 0.4;
    auto object = objectOf(tubeMesh(radius, radius / 2, length, 64), "Steel");
    const double mass = 0.3, along = mass * radius * radius / 2,
                 across = mass * (3 * radius * radius + length * length) / 12;
    object->mass = {.massKg = mass, .inertiaKgM2 = {across, 0, 0, 0, across, 0, 0, 0, along}};
    RigidWorld world({groundKind(), kindOf(object, BodyForm::cylinder, false, {})}, stepsPerSecond,
                     gravity);
    world.add(0, at({0, 0, 0}));
    BodyMotion rolling = at({0, 0, radius}, {speed, 0, 0}, {0, speed / radius, 0});
    rolling.pose.rotate(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()));
    const auto body = world.add(1, rolling);
    while (world.seconds() < 1)
        world.step();
    // Contacts lag by a fraction of a step. The lag drives a rolling body by a thousandth of
    // gravity.
    const auto motion = world.motion(body);
    CHECK_THAT(motion.velocity.x(), WithinAbs(speed, 0.03 * speed));
    CHECK_THAT(motion.spin.y(), WithinAbs(motion.velocity.x() / radius, 0.1));
    CHECK_THAT(world.centre(body).z(), WithinAbs(radius, 5e-4));
    CHECK_THAT(world.centre(body).x(), WithinAbs(speed, 0.02 * speed));
}

TEST_CASE("A ball rolls in a bowl, along its wall, from one side to the other") {
    const double radius = 0.1, thickness = 0.002;
    const double inside = radius - thickness / 2 - ballRadius; // of the ball's centre
    RigidWorld world({kindOf(bowl(radius, thickness), BodyForm::surface, true, {}),
                      ballKind(ballRadius, {.restitution = 0})},
                     stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    const double angle = 0.5;
    const auto ball = world.add(1, at({inside * std::sin(angle), 0, -inside * std::cos(angle)}));
    double farthestLeft = 0;
    while (world.seconds() < 1) {
        world.step();
        const Eigen::Vector3d centre = world.centre(ball);
        CHECK_THAT(centre.norm(), WithinAbs(inside, 1e-3));
        farthestLeft = std::min(farthestLeft, centre.x());
    }
    CHECK(farthestLeft < -0.7 * inside * std::sin(angle));
}

TEST_CASE("A flat surface of fine faces pushes a rolling ball straight up") {
    const double speed = GENERATE(0.1, 0.4, 1.0), metres = 0.2;
    RigidWorld world(
        {kindOf(objectOf(sheetMesh(0.4, 0.4, 10'000), "Steel"), BodyForm::surface, true, {}),
         ballKind(ballRadius)},
        stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    world.add(1, at({-metres / 2, 0.0123, ballRadius}, {speed, speed / 7, 0},
                    {-speed / 7 / ballRadius, speed / ballRadius, 0}));
    int touches = 0;
    const auto isStraight = [](const Eigen::Vector3d& along) {
        return along.head<2>().norm() < 1e-3 * std::abs(along.z());
    };
    while (world.seconds() < metres / speed) {
        world.step();
        for (const auto& touch : world.touches()) {
            CHECK(isStraight(touch.inward[0]));
            ++touches;
        }
    }
    CAPTURE(speed);
    CHECK(touches > 50);
}

TEST_CASE("A thin plate comes to rest even if it lies askew in its mesh") {
    const double thickness = 0.0006, side = 0.05;
    const double degrees = GENERATE(0.0, 5.0, 45.0);
    Mesh mesh = boxMesh({side, side, thickness}, {4, 4, 1});
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Eigen::Vector3d(1, 0.3, 0).normalized())
            .toRotationMatrix();
    mesh.vertices *= turn.transpose();
    auto object = objectOf(mesh, "Steel");
    const double mass = side * side * thickness * 7850, across = mass * side * side / 12;
    const Eigen::Matrix3d inertia =
        turn * Eigen::Vector3d(across, across, 2 * across).asDiagonal() * turn.transpose();
    object->mass = {.massKg = mass};
    Eigen::Map<Eigen::Matrix3d>(object->mass.inertiaKgM2.data()) = inertia;
    RigidWorld world({groundKind(), kindOf(object, BodyForm::hull, false, {.restitution = 0})},
                     stepsPerSecond, gravity);
    world.add(0, at({0, 0, 0}));
    BodyMotion lying = at({0, 0, 0.002});
    lying.pose.rotate(turn.transpose());
    const auto plate = world.add(1, lying);
    while (world.seconds() < 0.5)
        world.step();
    CHECK_THAT(world.centre(plate).z(), WithinAbs(thickness / 2, 1e-4));
}

TEST_CASE("A body falls on through a ring with loose points and faces without area") {
    Mesh mesh{Eigen::MatrixXd{{0.012, 0.001, 0.001},
                              {-0.012, 0.002, 0.012},
                              {0.001, 0.012, -0.012},
                              {0.003, -0.012, 0.002}},
              Eigen::MatrixXi(8, 3)};
    for (int face = 0; face < 8; ++face)
        mesh.faces.row(face).setConstant(face / 2);
    for (int turn = 0; turn < 12; ++turn) {
        RigidWorld world(
            {cubeKind(0.02), kindOf(objectOf(mesh, "Steel"), BodyForm::ring, true, {})},
            stepsPerSecond, gravity);
        BodyMotion falling = at({0.002 * turn - 0.012, 0.001, 0.03});
        falling.pose.rotate(
            Eigen::AngleAxisd(0.4 * turn, Eigen::Vector3d(1, 0.5, 0.2).normalized()));
        const auto cube =
            world.add(0, falling); // added before the part that Bullet takes for the second hull
        world.add(1, at({0, 0, 0}));
        while (world.seconds() < 0.15)
            world.step();
        CHECK(world.centre(cube).allFinite());
    }
}

TEST_CASE("A hull too thin for any margin still collides, or the body is refused") {
    const double thickness = GENERATE(1e-300, 1e-165, 1e-100, 1e-12, 1e-8, 1e-6);
    auto object = objectOf(sheetMesh(0.05, 0.05, 16), "Steel");
    object->body = BodyKind::shell;
    object->thicknessMetres = thickness;
    BodyTemplate kind;
    kind.name = "foil";
    kind.isFixed = true;
    const auto model = makeRigidBodyModel(kind, object);
    CHECK(model.has_value() == (thickness > 1e-9));
    if (!model)
        return;
    RigidWorld world({{.model = *model}, ballKind(ballRadius, {.restitution = 0})}, stepsPerSecond,
                     gravity);
    world.add(0, at({0, 0, 0}));
    const auto ball = world.add(1, at({0, 0, ballRadius + 0.001}));
    while (world.seconds() < 0.1)
        world.step();
    CHECK_THAT(world.centre(ball).z(), WithinAbs(ballRadius, 1e-3));
}

TEST_CASE("A body cannot move if its mass or inertia is too small to divide by") {
    const double massKg = GENERATE(0.1, 1e-30), share = GENERATE(1e-310, 1e-20, 1e-4);
    auto object = objectOf(boxMesh({0.02, 0.02, 0.02}, {2, 2, 2}), "Steel");
    object->mass = {.massKg = massKg,
                    .inertiaKgM2 = {share * massKg, 0, 0, 0, massKg, 0, 0, 0, massKg}};
    BodyTemplate kind;
    kind.name = "dust";
    const auto model = makeRigidBodyModel(kind, object);
    REQUIRE(model.has_value() == (massKg == 0.1 && share == 1e-4));
    if (!model)
        CHECK(model.error().message == "'dust' cannot move: its object 'body' has no mass");
}

TEST_CASE("A surface with too many faces is refused with a sentence that names it") {
    const auto fault = [](const Mesh& mesh) {
        const auto model = makeRigidBodyModel(surfaceKind(), objectOf(mesh, "Steel"));
        return model ? std::string() : model.error().message;
    };
    // Beyond 2^21 faces Bullet would write outside its arrays.
    for (const Eigen::Index faces : {100'001, 2'200'000})
        CHECK(fault(heap(faces)) ==
              "'floor' is no surface: its object 'body' has more than 100000 faces");
    CHECK_THAT(fault(looseHeap(20'000)),
               Catch::Matchers::EndsWith("has too many faces that lie on or across each other"));
    CHECK(fault({heap(1).vertices, Eigen::MatrixXi{{0, 0, 1}, {1, 1, 1}}}) ==
          "'floor' is no surface: its object 'body' has no face with an area");
    CHECK(fault(sheetMesh(1, 1, 40'000)).empty());
}

TEST_CASE("Duplicate faces count once") {
    const auto floor = kindOf(objectOf(heap(100'000), "Steel"), BodyForm::surface, true, {});
    CHECK(floor.model->touchingFaces.pairs < 1'000'000);
    const auto ball = ballAfter(0.3, floor, {0.03, 0.03, 0.02});
    CHECK_THAT(ball.z(), WithinAbs(ballRadius, 1e-3));
}

TEST_CASE("The surfaces of a scene have a common limit") {
    const auto isRefusedBeyond = [](std::size_t kinds,
                                    const std::shared_ptr<const ModalObject>& floor) {
        ObjectLibrary library;
        library.add("floor.modal", floor);
        Scene scene;
        scene.name = "Floors";
        scene.kinds.assign(kinds, surfaceKind());
        CHECK(SceneAssets::make(scene, library));
        scene.kinds.push_back(surfaceKind());
        CHECK(SceneAssets::make(scene, library).error().message ==
              "the surfaces in the scene 'Floors' have too many faces together");
    };
    SECTION("of touching faces") {
        Mesh heaps = looseHeap(1510);
        for (Eigen::Index vertex = 0; vertex < heaps.vertexCount(); ++vertex)
            heaps.vertices(vertex, 0) += static_cast<double>(vertex / 3 / 151);
        const std::shared_ptr<const ModalObject> floor = objectOf(heaps, "Steel");
        const auto touching = makeRigidBodyModel(surfaceKind(), floor).value()->touchingFaces;
        REQUIRE(touching.pairs > 500'000);
        isRefusedBeyond(maximumTouchingFaces.pairs / touching.pairs, floor);
    }
    SECTION("of boxes searched, even if no faces touch") {
        const std::shared_ptr<const ModalObject> floor = objectOf(lattice(80), "Steel");
        const auto touching = makeRigidBodyModel(surfaceKind(), floor).value()->touchingFaces;
        REQUIRE(touching.pairs == 0);
        REQUIRE(touching.boxes > maximumTouchingFaces.boxes / 20);
        isRefusedBeyond(maximumTouchingFaces.boxes / touching.boxes, floor);
    }
}

TEST_CASE("The work of a body on a surface grows with the faces near it") {
    const auto sheet = sheetMesh(1, 1, 12'000);
    const auto floorOf = [](const Mesh& mesh) {
        return kindOf(objectOf(mesh, "Steel"), BodyForm::surface, true, {});
    };
    auto floor = floorOf(sheet);
    const auto workOf = [&](const RigidWorld::Kind& kind, double height) {
        RigidWorld world({floor, kind}, stepsPerSecond, gravity);
        world.add(0, at({0, 0, 0}));
        world.add(1, at({0, 0, height}));
        for (int step = 0; step < 3; ++step)
            world.step();
        return world.work();
    };
    const double ofBall = workOf(ballKind(ballRadius), ballRadius);
    CHECK(ofBall > 50);
    CHECK(workOf(cubeKind(2), 1) > 500 * ofBall); // its real cost grows in the same way
    floor = floorOf(withFaceAt(10'000, sheet));
    CHECK(workOf(ballKind(ballRadius), ballRadius) == ofBall);
}
