// Fuzzes meshes from Wavefront OBJ files.
#include "Fuzz/MeshFormat.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    examineMesh(bytes, ".obj");
}
