// SPDX-License-Identifier: Apache-2.0
#include "Gltf/GltfDocument.h"

#include "Gltf/GltfChunks.h"
#include "Gltf/TinyGltf.h"
#include "Object/OneLine.h"
#include "Object/UntrustedJson.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace idiophone {
namespace {

/// The limit of all buffers together, except those inside the JSON.
constexpr std::uintmax_t largestBufferBytes = std::uintmax_t{2} << 30;
/// The name under which tinygltf asks for the binary chunk.
constexpr std::string_view binaryChunkName = "the binary chunk";

/// Returns whether the file can be used here although it requires this extension.
bool isHarmless(std::string_view extension) {
    constexpr std::array<std::string_view, 5> known{
        "EXT_mesh_gpu_instancing", "KHR_mesh_quantization", "KHR_implicit_shapes",
        "KHR_physics_rigid_bodies", "KHR_audio_rigid_bodies"};
    constexpr std::array<std::string_view, 5> looks{"KHR_materials_", "KHR_texture_",
                                                    "EXT_texture_", "KHR_lights_", "EXT_lights_"};
    return std::ranges::find(known, extension) != known.end() ||
           std::ranges::any_of(looks, [&](auto prefix) { return extension.starts_with(prefix); });
}

/// Returns why the file must not be read, or nothing: tinygltf does not look at what a file
/// requires.
std::optional<std::string> faultOf(const nlohmann::json& parsed, std::string_view text) {
    if (!parsed.is_object())
        return "it is not the JSON of a glTF file" + placeOfJsonFault(text);
    const auto asset = parsed.find("asset");
    if (asset == parsed.end() || !asset->is_object())
        return "it is not a glTF file, because it has no \"asset\"";
    const auto version = asset->value("version", nlohmann::json{});
    if (!version.is_string() || !version.get_ref<const std::string&>().starts_with("2."))
        return "its version of glTF is not 2";
    const auto required = parsed.find("extensionsRequired");
    if (required != parsed.end() && required->is_array())
        for (const auto& name : *required)
            if (name.is_string() && !isHarmless(name.get_ref<const std::string&>()))
                return "it requires the extension " + inQuotes(name.get_ref<const std::string&>()) +
                       ", which Idiophone does not read";
    return {};
}

/// Leaves out what nobody reads here, so that tinygltf neither opens files of pictures nor trusts
/// their numbers.
void leaveOutUnused(nlohmann::json& parsed) {
    for (const auto* unused : {"animations", "cameras", "images", "samplers", "skins", "textures"})
        parsed.erase(unused);
}

/// Names the binary chunk as the first buffer. Returns the part that this takes: the chunk may end
/// with padding.
std::string_view nameBinaryChunk(std::string_view binary, nlohmann::json& parsed) {
    const auto buffers = parsed.find("buffers");
    if (binary.empty() || buffers == parsed.end() || !buffers->is_array() || buffers->empty())
        return {};
    auto& first = buffers->front();
    if (!first.is_object() || first.contains("uri"))
        return {};
    first["uri"] = binaryChunkName;
    const auto length = first.value("byteLength", nlohmann::json{});
    return length.is_number_unsigned() ? binary.substr(0, length.get<std::size_t>()) : binary;
}

/// Reads buffers in files of their own and the binary chunk, for tinygltf.
struct BufferFiles {
    const GltfBufferReader& readBuffer;
    std::string_view binaryChunk;
    std::uintmax_t bytesLeft = largestBufferBytes;
    std::string fault = {}; ///< of the last file that could not be read

    Result<std::string> bytesOf(const std::string& name) const {
        if (name == binaryChunkName && binaryChunk.size() <= bytesLeft)
            return std::string(binaryChunk);
        if (!readBuffer)
            return failure("it is in another file, and only the bytes of this one are given");
        return readBuffer(name, bytesLeft);
    }

    bool read(std::vector<unsigned char>& buffer, const std::string& name) {
        const auto bytes = bytesOf(name);
        if (!bytes) {
            fault = "its buffer " + inQuotes(name) + " cannot be read: " + bytes.error().message;
            return false;
        }
        bytesLeft -= bytes->size();
        buffer.assign(bytes->begin(), bytes->end());
        return true;
    }

