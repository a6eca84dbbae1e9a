// SPDX-License-Identifier: Apache-2.0
#include "Gltf/ObjectGlb.h"

#include "Gltf/GltfObject.h"
#include "Gltf/PrincipalInertia.h"
#include "Mesh/ShapeMesh.h"
#include "Object/ModalObjectBytes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <string>

namespace idiophone {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

enum ComponentType { unsignedInt = 5125, singlePrecision = 5126 };

/// The buffer of a file, and the JSON that describes what is in it.
class BufferWriter {
public:
    /// Returns the number of the buffer view.
    std::size_t addView(std::span<const std::byte> data) {
        views_.push_back(
            {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", data.size()}});
        bytes_.insert(bytes_.end(), data.begin(), data.end());
        bytes_.resize((bytes_.size() + 3) / 4 * 4);
        return views_.size() - 1;
    }

    /// Returns the number of the accessor.
    std::size_t add(ComponentType type,
                    const char* elements,
                    std::size_t components,
                    std::span<const std::byte> data,
                    json more = json::object()) {
        json accessor{{"bufferView", addView(data)},
                      {"componentType", static_cast<int>(type)},
                      {"count", data.size() / 4 / components},
                      {"type", elements}};
        accessor.update(more);
        accessors_.push_back(std::move(accessor));
        return accessors_.size() - 1;
    }

    std::size_t addNumbers(const std::vector<float>& values) {
        return add(singlePrecision, "SCALAR", 1, std::as_bytes(std::span(values)));
    }
    std::size_t addIndices(const std::vector<std::uint32_t>& values) {
        return add(unsignedInt, "SCALAR", 1, std::as_bytes(std::span(values)));
    }
    std::size_t addVectors(const std::vector<float>& values) {
        return add(singlePrecision, "VEC3", 3, std::as_bytes(std::span(values)));
    }

    /// Adds vectors with their bounds, which glTF wants of the positions of a mesh.
    std::size_t addPositions(const std::vector<float>& values) {
        json minimum = json::array(), maximum = json::array();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float low = values[axis], high = low;
            for (std::size_t k = axis; k < values.size(); k += 3) {
                low = std::min(low, values[k]);
                high = std::max(high, values[k]);
            }
            minimum.push_back(low);
            maximum.push_back(high);
        }
        return add(singlePrecision, "VEC3", 3, std::as_bytes(std::span(values)),
                   {{"min", minimum}, {"max", maximum}});
    }

    const json& views() const { return views_; }
    const json& accessors() const { return accessors_; }
    const std::vector<std::byte>& bytes() const { return bytes_; }

private:
    json views_ = json::array(), accessors_ = json::array();
    std::vector<std::byte> bytes_;
};

/// Returns the modes that ring, by falling energy of the sound after a strike, averaged over the
/// surface.
std::vector<std::size_t> loudestFirst(const ModalObject& object) {
    const auto squares = summedSquareShapes(object);
    std::vector<double> energies;
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        energies.push_back(squares[mode] * object.eigenvalues[mode] /
                           std::max(object.decayPerSecond(mode), 1e-9));
    std::vector<std::size_t> order(object.modeCount());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t mode) { return !(object.dampedFrequencyHz(mode) > 0); });
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return energies[i]; });
    return order;
}

template <class Number>
std::vector<std::uint32_t> unsignedOf(const std::vector<Number>& numbers) {
    return {numbers.begin(), numbers.end()};
}

/// Returns mode-major shapes. A bar's mode that a tube shares moves less (`ModalObject::gains`).
std::vector<float> shapesInOrder(const ModalObject& object, const std::vector<std::size_t>& order) {
    std::vector<float> shapes;
    shapes.reserve(object.shapes.size());
    for (const auto mode : order) {
        const float gain = object.gains.empty() ? 1 : std::abs(object.gains[mode]);
        for (std::size_t row = 0; row < object.shapeVertexCount(); ++row)
            for (const float part : object.shapesAt(row).subspan(3 * mode, 3))
                shapes.push_back(gain * part);
    }
    return shapes;
}

/// Returns the object for the file inside the file. Its shapes are in the model already, unless the
/// model lacks modes or has other shapes.
ModalObject objectInside(ModalObject object, std::size_t modelModes) {
    if (!object.gains.empty() || modelModes < object.modeCount())
        return object;
    object.shapes.resize(3 * object.modeCount());
    object.shapeVertices.resize(1);
    return object;
}

json materialJson(const ModalObject& object) {
    const auto& material = object.material;
    json written{{"name", material.name},
                 {"density", material.densityKgPerM3},
                 {"youngsModulus", material.youngsModulusPa},
                 {"poissonRatio", material.poissonRatio}};
    const bool isRayleigh = material.damping.lossFactor == 0 && object.dampings().empty();
    if (isRayleigh) {
        written["alpha"] = material.damping.fluidPerSecond;
        written["beta"] = material.damping.viscoelasticSeconds;
    }
    return written;
}

json surfaceJson(const Material& material) {
    const auto surface = surfaceOf(material.roughness);
    // Waviness is longer and gentler than any finish here, as the draft demands.
    return {{"name", material.name},
            {"roughness", surface.roughnessMetres},
            {"correlationLength", surface.correlationLengthMetres},
            {"spectralSlope", surface.spectralSlope},
            {"waviness", surface.roughnessMetres},
            {"wavinessLength", 20 * surface.correlationLengthMetres},
            {"material", 0}};
}

