// Fuzzes meshes from OFF files.
#include "Fuzz/MeshFormat.h"

void idiophone::fuzz::examine(std::string_view bytes) {
    examineMesh(bytes, ".off");
}
