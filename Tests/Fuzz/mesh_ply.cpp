// Fuzzes meshes from PLY files, text and binary.
#include "Fuzz/MeshFormat.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    examineMesh(bytes, ".ply");
}
