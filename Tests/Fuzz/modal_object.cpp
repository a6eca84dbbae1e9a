// Fuzzes modal objects, as users import them or projects carry them, and those in glTF files.
#include "Fuzz/FuzzTarget.h"
#include "Gltf/ObjectFile.h"
#include "Object/ModalObjectFile.h"
#include "Synth/Synthesiser.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace idiophone::fuzz {
namespace {

void claimSizes(const ModalObject& object) {
    const auto modes = object.modeCount();
    claim(modes > 0 && object.shapeVertexCount() > 0, "there are modes and shapes");
    claim(object.shapes.size() == object.shapeVertexCount() * modes * 3, "shapes are whole");
    claim(object.vertices.size() % 3 == 0 && object.faces.size() % 3 == 0, "vectors are whole");
    const auto isVertex = [&](std::int32_t index) {
        return index >= 0 && static_cast<std::size_t>(index) < object.vertexCount();
    };
    claim(std::ranges::all_of(object.faces, isVertex), "faces have vertices");
    claim(std::ranges::all_of(object.shapeVertices, isVertex), "shapes have vertices");
    claim(object.radiation.empty() || object.radiation.weights.size() ==
                                          object.radiation.directions.size() *
                                              object.radiation.frequencyRatios.size() * modes,
          "the radiation is whole");
}

void claimValues(const ModalObject& object) {
    claim(object.eigenvalues.front() > 0 && std::ranges::is_sorted(object.eigenvalues),
          "eigenvalues are positive and ascend");
    claimFinite(object.eigenvalues, "eigenvalues are finite");
    claimFinite(object.shapes, "shapes are finite");
    claimFinite(object.vertices, "vertices are finite");
    claimFinite(object.bending, "bending parts are finite");
    claimFinite(object.decaysPerSecond, "decays are finite");
    claimFinite(object.extraDecaysPerSecond, "extra decays are finite");
    for (const auto* weights : {&object.radiation.weights, &object.gains})
        for (const auto weight : *weights)
            claim(std::isfinite(weight.real()) && std::isfinite(weight.imag()),
                  "radiation and gains are finite");
    claimFinite(object.radiation.frequencyRatios, "radiation's frequencies are finite");
    claimFinite(vertexNormals(object), "normals are finite");
    claimFinite(summedSquareShapes(object), "squared shapes are finite");
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
        const double damping[] = {object.eigenvalueAt(mode, 1), object.decayPerSecond(mode),
                                  object.damping(mode).scale, object.damping(mode).extraPerSecond};
        claimFinite(damping, "damping is finite");
    }
    claim(nearestShapeRow(object, {0, 0, 0}) < object.shapeVertexCount(), "a row is nearest");
}

/// Lighter objects may refuse a hard strike.
bool isHeavierThanDust(const ModalObject& object) {
    return std::ranges::all_of(object.shapes, [](float x) { return std::abs(x) <= 1e5f; });
}

/// Strikes the first, middle and last vertex, by an impulse and by a contact, and then presses on
/// the object.
void hit(Synthesiser& synth, const ModalObject& object, const CellOutput& cell) {
    const auto last = static_cast<std::int32_t>(object.shapeVertexCount() - 1);
    constexpr std::array impulse{0.3f, 0.5f, 0.8f}; // about 1 N s
    for (const auto row : {0, last / 2, last})
        for (const double seconds : {0.0, 0.002}) {
            const bool isStruck = synth.strike(0,
                                               {.point = {.shapeRows = {row}},
                                                .impulseNewtonSeconds = impulse,
                                                .durationSeconds = seconds},
                                               0.5, cell);
            claim(isStruck || !isHeavierThanDust(object), "an object can be struck");
        }
    std::array<float, cellSamples> newtons;
    newtons.fill(10);
    const ForcePoint from{.point = {.shapeRows = {0}}}, to{.point = {.shapeRows = {last}}};
    const bool isPressed = synth.applyForce(
        0, {.start = {{from, to}, 0.2f}, .end = {{from, to}, 0.8f}, .newtons = newtons}, cell);
    claim(isPressed, "an object can be pressed on");
}

void claimPlayable(const std::shared_ptr<const ModalObject>& object,
                   const SynthesisSettings& settings) {
    constexpr int cells = 8;
    Synthesiser synth({{.object = object}}, 48000, 2);
    synth.setSettings(settings);
    std::array<float, cellSamples> left, right;
    const CellOutput cell(left, right);
    for (int i = 0; i < cells; ++i) {
        if (i == cells / 2)
            synth.setFrequencyRatio(0, 0.5);
        synth.beginCell(cell);
        if (i < 2)
            hit(synth, *object, cell);
        claimFinite(left, "an object sounds finite");
        claimFinite(right, "an object sounds finite");
    }
}

} // namespace

void examine(std::string_view bytes) {
    auto object = readObject(asBytes(bytes), "fuzz.modal");
    if (!object)
        return claimSentence(object.error());
    claimSizes(*object);
    claimValues(*object);
    const auto written = encodeModalObject(*object);
    const auto again = readModalObject(written, "again.modal");
    claim(again.has_value(), "what was written can be read");
    claim(encodeModalObject(*again) == written, "what was read is written as it was");

    const auto played = std::make_shared<const ModalObject>(std::move(*object));
    claimPlayable(played, {});
    claimPlayable(played, {.tau = 0,
                           .sizeRatio = 0.5,
                           .thicknessRatio = 3,
                           .radiation = 1,
                           .material = LiveMaterial{
                               .youngsModulusPa = 2e11,
                               .densityKgPerM3 = 7800,
                               .damping = {.fluidPerSecond = 5, .viscoelasticSeconds = 3e-8}}});
}

} // namespace idiophone::fuzz