    /// A template, because tinygltf 2.9 has one more field, and ignores an incomplete set.
    template <typename Callbacks = tinygltf::FsCallbacks>
    Callbacks callbacks() {
        Callbacks result{};
        result.FileExists = [](const std::string&, void*) { return true; };
        result.ExpandFilePath = [](const std::string& name, void*) { return name; };
        result.ReadWholeFile = [](std::vector<unsigned char>* buffer, std::string*,
                                  const std::string& name, void* self) {
            return static_cast<BufferFiles*>(self)->read(*buffer, name);
        };
        result.WriteWholeFile = [](std::string*, const std::string&,
                                   const std::vector<unsigned char>&, void*) { return false; };
        if constexpr (requires { result.GetFileSizeInBytes; })
            result.GetFileSizeInBytes = [](std::size_t* bytes, std::string*, const std::string&,
                                           void*) {
                *bytes = 0; // bytesOf looks at the real size
                return true;
            };
        result.user_data = this;
        return result;
    }
};

/// Returns the fault, or nothing. tinygltf gets the JSON alone: its reader of .glb files reads
/// beyond a chunk that is too long.
std::optional<std::string>
parseWithTinyGltf(tinygltf::Model& model, const std::string& json, BufferFiles files) {
    if (json.size() > std::numeric_limits<int>::max())
        return "it is too large";
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(files.callbacks());
    std::string error, warnings;
    try {
        if (parser.LoadASCIIFromString(&model, &error, &warnings, json.data(),
                                       static_cast<unsigned int>(json.size()), {}))
            return {};
    } catch (const std::bad_alloc&) {
        return "it is too large for this machine's memory";
    } catch (const std::exception&) {
        error = "a part of it is malformed";
    }
    if (!files.fault.empty())
        return files.fault;
    return "it is malformed: " + oneLine(error.substr(0, error.find('\n')));
}

/// Returns the transform from the node's space to its parent's.
Result<Eigen::Affine3d> localTransform(const tinygltf::Node& node) {
    Eigen::Affine3d transform = Eigen::Affine3d::Identity();
    if (node.matrix.size() == 16) {
        transform.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    } else {
        if (node.translation.size() == 3)
            transform.translate(Eigen::Map<const Eigen::Vector3d>(node.translation.data()));
        if (node.rotation.size() == 4)
            transform.rotate(
                Eigen::Quaterniond(Eigen::Map<const Eigen::Vector4d>(node.rotation.data()))
                    .normalized());
        if (node.scale.size() == 3)
            transform.scale(Eigen::Map<const Eigen::Vector3d>(node.scale.data()));
    }
    if (!transform.matrix().allFinite())
        return failure("a node's transform is not finite");
    return transform;
}

/// Returns the nodes at which the scene begins.
std::vector<int> rootsOf(const tinygltf::Model& model) {
    if (!model.scenes.empty()) {
        const auto scene = static_cast<std::size_t>(std::max(model.defaultScene, 0));
        return model.scenes[std::min(scene, model.scenes.size() - 1)].nodes;
    }
    std::vector<bool> isChild(model.nodes.size());
    for (const auto& node : model.nodes)
        for (const int child : node.children)
            if (child >= 0 && static_cast<std::size_t>(child) < isChild.size())
                isChild[static_cast<std::size_t>(child)] = true;
    std::vector<int> roots;
    for (std::size_t node = 0; node < isChild.size(); ++node)
        if (!isChild[node])
            roots.push_back(static_cast<int>(node));
    return roots;
}

Result<std::vector<GltfNode>> placedNodes(const tinygltf::Model& model) {
    std::vector<GltfNode> placed;
    for (const int root : rootsOf(model))
        placed.push_back({.node = root, .transform = Eigen::Affine3d::Identity()});
    std::vector<bool> isPlaced(model.nodes.size());
    for (std::size_t index = 0; index < placed.size(); ++index) {
        const int number = placed[index].node;
        if (number < 0 || static_cast<std::size_t>(number) >= model.nodes.size())
            return failure("node " + std::to_string(number) + " does not exist");
        if (isPlaced[static_cast<std::size_t>(number)])
            return failure("node " + std::to_string(number) +
                           " is placed twice, or is its own ancestor");
        isPlaced[static_cast<std::size_t>(number)] = true;
        const auto& node = model.nodes[static_cast<std::size_t>(number)];
        placed[index].isCamera = node.camera >= 0;
        const auto local = localTransform(node);
        if (!local)
            return failure(local.error().message);
        const int parent = placed[index].parent;
        placed[index].transform =
            parent < 0 ? *local : placed[static_cast<std::size_t>(parent)].transform * *local;
        for (const int child : node.children)
            placed.push_back({.node = child, .parent = static_cast<int>(index), .transform = {}});
    }
    return placed;
}

} // namespace

GltfDocument::GltfDocument()
    : json_(std::make_unique<nlohmann::json>()), model_(std::make_unique<tinygltf::Model>()) {}
GltfDocument::GltfDocument(GltfDocument&&) noexcept = default;
GltfDocument& GltfDocument::operator=(GltfDocument&&) noexcept = default;
GltfDocument::~GltfDocument() = default;

Result<GltfDocument> GltfDocument::parse(std::string_view bytes,
                                         const GltfBufferReader& readBuffer) {
    const auto chunks = gltfChunksOf(bytes);
    if (!chunks)
        return failure("it is truncated");
    // Parsed with a limit of depth, because tinygltf descends without one.
    auto parsed = parseUntrusted(chunks->json);
    if (const auto fault = faultOf(parsed, chunks->json))
        return failure(*fault);
    leaveOutUnused(parsed);
    const auto binary = nameBinaryChunk(chunks->binary, parsed);
    GltfDocument document;
    const auto text = parsed.dump();
    parsed.erase("buffers"); // may hold all bytes as text
    *document.json_ = std::move(parsed);
    if (const auto fault = parseWithTinyGltf(*document.model_, text,
                                             {.readBuffer = readBuffer, .binaryChunk = binary}))
        return failure(*fault);
    auto nodes = placedNodes(*document.model_);
    if (!nodes)
        return failure(nodes.error().message);
    document.nodes_ = *std::move(nodes);
    return document;
}

} // namespace idiophone
