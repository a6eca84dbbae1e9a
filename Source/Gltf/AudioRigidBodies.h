// SPDX-License-Identifier: Apache-2.0
// The glTF extension KHR_audio_rigid_bodies, a draft of 2026: modal models, acoustic materials and
// surfaces, and the nodes that use them. docs/gltf.md says what Idiophone does with it.
#pragma once

#include "Gltf/GltfDocument.h"
#include "Object/ModalObject.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// Dimensions: M modes, P points, F faces.
struct GltfModalModel {
    std::string name;
    std::vector<double> frequenciesHz;   ///< [M] damped, > 0
    std::vector<double> decaysPerSecond; ///< [M] d of e^{−dt}, ≥ 0
    Eigen::MatrixXd positions;           ///< [P×3] in the node's own space
    Eigen::MatrixXd shapes;              ///< [M·P×3] mode by mode, in 1/√kg
    Eigen::MatrixXi faces;               ///< [F×3] indices of points; may be empty
    std::optional<std::size_t> material; ///< index into `materials`
    std::optional<MassProperties> mass;  ///< the inertia is about the centre
    /// Idiophone's own extension of the model, which keeps what the draft has no place for.
    std::optional<std::size_t> objectView = {}; ///< buffer view of a .modal file
    std::optional<int> modesAccessor = {};      ///< [M] the object's mode of each mode
    std::optional<int> verticesAccessor = {};   ///< [P] the object's vertex of each point

    Eigen::Index modeCount() const { return static_cast<Eigen::Index>(frequenciesHz.size()); }
    Eigen::Index pointCount() const { return positions.rows(); }
};

/// Members that the file leaves out are not set.
struct GltfAcousticMaterial {
    std::string name;
    std::optional<double> densityKgPerM3 = {}, youngsModulusPa = {}, poissonRatio = {};
    std::optional<double> alphaPerSecond = {}, betaSeconds = {}; ///< Rayleigh damping: 2d = α + βω²
};

/// A finish. The defaults are the draft's.
struct GltfAcousticSurface {
    std::string name;
    double roughnessMetres = 2e-6;
    double correlationLengthMetres = 5e-5;
    double spectralSlope = -2.4;
    std::optional<std::size_t> material;
};

/// The model and the finish of a node.
struct GltfAudioNode {
    std::optional<std::size_t> model, surface;
    double gain = 1;
};

struct AudioRigidBodies {
    std::vector<GltfModalModel> models;
    std::vector<GltfAcousticMaterial> materials;
    std::vector<GltfAcousticSurface> surfaces;
    std::vector<GltfAudioNode> nodes; ///< one for each node of the file
};

/// Returns whether the file has a modal model, readable or not.
bool hasModalModels(const GltfDocument& document);

/// Returns what the file says; empty lists without the extension. The error is the end of a
/// sentence that begins with the file's name. Any thread except the audio thread.
Result<AudioRigidBodies> audioRigidBodies(const GltfDocument& document);

} // namespace idiophone
