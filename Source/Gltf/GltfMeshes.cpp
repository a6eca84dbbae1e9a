// SPDX-License-Identifier: Apache-2.0
#include "Gltf/GltfMeshes.h"

#include "Gltf/GltfAccessor.h"
#include "Gltf/TinyGltf.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace idiophone {
namespace {

using RowMajorFaces = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Vertices and corners that a file may have beyond what its buffers justify: it may place a mesh
/// many times.
constexpr std::size_t repeatedElements = std::size_t{1} << 23;

std::size_t elementsOf(const Mesh& mesh) {
    return static_cast<std::size_t>(mesh.vertices.rows() + mesh.faces.size());
}

bool hasTriangles(int mode) {
    return mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

/// Appends the triangles to `corners`, three vertices each. Strips turn round where they repeat a
/// vertex; these triangles without an area are left out.
void appendTriangles(std::vector<int>& corners, int mode, const std::vector<int>& vertices) {
    const auto append = [&](std::size_t a, std::size_t b, std::size_t c) {
        const std::array triangle{vertices[a], vertices[b], vertices[c]};
        if (mode != TINYGLTF_MODE_TRIANGLE_STRIP ||
            (triangle[0] != triangle[1] && triangle[1] != triangle[2] &&
             triangle[2] != triangle[0]))
            corners.insert(corners.end(), triangle.begin(), triangle.end());
    };
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for (std::size_t first = 0; first + 2 < vertices.size(); first += step) {
        const std::size_t odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP ? first % 2 : 0;
        if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
            append(first + 1, first + 2, 0);
        else
            append(first, first + 1 + odd, first + 2 - odd);
    }
}

/// Returns the mesh at all the places, as one.
Mesh placed(const Mesh& mesh, const std::vector<Eigen::Affine3d>& places) {
    const auto vertices = mesh.vertexCount(), faces = mesh.faceCount();
    const auto count = static_cast<Eigen::Index>(places.size());
    Mesh all{Eigen::MatrixXd(count * vertices, 3), Eigen::MatrixXi(count * faces, 3)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const auto& place = places[static_cast<std::size_t>(i)];
        all.vertices.middleRows(i * vertices, vertices) =
            (mesh.vertices * place.linear().transpose()).rowwise() +
            place.translation().transpose();
        auto ofPlace = all.faces.middleRows(i * faces, faces);
        ofPlace = mesh.faces.array() + static_cast<int>(i * vertices);
        if (place.linear().determinant() < 0)
            ofPlace.col(1).swap(ofPlace.col(2));
    }
    return all;
}

/// Reads the meshes of nodes. Memory and time are bounded by the size of the buffers.
class MeshCollector {
public:
    explicit MeshCollector(const GltfDocument& gltfDocument)
        : document(gltfDocument), model(gltfDocument.model()) {
        for (const auto& buffer : model.buffers)
            elementsLeft += 2 * buffer.data.size(); // read, then placed
        elementsLeft = std::min<std::size_t>(elementsLeft, std::numeric_limits<int>::max());
    }

    Result<void> add(const GltfNode& shown) {
        const auto& node = model.nodes[static_cast<std::size_t>(shown.node)];
        if (node.mesh < 0)
            return {};
        const auto mesh = meshOf(node.mesh);
        if (!mesh)
            return failure(mesh.error().message);
        auto places = placesOf(node);
        if (!places)
            return failure(places.error().message);
        if ((*mesh)->faceCount() == 0 || places->empty())
            return {};
        if (auto done = spend(places->size() * elementsOf(**mesh)); !done)
            return done;
        for (auto& place : *places)
            place = shown.transform * place;
        isPosed = isPosed || node.skin >= 0;
        const auto& nameOfMesh = model.meshes[static_cast<std::size_t>(node.mesh)].name;
        meshes.parts.push_back({.node = shown.node,
                                .name = node.name.empty() ? nameOfMesh : node.name,
                                .mesh = placed(**mesh, *places)});
        return {};
    }

    GltfMeshes finished() && {
        if (leftOut > 0)
            meshes.notes =
                leftOut == 1 ? "Left out one part without triangles."
                             : "Left out " + std::to_string(leftOut) + " parts without triangles.";
        if (isPosed)
            meshes.notes += (meshes.notes.empty() ? "" : " ") +
                            std::string("Skeletons and morph targets are left out: the mesh keeps "
                                        "the pose that it has without them.");
        return std::move(meshes);
    }

private:
    Result<void> spend(std::size_t elements) {
        if (elements > elementsLeft)
            return failure("it repeats its meshes too often");
        elementsLeft -= elements;
        return {};
    }

    Result<Eigen::MatrixXd> numbers(int accessor, int columns) {
        if (accessor >= 0 && static_cast<std::size_t>(accessor) < model.accessors.size())
            if (const auto done = spend(model.accessors[static_cast<std::size_t>(accessor)].count);
                !done)
                return failure(done.error().message);
        return numbersOf(document, accessor, columns);
    }

    /// Returns the vertices that the primitive names, in order.
    Result<std::vector<int>>
    verticesOf(const tinygltf::Primitive& primitive, int first, int count) {
        std::vector<int> vertices;
        if (primitive.indices < 0) {
            for (int vertex = 0; vertex < count; ++vertex)
                vertices.push_back(first + vertex);
            return vertices;
        }
        const auto indices = numbers(primitive.indices, 1);
        if (!indices)
            return failure(indices.error().message);
        vertices.reserve(static_cast<std::size_t>(indices->rows()));
        for (const double index : indices->col(0)) {
            if (!(index >= 0 && index < count))
                return failure("a face names a vertex that does not exist (there are " +
                               std::to_string(count) + " vertices)");
            vertices.push_back(first + static_cast<int>(index));
        }
        return vertices;
    }

    /// Returns the mesh in its own space. The pointer stays valid.
    Result<const Mesh*> meshOf(int number) {
        if (const auto known = meshOfNumber.find(number); known != meshOfNumber.end())
            return &known->second;
        if (static_cast<std::size_t>(number) >= model.meshes.size())
            return failure("mesh " + std::to_string(number) + " does not exist");
        struct Vertices {
            int first = 0;
            int count = 0;
        };
        std::map<int, Vertices> verticesOfAccessor; // primitives may share them
        std::vector<Eigen::MatrixXd> positions;
        std::vector<int> corners;
        int vertexCount = 0;
        for (const auto& primitive : model.meshes[static_cast<std::size_t>(number)].primitives) {
            const auto position = primitive.attributes.find("POSITION");
            if (!hasTriangles(primitive.mode) || position == primitive.attributes.end()) {
                ++leftOut;
                continue;
            }
            isPosed = isPosed || !primitive.targets.empty();
            const auto [entry, isNew] = verticesOfAccessor.try_emplace(position->second);
            if (isNew) {
                auto rows = numbers(position->second, 3);
                if (!rows)
                    return failure(rows.error().message);
                entry->second = {.first = vertexCount, .count = static_cast<int>(rows->rows())};
                vertexCount += entry->second.count;
                positions.push_back(std::move(*rows));
            }
            const auto vertices = verticesOf(primitive, entry->second.first, entry->second.count);
            if (!vertices)
                return failure(vertices.error().message);
            if (auto done = spend(vertices->size()); !done)
                return failure(done.error().message);
            appendTriangles(corners, primitive.mode, *vertices);
        }
        Mesh mesh{Eigen::MatrixXd(vertexCount, 3),
                  Eigen::Map<const RowMajorFaces>(
                      corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3)};
        Eigen::Index row = 0;
        for (const auto& part : positions) {
            mesh.vertices.middleRows(row, part.rows()) = part;
            row += part.rows();
        }
        return &meshOfNumber.emplace(number, std::move(mesh)).first->second;
    }

    /// Returns an attribute of a node's instances, a row each; no rows if they do not have it.
    Result<Eigen::MatrixXd>
    attributeOf(const tinygltf::Value& attributes, const char* name, int columns) {
        const auto& accessor = attributes.Get(name);
        if (!accessor.IsInt())
            return Eigen::MatrixXd(0, columns);
        return numbers(accessor.GetNumberAsInt(), columns);
    }

    /// Returns where the node shows its mesh, in its own space.
    Result<std::vector<Eigen::Affine3d>> placesOf(const tinygltf::Node& node) {
        std::vector<Eigen::Affine3d> places{Eigen::Affine3d::Identity()};
        const auto extension = node.extensions.find("EXT_mesh_gpu_instancing");
        if (extension == node.extensions.end() || !extension->second.IsObject() ||
            !extension->second.Get("attributes").IsObject())
            return places;
        const auto& attributes = extension->second.Get("attributes");
        const std::array<Result<Eigen::MatrixXd>, 3> moves{
            attributeOf(attributes, "TRANSLATION", 3), attributeOf(attributes, "ROTATION", 4),
            attributeOf(attributes, "SCALE", 3)};
        Eigen::Index count = 0;
        for (const auto& move : moves) {
            if (!move)
                return failure(move.error().message);
            if (move->rows() > 0 && count > 0 && move->rows() != count)
                return failure("a node's instances have attributes of different lengths");
            count = std::max(count, move->rows());
        }
        if (count > 0)
            places.resize(static_cast<std::size_t>(count), Eigen::Affine3d::Identity());
        for (Eigen::Index i = 0; i < count; ++i) {
            auto& place = places[static_cast<std::size_t>(i)];
            if (moves[0]->rows() > 0)
                place.translate(Eigen::Vector3d(moves[0]->row(i)));
            if (moves[1]->rows() > 0)
                place.rotate(Eigen::Quaterniond(Eigen::Vector4d(moves[1]->row(i))).normalized());
            if (moves[2]->rows() > 0)
                place.scale(Eigen::Vector3d(moves[2]->row(i)));
        }
        return places;
    }

    const GltfDocument& document;
    const tinygltf::Model& model;
    std::size_t elementsLeft = repeatedElements;
    std::map<int, Mesh> meshOfNumber;
    GltfMeshes meshes;
    int leftOut = 0;
    bool isPosed = false;
};

} // namespace

Result<GltfMeshes> meshesOf(const GltfDocument& document) {
    MeshCollector collector(document);
    for (const auto& node : document.nodes())
        if (const auto done = collector.add(node); !done)
            return failure(done.error().message);
    return std::move(collector).finished();
}

} // namespace idiophone
