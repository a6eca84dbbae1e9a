// Makes glTF files for tests.
#pragma once

#include "Mesh/Mesh.h"

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone::test {

/// A glTF file while it is made: arrays go into its only buffer, all else into `json`.
struct GltfFile {
    nlohmann::json json = {{"asset", {{"version", "2.0"}}},
                           {"bufferViews", nlohmann::json::array()},
                           {"accessors", nlohmann::json::array()},
                           {"meshes", nlohmann::json::array()},
                           {"nodes", nlohmann::json::array()}};
    std::string buffer;

    /// Appends a buffer view and returns its number.
    template <class Number>
    int addView(const std::vector<Number>& numbers, std::size_t stride = 0) {
        buffer.resize((buffer.size() + 3) / 4 * 4);
        const auto bytes = numbers.size() * sizeof(Number);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes}});
        if (stride > 0)
            json["bufferViews"].back()["byteStride"] = stride;
        buffer.append(reinterpret_cast<const char*>(numbers.data()), bytes);
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    /// Appends an accessor of the newest view, and returns its number.
    int addAccessor(const char* type, int componentType, std::size_t count) {
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"type", type},
                                     {"componentType", componentType},
                                     {"count", count}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    int addPositions(const std::vector<float>& coordinates) {
        addView(coordinates);
        return addAccessor("VEC3", 5126, coordinates.size() / 3);
    }
    int addIndices(const std::vector<std::uint16_t>& indices) {
        addView(indices);
        return addAccessor("SCALAR", 5123, indices.size());
    }
    /// Appends a mesh of one primitive, and returns its number. Negative `indices`: none.
    int addMesh(int positions, int indices = -1, int mode = 4) {
        nlohmann::json primitive{{"attributes", {{"POSITION", positions}}}, {"mode", mode}};
        if (indices >= 0)
            primitive["indices"] = indices;
        json["meshes"].push_back({{"primitives", {primitive}}});
        return static_cast<int>(json["meshes"].size()) - 1;
    }

    /// Returns a .gltf file whose buffer has this name, or is in the text.
    std::string text(const std::string& bufferName = {}) const {
        auto whole = json;
        whole["buffers"] = {
            {{"byteLength", buffer.size()},
             {"uri", bufferName.empty() ? "data:application/octet-stream;base64," + inBase64(buffer)
                                        : bufferName}}};
        return whole.dump();
    }
    /// Returns a .glb file.
    std::string glb() const {
        auto whole = json;
        whole["buffers"] = {{{"byteLength", buffer.size()}}};
        auto text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        auto binary = buffer;
        binary.resize((binary.size() + 3) / 4 * 4);
        return "glTF" + count(2) + count(28 + text.size() + binary.size()) + count(text.size()) +
               "JSON" + text + count(binary.size()) + std::string("BIN\0", 4) + binary;
    }

    static std::string count(std::size_t number) {
        std::string bytes;
        for (int i = 0; i < 4; ++i)
            bytes += static_cast<char>(number >> 8 * i);
        return bytes;
    }

private:
    static std::string inBase64(std::string_view bytes) {
        constexpr std::string_view digits =
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k)
                bits = bits << 8 |
                       (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
            for (std::size_t k = 0; k < 4; ++k)
                text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
        }
        return text;
    }
};

/// Returns the vertices of a mesh, one after another, in single precision.
inline std::vector<float> coordinatesOf(const Mesh& mesh) {
    std::vector<float> coordinates;
    for (const auto& vertex : mesh.vertices.rowwise())
        for (const double coordinate : vertex)
            coordinates.push_back(static_cast<float>(coordinate));
    return coordinates;
}

inline std::vector<std::uint16_t> cornersOf(const Mesh& mesh) {
    std::vector<std::uint16_t> corners;
    for (const auto& face : mesh.faces.rowwise())
        for (const int corner : face)
            corners.push_back(static_cast<std::uint16_t>(corner));
    return corners;
}

/// Returns a .glb file of one node that shows the mesh, which has at most 65536 vertices.
inline std::string glbOf(const Mesh& mesh) {
    GltfFile file;
    // glTF's y points up.
    Mesh upright = mesh;
    upright.vertices.col(1) = mesh.vertices.col(2);
    upright.vertices.col(2) = -mesh.vertices.col(1);
    const int positions = file.addPositions(coordinatesOf(upright));
    file.addMesh(positions, file.addIndices(cornersOf(mesh)));
    file.json["nodes"] = {{{"mesh", 0}}};
    return file.glb();
}

} // namespace idiophone::test
