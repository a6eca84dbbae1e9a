// Writes files for import into the test's own folder.
#pragma once

#include "Geometry/MeshWriter.h"
#include "Geometry/ParametricMesh.h"
#include "Plugin/Processor.h"
#include "Support/TestFolder.h"
#include "Support/WaitUntil.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>

namespace idiophone::test {

/// Polls until an import has ended and its object plays.
inline void finish(
    Processor& processor, const std::function<void()>& meanwhile = [] {}) {
    const auto poll = [&] {
        processor.poll();
        meanwhile();
    };
    waitUntil([&] { return !processor.view().workshop.importStatus().isWorking(); }, poll);
    poll();
}

inline std::filesystem::path writtenFile(const std::string& name, const std::string& bytes) {
    const auto file = testFolder() / name;
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
}

inline std::filesystem::path meshFile(const std::string& name, const Mesh& mesh) {
    const auto file = testFolder() / name;
    if (!writeMesh(mesh, file))
        throw std::runtime_error("cannot write " + file.string());
    return file;
}

/// Writes a sheet of 60 x 36 mm in the given unit; its analysis is fast.
inline std::filesystem::path smallPlateFile(const std::string& name, double unitsPerMetre) {
    auto mesh = sheetMesh(0.06, 0.036, 150);
    mesh.vertices *= unitsPerMetre;
    return meshFile(name, mesh);
}

} // namespace idiophone::test
