// Fuzzes meshes from STL files, text and binary.
#include "Fuzz/MeshFormat.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    examineMesh(bytes, ".stl");
}
