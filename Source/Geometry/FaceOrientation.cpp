#include "Geometry/FaceOrientation.h"

#include "Mesh/SurfaceQuery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace idiophone {
namespace {

struct Patch {
    std::vector<int> faces;
    bool isClosed = true;
    Eigen::AlignedBox3d box;
};

using FaceFlags = std::vector<char>; ///< [F] true if the face must be turned over

Patch collectPatch(const EdgePairing& pairing, int seed, FaceFlags& seen, FaceFlags& flip) {
    Patch patch{.faces = {seed}, .isClosed = true, .box = {}};
    seen[seed] = 1;
    for (std::size_t next = 0; next < patch.faces.size(); ++next) {
        const int face = patch.faces[next];
        for (const auto& partner : pairing.partners[face])
            if (partner.face >= 0 && !seen[partner.face]) {
                seen[partner.face] = 1;
                flip[partner.face] = (flip[face] != 0) != partner.sameDirection;
                patch.faces.push_back(partner.face);
            }
    }
    return patch;
}

/// Separates partners that cannot agree and returns the number of such edges.
int partOneSidedEdges(Patch& patch, EdgePairing& pairing, const FaceFlags& flip) {
    int parted = 0;
    for (const int face : patch.faces)
        for (auto& partner : pairing.partners[face]) {
            // The test is symmetric, so both partners drop each other.
            if (partner.face >= 0 &&
                ((flip[face] != 0) != (flip[partner.face] != 0)) != partner.sameDirection) {
                partner = {};
                ++parted;
            }
            patch.isClosed = patch.isClosed && partner.face >= 0;
        }
    return parted / 2;
}

double volumeOf(const Mesh& mesh, const Patch& patch, const FaceFlags& flip) {
    const Eigen::RowVector3d origin = mesh.vertices.row(mesh.faces(patch.faces.front(), 0));
    double sum = 0;
    for (const int face : patch.faces) {
        const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(face, 0)) - origin;
        const Eigen::RowVector3d b = mesh.vertices.row(mesh.faces(face, 1)) - origin;
        const Eigen::RowVector3d c = mesh.vertices.row(mesh.faces(face, 2)) - origin;
        sum += (flip[face] ? -1 : 1) * a.dot(b.cross(c));
    }
    return sum;
}

/// A closed patch turns outward. An open one keeps the side that most of its faces show.
void chooseSide(const Mesh& mesh, const Patch& patch, FaceFlags& flip) {
    const auto flips =
        std::ranges::count_if(patch.faces, [&](int face) { return flip[face] != 0; });
    if (patch.isClosed ? volumeOf(mesh, patch, flip) < 0
                       : 2 * flips > static_cast<std::ptrdiff_t>(patch.faces.size()))
        for (const int face : patch.faces)
            flip[face] = !flip[face];
}

/// Tests whether points lie inside a closed patch.
class Inside {
public:
    Inside(const Mesh& mesh, const Patch& patch) : box_(patch.box), surface_(meshOf(mesh, patch)) {}

    /// Counts how often a ray in an arbitrary direction passes through the patch. Returns nothing
    /// if `boxBudget` runs out (SurfaceQuery::passages).
    std::optional<bool> contains(const Eigen::Vector3d& point, std::int64_t& boxBudget) const {
        if (!box_.contains(point))
            return false;
        const Eigen::Vector3d direction = Eigen::Vector3d(0.5377, 0.2846, 0.7937).normalized();
        const auto passages = surface_.passages(point, direction, boxBudget);
        if (!passages)
            return std::nullopt;
        // Passages closer than this go through one edge and count once.
        const double stepMetres = 1e-10 * box_.diagonal().norm();
        double from = 0;
        bool isInside = false;
        for (const double metres : *passages)
            if (metres >= from) {
                isInside = !isInside;
                from = metres + stepMetres;
            }
        return isInside;
    }

private:
    static Mesh meshOf(const Mesh& mesh, const Patch& patch) {
        Mesh result{Eigen::MatrixXd(3 * patch.faces.size(), 3),
                    Eigen::MatrixXi(patch.faces.size(), 3)};
        for (int row = 0; row < result.vertices.rows(); ++row) {
            const int face = patch.faces[row / 3];
            result.vertices.row(row) = mesh.vertices.row(mesh.faces(face, row % 3));
            result.faces(row / 3, row % 3) = row;
        }
        return result;
    }

