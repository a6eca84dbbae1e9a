// Fuzzes meshes from glTF files: text, and binary with a chunk.
#include "Fuzz/MeshFormat.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    examineMesh(bytes, ".glb"); // the content tells it from .gltf
}
