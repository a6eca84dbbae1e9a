// SPDX-License-Identifier: Apache-2.0
// A modal object: the result of analysis and the input of synthesis. It holds only data independent
// of live material changes. Players apply λ ∝ Y/ρ and gains ∝ 1/√m.
#pragma once

#include "Object/Material.h"
#include "Object/RadiationTable.h"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// The maximum value of a shape, in 1/√kg. A shape is at most 1/√(mass at the vertex), and rarely
/// above 10/√(total mass). The limit corresponds to a hundredth of a nanogram. In single precision,
/// every strike on such shapes stays finite.
inline constexpr float largestShape = 1e8f;

/// The maximum number of modes of an object. A large bell has some thousands up to 20 kHz. A player
/// needs half a kilobyte for each mode, however small the file is.
inline constexpr std::size_t maximumObjectModes = 65536;

enum class BodyKind { solid, shell };

struct MassProperties {
    double massKg = 0;
    std::array<double, 3> centreMetres{};
    std::array<double, 9> inertiaKgM2{}; ///< about the centre, row-major

    bool operator==(const MassProperties&) const = default;
};

/// The origin of an object, for people and for `idiophone info`.
struct Provenance {
    std::string source;   ///< mesh file or generator
    std::string software; ///< "Idiophone 0.2.0"
    std::string notes;    ///< remarks of repair and analysis
    double analysisSeconds = 0;
    std::int64_t analysedVertices = 0; ///< vertices of the analysed mesh
    std::int64_t zeroModes = 0;        ///< rigid and spurious modes, which were left out
};

/// Dimensions: V vertices with shapes, M modes, N mesh vertices, F faces. Any number of threads may
/// read a value that passed `validated`. Everything read from a file has passed it.
struct ModalObject {
    std::string name;
    Material material; ///< reference material of `eigenvalues`
    BodyKind body = BodyKind::solid;
    double thicknessMetres = 0; ///< reference thickness of a shell; 0 for a solid
    std::string method;         ///< "spring-mass", "van-gelder", "two-layer", "fem", "measured"
    double bandHz = 0;          ///< every mode from 20 Hz up to here is present

    std::vector<double> eigenvalues; ///< [M] λ = ω² in rad²/s², ascending, 0.001 Hz to 1 GHz
    std::vector<float> shapes;       ///< [V,M,3] mass-normalised (GᵀMG = I), in 1/√kg
    std::vector<std::int32_t> shapeVertices;   ///< [V] mesh vertices that carry shapes, ascending
    std::vector<float> vertices;               ///< [N,3] in metres
    std::vector<std::int32_t> faces;           ///< [F,3] counter-clockwise seen from outside
    std::vector<std::int32_t> clampedVertices; ///< mesh vertices that are held, ascending; or none
    /// Empty, or [M] the part of λ that grows with the square of a shell's thickness (0 ≤ b ≤ λ).
    std::vector<double> bending;
    /// Empty if modes decay by the material's law. Else [M] measured decay rates α > 0 at the
    /// reference material. Another material scales them by its law.
    std::vector<double> decaysPerSecond;
    /// Empty, or [M] additional decay rates α ≥ 0, the losses in cords, a tube or a clamp.
    /// Independent of the material.
    std::vector<double> extraDecaysPerSecond;
    /// Empty if all are 1. Else [M] factors of the velocity at the struck point. They are complex
    /// where a bar and its tube share a mode. The radiation has factors of its own.
    std::vector<std::complex<float>> gains;
    RadiationTable radiation; ///< of the whole surface, or empty

    MassProperties mass;
    Provenance provenance;

    std::size_t modeCount() const { return eigenvalues.size(); }
    std::size_t shapeVertexCount() const { return shapeVertices.size(); }
    std::size_t vertexCount() const { return vertices.size() / 3; }
    std::size_t faceCount() const { return faces.size() / 3; }

    /// Returns whether the thickness may change during play. Otherwise a new thickness needs an
    /// analysis.
    bool hasLiveThickness() const noexcept { return !bending.empty(); }

    /// Returns λ of a mode if the shell is `thicknessRatio` > 0 times as thick, by Rayleigh's
    /// quotient with unchanged shapes. Exact for flat sheets; docs/validation.md has the error for
    /// others.
    double eigenvalueAt(std::size_t mode, double thicknessRatio) const noexcept {
        return hasLiveThickness()
                   ? eigenvalues[mode] + (thicknessRatio * thicknessRatio - 1) * bending[mode]
                   : eigenvalues[mode];
    }

    /// Returns the decay rate α [1/s] of a mode at the reference material. Any thread.
    double decayPerSecond(std::size_t mode) const noexcept {
        return (decaysPerSecond.empty() ? material.damping.perSecond(eigenvalues[mode]) / 2
                                        : decaysPerSecond[mode]) +
               damping(mode).extraPerSecond;
    }

    /// Returns the damped frequency in Hz of a mode at the reference material. Any thread.
    double dampedFrequencyHz(std::size_t mode) const noexcept {
        return idiophone::dampedFrequencyHz(eigenvalues[mode], decayPerSecond(mode));
    }

    /// Returns the deviation of a mode's damping from the law of any material. Any thread.
    ModeDamping damping(std::size_t mode) const noexcept {
        return {.scale =
                    decaysPerSecond.empty()
                        ? 1
                        : 2 * decaysPerSecond[mode] / material.damping.perSecond(eigenvalues[mode]),
                .extraPerSecond = extraDecaysPerSecond.empty() ? 0 : extraDecaysPerSecond[mode]};
    }

    /// Returns the deviations of [M] modes, or nothing if all modes follow the law. Any thread;
    /// allocates.
    std::vector<ModeDamping> dampings() const {
        std::vector<ModeDamping> result;
        if (!decaysPerSecond.empty() || !extraDecaysPerSecond.empty())
            for (std::size_t mode = 0; mode < modeCount(); ++mode)
                result.push_back(damping(mode));
        return result;
    }

    /// Returns whether a bar and its tube share the mode. Any thread.
    bool isShared(std::size_t mode) const noexcept { return !gains.empty() && gains[mode] != 1.0f; }

    /// Returns the shapes [M,3] of all modes at row `shapeRow` of `shapeVertices`.
    std::span<const float> shapesAt(std::size_t shapeRow) const {
        return {shapes.data() + shapeRow * modeCount() * 3, modeCount() * 3};
    }
};

/// Returns the object unchanged, or the first error: inconsistent sizes, an index or value out of
/// range, or texts too long for a file.
Result<ModalObject> validated(ModalObject object);

/// Returns unit outward normals [N,3]: the area-weighted mean over the faces at each mesh vertex,
/// (0,0,1) at a vertex without faces.
std::vector<float> vertexNormals(const ModalObject& object);

/// Returns [M] Σ |φ|² over the vertices with shapes, in 1/kg: the motion of the whole object in
/// each mode.
std::vector<double> summedSquareShapes(const ModalObject& object);

/// Returns the partner of a mode if a bar's mode and its tube form a pair of modes. Both have the
/// same shape, and their gains add up to 1. Returns nothing for a mode of the bar alone.
std::optional<std::size_t> sharingPartner(const ModalObject& object, std::size_t mode) noexcept;

/// Returns the row of `shapeVertices` that is nearest to a point in metres. Takes time proportional
/// to the rows. Any thread.
std::size_t nearestShapeRow(const ModalObject& object, const std::array<double, 3>& pointMetres);

} // namespace idiophone