    Eigen::AlignedBox3d box_;
    SurfaceQuery surface_;
};

/// Takes the majority of five faces, because patches may touch or cut each other.
std::optional<bool>
liesInside(const Mesh& mesh, const Patch& patch, const Inside& other, std::int64_t& boxBudget) {
    int inside = 0;
    for (std::size_t i = 0; i < 5; ++i) {
        const int face = patch.faces[i * (patch.faces.size() - 1) / 4];
        const Eigen::RowVector3d centre =
            (mesh.vertices.row(mesh.faces(face, 0)) + mesh.vertices.row(mesh.faces(face, 1)) +
             mesh.vertices.row(mesh.faces(face, 2))) /
            3;
        const auto isInside = other.contains(centre.transpose(), boxBudget);
        if (!isInside)
            return std::nullopt;
        inside += *isInside ? 1 : 0;
    }
    return inside >= 3;
}

/// Turns the closed patches that lie inside an odd number of others and returns their number.
/// Returns nothing and turns none if this takes more than a second or two, or if cancelled.
std::optional<int> turnHollows(const Mesh& mesh,
                               std::vector<Patch> patches,
                               FaceFlags& flip,
                               const std::atomic<bool>* cancelled) {
    std::int64_t boxBudget = 50'000'000;
    constexpr std::size_t maximumPatches = 1000;
    std::erase_if(patches, [](const Patch& patch) { return !patch.isClosed; });
    std::ranges::stable_sort(patches, std::greater{},
                             [](const Patch& patch) { return patch.faces.size(); });
    patches.resize(std::min(patches.size(), maximumPatches));
    for (auto& patch : patches)
        for (const int face : patch.faces)
            for (int corner = 0; corner < 3; ++corner)
                patch.box.extend(mesh.vertices.row(mesh.faces(face, corner)).transpose());
    std::vector<int> depth(patches.size(), 0);
    for (const auto& outer : patches) {
        std::vector<std::size_t> candidates;
        for (std::size_t i = 0; i < patches.size(); ++i)
            if (&patches[i] != &outer && outer.box.contains(patches[i].box))
                candidates.push_back(i);
        if (candidates.empty())
            continue;
        const Inside inside(mesh, outer);
        for (const std::size_t i : candidates) {
            const auto isInside = liesInside(mesh, patches[i], inside, boxBudget);
            if (!isInside || (cancelled != nullptr && cancelled->load()))
                return std::nullopt;
            depth[i] += *isInside ? 1 : 0;
        }
    }
    int turned = 0;
    for (std::size_t i = 0; i < patches.size(); ++i)
        if (depth[i] % 2 == 1) {
            ++turned;
            for (const int face : patches[i].faces)
                flip[face] = !flip[face];
        }
    return turned;
}

int turnOver(Mesh& mesh, EdgePairing& pairing, const FaceFlags& flip) {
    int turned = 0;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        auto& partners = pairing.partners[face];
        for (auto& partner : partners)
            partner.sameDirection = false;
        if (!flip[face])
            continue;
        std::swap(mesh.faces(face, 1), mesh.faces(face, 2));
        std::swap(partners[0], partners[2]);
        ++turned;
    }
    return turned;
}

} // namespace

OrientationReport
orientFaces(Mesh& mesh, EdgePairing& pairing, const std::atomic<bool>* cancelled) {
    OrientationReport report;
    std::vector<Patch> patches;
    FaceFlags seen(mesh.faceCount(), 0), flip(mesh.faceCount(), 0);
    for (int seed = 0; seed < mesh.faceCount(); ++seed) {
        if (seen[seed])
            continue;
        auto patch = collectPatch(pairing, seed, seen, flip);
        report.oneSidedEdges += partOneSidedEdges(patch, pairing, flip);
        chooseSide(mesh, patch, flip);
        patches.push_back(std::move(patch));
    }
    const auto hollows = turnHollows(mesh, std::move(patches), flip, cancelled);
    report.hollows = hollows.value_or(0);
    report.isTangled = !hollows;
    report.flippedFaces = turnOver(mesh, pairing, flip);
    return report;
}

} // namespace idiophone
