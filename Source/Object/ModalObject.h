// A modal object: what analysis computes from a mesh and synthesis plays. It holds only what does
// not depend on live material changes; λ ∝ Y/ρ and gains ∝ 1/√m are applied where it is played.
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

/// 1/√kg. A shape is nowhere larger than 1/√(the mass at that
/// vertex), and is hardly beyond 10/√(the whole mass): this is that of a hundredth of a nanogram.
/// In single precision all that a mallet can do to such shapes stays finite.
inline constexpr float largestShape = 1e8f;

/// A large bell has some thousands of modes up to 20 kHz. Whoever plays an object needs half a
/// kilobyte for each, however few bytes a file has for it.
inline constexpr std::size_t mostObjectModes = 65536;

enum class BodyKind { solid, shell };

struct MassProperties {
    double massKg = 0;
    std::array<double, 3> centreMetres{};
    std::array<double, 9> inertiaKgM2{}; ///< about the centre, row-major
};

/// Where an object comes from, for people and for `idiophone info`.
struct Provenance {
    std::string source;   ///< mesh file or generator
    std::string software; ///< "Idiophone 0.1.0"
    std::string notes;    ///< what repair and analysis found worth saying
    double analysisSeconds = 0;
    std::int64_t analysedVertices = 0; ///< vertices of the mesh that was analysed
    std::int64_t zeroModes = 0;        ///< rigid and spurious modes found and left out
};

/// V vertices carry shapes, M modes, N mesh vertices, F faces. A value that passed `validated` (as
/// everything read from a file has) may be shared, read-only, by any number of threads.
struct ModalObject {
    std::string name;
    Material material; ///< reference material: `eigenvalues` belong to it
    BodyKind body = BodyKind::solid;
    double thicknessMetres = 0; ///< reference thickness of a shell; 0 for a solid
    std::string method;         ///< "spring-mass", "van-gelder", "two-layer", "fem", "measured"
    double bandHz = 0;          ///< every mode from 20 Hz up to here is present

    std::vector<double> eigenvalues; ///< [M] λ = ω² in rad²/s², ascending, 0.001 Hz to 1 GHz
    std::vector<float> shapes;       ///< [V,M,3] mass-normalised (GᵀMG = I), in 1/√kg
    std::vector<std::int32_t> shapeVertices; ///< [V] which mesh vertices carry shapes, ascending
    std::vector<float> vertices;             ///< [N,3] in metres
    std::vector<std::int32_t> faces;         ///< [F,3] counter-clockwise seen from outside
    /// Empty, or [M] the part of λ that grows with the square of a shell's thickness (0 ≤ b ≤ λ).
    std::vector<double> bending;
    /// Empty: modes decay by the material's law. Or [M] the α > 0 of each at the reference
    /// material, as measured; another material changes it as the law says.
    std::vector<double> decaysPerSecond;
    /// Empty, or [M] the α ≥ 0 that comes on top and does not follow the material: what cords and a
    /// tube take.
    std::vector<double> extraDecaysPerSecond;
    /// Empty: all 1. Or [M] what the velocity of the struck point is multiplied by: complex where a
    /// bar and its tube share a mode. The radiation has its own.
    std::vector<std::complex<float>> gains;
    RadiationTable radiation; ///< of the whole surface, or empty

    MassProperties mass;
    Provenance provenance;

    std::size_t modeCount() const { return eigenvalues.size(); }
    std::size_t shapeVertexCount() const { return shapeVertices.size(); }
    std::size_t vertexCount() const { return vertices.size() / 3; }
    std::size_t faceCount() const { return faces.size() / 3; }

    /// Whether the thickness may change while the object is played; otherwise it is analysed anew.
    bool hasLiveThickness() const noexcept { return !bending.empty(); }

    /// λ of a mode of the shell `thicknessRatio` > 0 times as thick, by Rayleigh's quotient with
    /// the shape as it was: exact for flat sheets, and within what docs/validation.md says for
    /// others.
    double eigenvalueAt(std::size_t mode, double thicknessRatio) const noexcept {
        return hasLiveThickness()
                   ? eigenvalues[mode] + (thicknessRatio * thicknessRatio - 1) * bending[mode]
                   : eigenvalues[mode];
    }

    /// α [1/s] of a mode at the reference material. Any thread.
    double decayPerSecond(std::size_t mode) const noexcept {
        return (decaysPerSecond.empty() ? material.damping.perSecond(eigenvalues[mode]) / 2
                                        : decaysPerSecond[mode]) +
               damping(mode).extraPerSecond;
    }

    /// The frequency in Hz at which a mode sounds at the reference material. Any thread.
    double dampedFrequencyHz(std::size_t mode) const noexcept {
        return idiophone::dampedFrequencyHz(eigenvalues[mode], decayPerSecond(mode));
    }

    /// How a mode's damping differs from the material's law, whatever the material. Any thread.
    ModeDamping damping(std::size_t mode) const noexcept {
        return {.scale =
                    decaysPerSecond.empty()
                        ? 1
                        : 2 * decaysPerSecond[mode] / material.damping.perSecond(eigenvalues[mode]),
                .extraPerSecond = extraDecaysPerSecond.empty() ? 0 : extraDecaysPerSecond[mode]};
    }

    /// [M], or empty where all modes keep to the law. Any thread; allocates.
    std::vector<ModeDamping> dampings() const {
        std::vector<ModeDamping> result;
        if (!decaysPerSecond.empty() || !extraDecaysPerSecond.empty())
            for (std::size_t mode = 0; mode < modeCount(); ++mode)
                result.push_back(damping(mode));
        return result;
    }

    /// Whether a bar and its tube share a mode. Any thread.
    bool isShared(std::size_t mode) const noexcept { return !gains.empty() && gains[mode] != 1.0f; }

    /// [M,3] shapes of all modes at row `shapeRow` of `shapeVertices`.
    std::span<const float> shapesAt(std::size_t shapeRow) const {
        return {shapes.data() + shapeRow * modeCount() * 3, modeCount() * 3};
    }
};

/// The object unchanged, or the first thing wrong with it: sizes that disagree, an index out of
/// range, a value that is not in order or that no object has, texts too long for a file.
Result<ModalObject> validated(ModalObject object);

/// Unit outward normals [N,3], the area-weighted mean over the faces at each mesh vertex
/// ((0,0,1) at a vertex of no face).
std::vector<float> vertexNormals(const ModalObject& object);

/// [M] Σ |φ|² over the vertices that carry shapes, in 1/kg: how far a mode moves the object as a
/// whole.
std::vector<double> summedSquareShapes(const ModalObject& object);

/// Returns the other one of the two modes that a bar's mode makes with its tube: it has the same
/// shape, and the two gains add up to 1. Returns nothing for a mode of the bar alone.
std::optional<std::size_t> sharingPartner(const ModalObject& object, std::size_t mode) noexcept;

/// The row of `shapeVertices` whose vertex is nearest to a point in metres, of those that there
/// are. Takes time with their number; any thread.
std::size_t nearestShapeRow(const ModalObject& object, const std::array<double, 3>& pointMetres);

} // namespace idiophone
