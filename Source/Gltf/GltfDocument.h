// SPDX-License-Identifier: Apache-2.0
// A glTF 2.0 file with its buffers and the nodes of its scene. tinygltf parses it.
#pragma once

#include "Object/Result.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
class Model;
}

namespace idiophone {

/// A node of the scene that the file shows.
struct GltfNode {
    int node = -1;   ///< its number in the file
    int parent = -1; ///< the index of its parent in `GltfDocument::nodes`, or -1
    bool isCamera = false;
    Eigen::Affine3d transform; ///< from its own space to the scene's
};

/// Returns the bytes of a buffer in a file of its own, at most `limitBytes`. `name` comes from the
/// untrusted document. The error is the end of a sentence about that buffer.
using GltfBufferReader =
    std::function<Result<std::string>(const std::string& name, std::uintmax_t limitBytes)>;

class GltfDocument {
public:
    /// Parses a .gltf or .glb file. Without `readBuffer`, a document with buffers in files of their
    /// own is refused. Images are not decoded. The error is the end of a sentence that begins with
    /// the file's name: no glTF 2.0, malformed, nested too deeply, a buffer missing, an extension
    /// required that changes what is read here and is unknown, a node that is its own ancestor.
    /// Any thread except the audio thread.
    static Result<GltfDocument> parse(std::string_view bytes,
                                      const GltfBufferReader& readBuffer = {});

    GltfDocument(GltfDocument&&) noexcept;
    GltfDocument& operator=(GltfDocument&&) noexcept;
    ~GltfDocument();

    const tinygltf::Model& model() const { return *model_; }
    /// Returns the JSON without its buffers. tinygltf drops empty objects of extensions.
    const nlohmann::json& json() const { return *json_; }

    /// Returns the nodes of the default scene, parents before children; those of all scenes if the
    /// file has no scene.
    const std::vector<GltfNode>& nodes() const { return nodes_; }

private:
    GltfDocument();

    std::unique_ptr<nlohmann::json> json_;
    std::unique_ptr<tinygltf::Model> model_;
    std::vector<GltfNode> nodes_;
};

} // namespace idiophone