json massJson(const MassProperties& mass) {
    const auto inertia = principalInertia(mass.inertiaKgM2);
    return {{"mass", mass.massKg},
            {"centerOfMass", mass.centreMetres},
            {"inertiaDiagonal", inertia.diagonalKgM2},
            {"inertiaOrientation", inertia.orientation}};
}

json modelJson(BufferWriter& buffer, const ModalObject& object) {
    const auto order = loudestFirst(object);
    std::vector<float> frequencies, decays, positions;
    for (const auto mode : order) {
        frequencies.push_back(static_cast<float>(object.dampedFrequencyHz(mode)));
        decays.push_back(static_cast<float>(object.decayPerSecond(mode)));
    }
    for (const auto vertex : object.shapeVertices)
        for (std::size_t axis = 0; axis < 3; ++axis)
            positions.push_back(object.vertices[3 * static_cast<std::size_t>(vertex) + axis]);
    std::vector<std::uint32_t> corners;
    const auto surface = shapeMesh(object);
    for (const auto face : surface.faces.rowwise())
        corners.insert(corners.end(), face.begin(), face.end());
    json model{{"name", object.name},
               {"frequencies", buffer.addNumbers(frequencies)},
               {"decayRates", buffer.addNumbers(decays)},
               {"positions", buffer.addPositions(positions)},
               {"shapes", buffer.addVectors(shapesInOrder(object, order))},
               {"indices", buffer.addIndices(corners)},
               {"material", 0}};
    if (object.mass.massKg > 0)
        model["massProperties"] = massJson(object.mass);
    model["extensions"] = {
        {"IDIOPHONE_modal_object",
         {{"object", buffer.addView(encodeModalObject(objectInside(object, order.size())))},
          {"modes", buffer.addIndices(unsignedOf(order))},
          {"vertices", buffer.addIndices(unsignedOf(object.shapeVertices))}}}};
    return model;
}

json meshJson(BufferWriter& buffer, const ModalObject& object) {
    const json attributes{{"POSITION", buffer.addPositions(object.vertices)},
                          {"NORMAL", buffer.addVectors(vertexNormals(object))}};
    return {{"name", object.name},
            {"primitives",
             {{{"attributes", attributes},
               {"indices", buffer.addIndices(unsignedOf(object.faces))},
               {"material", 0}}}}};
}

json documentJson(BufferWriter& buffer, const ModalObject& object) {
    json node{
        {"name", object.name},
        // Our z points up, glTF's y does.
        {"rotation", {-std::numbers::sqrt2 / 2, 0, 0, std::numbers::sqrt2 / 2}},
        {"extensions", {{"KHR_audio_rigid_bodies", {{"modalModel", 0}, {"acousticSurface", 0}}}}}};
    json document{{"asset", {{"version", "2.0"}, {"generator", object.provenance.software}}},
                  {"extensionsUsed", {"KHR_audio_rigid_bodies", "IDIOPHONE_modal_object"}},
                  {"scene", 0},
                  {"scenes", {{{"nodes", {0}}}}}};
    if (object.faceCount() > 0) {
        node["mesh"] = 0;
        // Without json::array, some compilers copy the one element instead.
        document["meshes"] = json::array({meshJson(buffer, object)});
        // Shells have two sides.
        document["materials"] = {
            {{"name", object.material.name}, {"doubleSided", object.body == BodyKind::shell}}};
    }
    document["nodes"] = json::array({node});
    document["extensions"] = {{"KHR_audio_rigid_bodies",
                               {{"acousticMaterials", {materialJson(object)}},
                                {"acousticSurfaces", {surfaceJson(object.material)}},
                                {"modalModels", {modelJson(buffer, object)}}}}};
    document["bufferViews"] = buffer.views();
    document["accessors"] = buffer.accessors();
    document["buffers"] = {{{"byteLength", buffer.bytes().size()}}};
    return document;
}

void append(std::vector<std::byte>& file, std::span<const std::byte> bytes) {
    file.insert(file.end(), bytes.begin(), bytes.end());
}

/// Appends a chunk of a .glb file, of a length that is a multiple of four.
void appendChunk(std::vector<std::byte>& file,
                 const char (&type)[5],
                 std::span<const std::byte> bytes) {
    const auto length = static_cast<std::uint32_t>(bytes.size());
    append(file, std::as_bytes(std::span(&length, 1)));
    append(file, std::as_bytes(std::span(type, 4)));
    append(file, bytes);
}

} // namespace

std::vector<std::byte> encodeGlb(const ModalObject& object) {
    BufferWriter buffer;
    auto text = documentJson(buffer, object).dump(-1, ' ', false, json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::byte> file;
    const std::uint32_t header[3]{
        0x46546C67, 2, // "glTF", version
        static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + buffer.bytes().size())};
    append(file, std::as_bytes(std::span(header)));
    appendChunk(file, "JSON", std::as_bytes(std::span(text)));
    appendChunk(file, "BIN\0", buffer.bytes());
    return file;
}

} // namespace idiophone
