// SPDX-License-Identifier: Apache-2.0
// The triangles that a glTF file shows.
#pragma once

#include "Gltf/GltfDocument.h"
#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <string>
#include <vector>

namespace idiophone {

/// The triangles of one node.
struct GltfPart {
    int node = -1;    ///< its number in the file
    std::string name; ///< of the node, else of its mesh; any text, may be empty
    Mesh mesh;        ///< in the scene's space. Vertices may coincide, be unused or not finite
};

struct GltfMeshes {
    std::vector<GltfPart> parts; ///< each with faces, in the order of the document's nodes
    std::string notes;           ///< sentences for the user: what is left out; may be empty
};

/// Returns the meshes of the document's nodes, with the places of their instances
/// (EXT_mesh_gpu_instancing). Meshes keep the pose without skeletons and morph targets. Points,
/// lines and primitives without positions are left out. Where a node mirrors its mesh, faces are
/// turned over and stay counter-clockwise seen from outside. The error is the end of a sentence
/// that begins with the file's name: a fault of an accessor, a vertex or mesh that does not exist,
/// or meshes that are repeated so often that their size has nothing to do with the file's. Any
/// thread except the audio thread.
Result<GltfMeshes> meshesOf(const GltfDocument& document);

} // namespace idiophone
