// SPDX-License-Identifier: Apache-2.0
#include "Gltf/GltfDocument.h"

#include "Gltf/TinyGltf.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Object/SameName.h"
#include "Object/UntrustedJson.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

namespace idiophone {
namespace {

constexpr std::uintmax_t largestBufferBytes = std::uintmax_t{2} << 30;

/// Returns the JSON of a .gltf file or of the first chunk of a .glb file.
std::string_view jsonOf(std::string_view bytes) {
    constexpr std::size_t headerBytes = 20; // magic, version, length; length and type of the chunk
    if (!bytes.starts_with("glTF") || bytes.size() < headerBytes)
        return bytes;
    std::uint32_t chunkBytes = 0;
    std::memcpy(&chunkBytes, bytes.data() + 12, sizeof(chunkBytes));
    return bytes.substr(headerBytes, chunkBytes);
}

/// Returns whether the file can be used here although it requires this extension.
bool isHarmless(std::string_view extension) {
    constexpr std::array<std::string_view, 4> known{"KHR_mesh_quantization", "KHR_implicit_shapes",
                                                    "KHR_physics_rigid_bodies",
                                                    "KHR_audio_rigid_bodies"};
    constexpr std::array<std::string_view, 5> looks{"KHR_materials_", "KHR_texture_",
                                                    "EXT_texture_", "KHR_lights_", "EXT_lights_"};
    return std::ranges::find(known, extension) != known.end() ||
           std::ranges::any_of(looks, [&](auto prefix) { return extension.starts_with(prefix); });
}

/// Returns why the file must not be read, or nothing: tinygltf descends into JSON without a limit,
/// and it does not look at what a file requires.
std::optional<std::string> faultBeforehand(std::string_view text) {
    const auto parsed = parseUntrusted(text);
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

/// Reads buffers in files of their own, beside or below the document, for tinygltf.
struct BufferFiles {
    std::filesystem::path folder;
    std::string fault = {}; ///< of the last file that could not be read

    bool read(std::vector<unsigned char>& buffer, const std::string& name) {
        const auto path = pathNamed(name);
        if (path.empty() || path.is_absolute() || path.has_root_name() || isNetworkName(name) ||
            std::ranges::find(path, std::filesystem::path("..")) != path.end()) {
            fault = "its buffer " + inQuotes(name) + " is not in the folder of the file";
            return false;
        }
        const auto bytes = readBytes(folder / path, largestBufferBytes);
        if (!bytes) {
            fault = "its buffer " + inQuotes(name) + " cannot be read: " + bytes.error().message;
            return false;
        }
        buffer.assign(bytes->begin(), bytes->end());
        return true;
    }

    tinygltf::FsCallbacks callbacks() {
        return {.FileExists = [](const std::string&, void*) { return true; },
                .ExpandFilePath = [](const std::string& name, void*) { return name; },
                .ReadWholeFile =
                    [](std::vector<unsigned char>* buffer, std::string*, const std::string& name,
                       void* self) { return static_cast<BufferFiles*>(self)->read(*buffer, name); },
                .WriteWholeFile = nullptr,
                .user_data = this};
    }
};

bool keepNoImage(
    tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

/// Returns the fault, or nothing.
std::optional<std::string> parseWithTinyGltf(tinygltf::Model& model,
                                             std::string_view bytes,
                                             const std::filesystem::path& folder) {
    if (bytes.size() > std::numeric_limits<int>::max())
        return "it is too large";
    BufferFiles files{.folder = folder};
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks(files.callbacks());
    parser.SetImageLoader(keepNoImage, nullptr);
    std::string error, warnings;
    const auto size = static_cast<unsigned int>(bytes.size());
    try {
        const bool isParsed =
            bytes.starts_with("glTF")
                ? parser.LoadBinaryFromMemory(&model, &error, &warnings,
                                              reinterpret_cast<const unsigned char*>(bytes.data()),
                                              size)
                : parser.LoadASCIIFromString(&model, &error, &warnings, bytes.data(), size, {});
        if (isParsed)
            return {};
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception&) {
        error = "a part of it is malformed"; // an empty buffer, for example
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

GltfDocument::GltfDocument() : model_(std::make_unique<tinygltf::Model>()) {}
GltfDocument::GltfDocument(GltfDocument&&) noexcept = default;
GltfDocument& GltfDocument::operator=(GltfDocument&&) noexcept = default;
GltfDocument::~GltfDocument() = default;

Result<GltfDocument> GltfDocument::parse(std::string_view bytes,
                                         const std::filesystem::path& folder) {
    if (const auto fault = faultBeforehand(jsonOf(bytes)))
        return failure(*fault);
    GltfDocument document;
    if (const auto fault = parseWithTinyGltf(*document.model_, bytes, folder))
        return failure(*fault);
    auto nodes = placedNodes(*document.model_);
    if (!nodes)
        return failure(nodes.error().message);
    document.nodes_ = *std::move(nodes);
    return document;
}

bool isGltfFile(const std::filesystem::path& file) {
    const auto extension = nameOf(file.extension());
    return sameName(extension, ".gltf") || sameName(extension, ".glb");
}

} // namespace idiophone
