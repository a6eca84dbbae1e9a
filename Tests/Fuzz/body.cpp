// Fuzzes rigid bodies of any mesh, as scenes make them: they fall on a ground, and others fall on
// them.
#include "Fuzz/FuzzTarget.h"
#include "Fuzz/LatticeMesh.h"
#include "Scene/TestBodies.h"

namespace idiophone::fuzz {
namespace {

constexpr double latticeMetres = 0.01;
constexpr auto mostPairs = 150'000; // pairs of faces of a surface; more take over a second

/// Returns the template that the bits of a byte choose.
BodyTemplate templateOf(unsigned char bits) {
    BodyTemplate kind;
    kind.name = "body";
    kind.form = static_cast<BodyForm>((bits & 7) % 7);
    kind.isFixed = (bits & 8) != 0 || hasFaces(kind.form) || kind.form == BodyForm::ground;
    return kind;
}

/// Makes a shell if the byte's fifth bit is set. The last three bits divide its 2 mm by powers of
/// 1000.
std::shared_ptr<ModalObject> objectOf(const Mesh& mesh, unsigned char bits) {
    const bool isShell = (bits & 16) != 0;
    auto object = test::objectOf({latticeMetres * mesh.vertices, mesh.faces}, "Steel");
    object->body = isShell ? BodyKind::shell : BodyKind::solid;
    object->thicknessMetres = isShell ? 0.002 * std::pow(1000.0, -(bits >> 5)) : 0;
    object->mass = {.massKg = 0.1, .inertiaKgM2 = {1e-4, 0, 0, 0, 1e-4, 0, 0, 0, 1e-4}};
    return object;
}

} // namespace

void examine(std::string_view bytes) {
    if (bytes.size() < 2)
        return;
    const auto bits = static_cast<unsigned char>(bytes[0]);
    const auto mesh = latticeMesh(bytes.substr(1));
    if (mesh.faceCount() == 0)
        return; // objects have faces
    const auto object = objectOf(mesh, bits);
    const auto model = makeRigidBodyModel(templateOf(bits), object);
    if (!model)
        return claimSentence(model.error());
    if ((*model)->touchingFaces.pairs > mostPairs)
        return;
    RigidWorld world(
        {test::groundKind(), test::cubeKind(0.02), {.model = *model}, test::ballKind(0.005)}, 1000,
        test::gravity);
    const double top = latticeMetres * mesh.vertices.col(2).maxCoeff();
    world.add(0, test::at({0, 0, -0.001}));
    // Bullet orders the two bodies of a contact by when they were added.
    const auto cube = world.add(1, test::at({-0.02, 0.02, top + 0.012}, {0, 0, -0.5}, {3, 2, 1}));
    const auto body = world.add(2, test::at({0, 0, 0}));
    const auto ball = world.add(3, test::at({0.02, 0.02, top + 0.007}, {0, 0, -0.5}));
    for (int step = 0; step < 20; ++step) {
        world.step();
        for (const auto each : {cube, body, ball})
            claim(world.centre(each).allFinite(), "bodies are somewhere");
        for (const auto& impact : world.impacts())
            claim(impact.impulseNewtonSeconds.allFinite(), "impacts have an impulse");
    }
}

} // namespace idiophone::fuzz
