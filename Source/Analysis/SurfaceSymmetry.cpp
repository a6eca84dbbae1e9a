#include "Analysis/SurfaceSymmetry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>

namespace idiophone {
namespace {

using Permutation = std::vector<int>;

constexpr double positionTolerance = 1e-6; // of the bounding diagonal
constexpr int maximumTurns = 360;

/// Meshes are not aligned with this direction, so that few points share a place along it.
Eigen::Vector3d obliqueDirection() {
    return {0.8191, 0.4713, 0.3272};
}

/// Finds faces by the positions of their corners.
class FaceFinder {
public:
    explicit FaceFinder(const Mesh& mesh)
        : mesh_(mesh), tolerance_(positionTolerance * boundingDiagonalMetres(mesh)),
          order_(allVertices(mesh)), places_(mesh.vertices * obliqueDirection()) {
        std::ranges::sort(order_, {}, [&](int vertex) { return places_(vertex); });
        for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
            faces_.emplace(sorted(mesh.faces.row(face)), static_cast<int>(face));
    }

    /// Returns the image of each face under the isometry about `centre`, if all images are faces.
    std::optional<Permutation> imagesUnder(const Eigen::Matrix3d& isometry,
                                           const Eigen::RowVector3d& centre) const {
        std::vector<int> vertices;
        for (const auto& vertex : mesh_.vertices.rowwise()) {
            vertices.push_back(vertexAt((vertex - centre) * isometry.transpose() + centre));
            if (vertices.back() < 0)
                return {};
        }
        Permutation images;
        for (const auto& face : mesh_.faces.rowwise()) {
            const auto image = [&](int k) { return vertices[face(k)]; };
            const auto found = faces_.find(sorted({image(0), image(1), image(2)}));
            if (found == faces_.end())
                return {};
            images.push_back(found->second);
        }
        return images;
    }

private:
    static std::array<int, 3> sorted(const Eigen::RowVector3i& face) {
        std::array<int, 3> corners{face(0), face(1), face(2)};
        std::ranges::sort(corners);
        return corners;
    }

    int vertexAt(const Eigen::RowVector3d& point) const {
        const double place = point.dot(obliqueDirection());
        for (auto at = std::ranges::lower_bound(order_, place - tolerance_, {},
                                                [&](int vertex) { return places_(vertex); });
             at != order_.end() && places_(*at) <= place + tolerance_; ++at)
            if ((mesh_.vertices.row(*at) - point).norm() <= tolerance_)
                return *at;
        return -1;
    }

    const Mesh& mesh_;
    double tolerance_;
    std::vector<int> order_; ///< vertices along the oblique direction
    Eigen::VectorXd places_;
    std::map<std::array<int, 3>, int> faces_;
};

/// A cyclic group: its generator, and the number of applications that give the identity.
struct Generator {
    Permutation images;
    int order = 1;
};

std::vector<std::vector<int>> elementsOf(const std::vector<Generator>& generators,
                                         Eigen::Index faces) {
    Permutation identity(faces);
    std::iota(identity.begin(), identity.end(), 0);
    std::vector<Permutation> elements{identity};
    for (const auto& generator : generators) {
        const std::size_t before = elements.size();
        for (int power = 1; power < generator.order; ++power)
            for (std::size_t element = 0; element < before; ++element) {
                Permutation next = elements[elements.size() - before];
                for (int& face : next)
                    face = generator.images[face];
                elements.push_back(std::move(next));
            }
    }
    return elements;
}

/// Rows and columns have the order of `elementsOf`: the exponent of the first generator runs
/// fastest.
Eigen::MatrixXcd charactersOf(const std::vector<Generator>& generators) {
    Eigen::MatrixXcd characters = Eigen::MatrixXcd::Ones(1, 1);
    for (const auto& generator : generators) {
        const Eigen::Index before = characters.rows(), order = generator.order;
        Eigen::MatrixXcd product(before * order, before * order);
        for (Eigen::Index character = 0; character < order; ++character)
            for (Eigen::Index power = 0; power < order; ++power)
                product.block(character * before, power * before, before, before) =
                    characters *
                    std::polar(1.0, 2 * std::numbers::pi *
                                        static_cast<double>(character * power % order) /
                                        static_cast<double>(order));
        characters = std::move(product);
    }
    return characters;
}

int orderOf(const std::vector<Generator>& generators) {
    int order = 1;
    for (const auto& generator : generators)
        order *= generator.order;
    return order;
}

Eigen::RowVector3d centroidOf(const Mesh& mesh) {
    const Eigen::VectorXd areas = vertexAreas(mesh);
    return (areas.transpose() * mesh.vertices) / areas.sum();
}

} // namespace

SurfaceOrbits orbitsOf(const SurfaceSymmetry& symmetry, const Mesh& mesh) {
    // The first face of an orbit is the farthest along a direction. So the first faces fill one
    // corner for mirrors and one wedge for turns.
    std::vector<double> places;
    for (const auto& face : mesh.faces.rowwise())
        places.push_back(
            (mesh.vertices.row(face(0)) + mesh.vertices.row(face(1)) + mesh.vertices.row(face(2)))
                .dot(obliqueDirection()));
    std::vector<int> faces(places.size());
    std::iota(faces.begin(), faces.end(), 0);
    std::ranges::stable_sort(faces, std::greater{}, [&](int face) { return places[face]; });
    SurfaceOrbits result{
        {}, std::vector<int>(faces.size(), -1), std::vector<int>(faces.size(), 0), {}};
    for (const int first : faces) {
        if (result.orbits[first] >= 0)
            continue;
        bool isFixed = false;
        for (std::size_t element = 0; element < symmetry.images.size(); ++element) {
            const auto image = static_cast<std::size_t>(symmetry.images[element][first]);
            if (result.orbits[image] >= 0) {
                isFixed = true;
                continue;
            }
            result.orbits[image] = static_cast<int>(result.firsts.size());
            result.elements[image] = static_cast<int>(element);
        }
        result.firsts.push_back(first);
        result.areFixed.push_back(isFixed);
    }
    return result;
}

SurfaceSymmetry surfaceSymmetry(const Mesh& mesh) {
    const FaceFinder finder(mesh);
    const Eigen::RowVector3d centre = centroidOf(mesh);
    const auto mirror = [&](int axis) -> std::optional<Generator> {
        Eigen::Matrix3d isometry = Eigen::Matrix3d::Identity();
        isometry(axis, axis) = -1;
        if (auto images = finder.imagesUnder(isometry, centre))
            return Generator{std::move(*images), 2};
        return {};
    };
    const auto turn = [&](int axis) -> std::optional<Generator> {
        for (int order = maximumTurns; order > 1; --order) {
            const Eigen::AngleAxisd rotation(2 * std::numbers::pi / order,
                                             Eigen::Vector3d::Unit(axis));
            if (auto images = finder.imagesUnder(rotation.toRotationMatrix(), centre))
                return Generator{std::move(*images), order};
        }
        return {};
    };

    std::vector<Generator> best;
    for (int axis = 0; axis < 3; ++axis)
        if (auto generator = mirror(axis))
            best.push_back(std::move(*generator));
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<Generator> turned;
        if (auto generator = turn(axis)) {
            turned.push_back(std::move(*generator));
            if (auto across = mirror(axis))
                turned.push_back(std::move(*across));
        }
        if (orderOf(turned) > orderOf(best))
            best = std::move(turned);
    }
    return {elementsOf(best, mesh.faceCount()), charactersOf(best)};
}

} // namespace idiophone
