// Modal objects, as a user drops them on the window or a project carries them.
#include "Fuzz/FuzzTarget.h"
#include "Object/ModalObjectFile.h"

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
    claimFinite(object.radiation.weights, "radiation is finite");
    claimFinite(object.radiation.frequencyRatios, "radiation's frequencies are finite");
    claimFinite(vertexNormals(object), "normals are finite");
    claimFinite(summedSquareShapes(object), "squared shapes are finite");
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode) {
        const double damping[] = {object.eigenvalueAt(mode, 1), object.decayPerSecond(mode),
                                  object.dampingScale(mode)};
        claimFinite(damping, "damping is finite");
    }
    claim(nearestShapeRow(object, {0, 0, 0}) < object.shapeVertexCount(), "a row is nearest");
}

} // namespace

void examine(std::string_view bytes) {
    const auto object = readModalObject(asBytes(bytes), "fuzz.modal");
    if (!object)
        return claimSentence(object.error());
    claimSizes(*object);
    claimValues(*object);
    const auto written = encodeModalObject(*object);
    const auto again = readModalObject(written, "again.modal");
    claim(again.has_value(), "what was written can be read");
    claim(encodeModalObject(*again) == written, "what was read is written as it was");
}

} // namespace idiophone::fuzz
