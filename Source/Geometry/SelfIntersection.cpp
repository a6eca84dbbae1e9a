#include "Geometry/SelfIntersection.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>
#include <array>
#include <vector>

namespace idiophone {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Box = CGAL::Box_intersection_d::
    Box_with_info_d<double, 3, int, CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;

struct Found {};
struct GivenUp {};

class FaceTest {
public:
    explicit FaceTest(const Mesh& mesh) : mesh_(mesh) {
        points_.reserve(mesh.vertexCount());
        for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v)
            points_.emplace_back(mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2));
    }

    Kernel::Triangle_3 triangle(int face) const {
        return {point(face, 0), point(face, 1), point(face, 2)};
    }

    bool intersect(int f, int g) const {
        std::array<int, 3> inF{}, inG{}; // shared corners come first
        int shared = 0;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                if (mesh_.faces(f, i) == mesh_.faces(g, j)) {
                    inF[shared] = i;
                    inG[shared++] = j;
                }
        switch (shared) {
        case 0:
            return CGAL::do_intersect(triangle(f), triangle(g));
        case 1:
            return CGAL::do_intersect(triangle(f), oppositeSide(g, inG[0])) ||
                   CGAL::do_intersect(triangle(g), oppositeSide(f, inF[0]));
        case 2:
            return areFolded(point(f, inF[0]), point(f, inF[1]), point(f, 3 - inF[0] - inF[1]),
                             point(g, 3 - inG[0] - inG[1]));
        default:
            return true;
        }
    }

private:
    const Point& point(int face, int corner) const { return points_[mesh_.faces(face, corner)]; }
    Kernel::Segment_3 oppositeSide(int face, int corner) const {
        return {point(face, (corner + 1) % 3), point(face, (corner + 2) % 3)};
    }
    /// Returns true if two triangles on the edge ab lie in one plane and on the same side of it.
    static bool areFolded(const Point& a, const Point& b, const Point& p, const Point& q) {
        return CGAL::coplanar(a, b, p, q) &&
               CGAL::coplanar_orientation(a, b, p, q) == CGAL::POSITIVE;
    }

    const Mesh& mesh_;
    std::vector<Point> points_;
};

} // namespace

std::optional<bool> intersectsItself(const Mesh& mesh, const std::atomic<bool>* cancelled) {
    constexpr std::int64_t maximumPairs = 50'000'000;
    constexpr std::ptrdiff_t fewBoxes = 2000; // CGAL recommends testing all pairs of fewer boxes
    const FaceTest test(mesh);
    std::vector<Box> boxes;
    boxes.reserve(mesh.faceCount());
    for (int face = 0; face < mesh.faceCount(); ++face) {
        const auto triangle = test.triangle(face);
        if (triangle.is_degenerate())
            return true;
        boxes.emplace_back(triangle.bbox(), face);
    }
    std::vector<const Box*> pointers;
    pointers.reserve(boxes.size());
    for (const auto& box : boxes)
        pointers.push_back(&box);
    std::int64_t pairs = 0;
    try {
        CGAL::box_self_intersection_d(
            pointers.begin(), pointers.end(),
            [&](const Box* a, const Box* b) {
                if (++pairs > maximumPairs ||
                    (pairs % 1024 == 0 && cancelled != nullptr && cancelled->load()))
                    throw GivenUp{};
                if (test.intersect(a->info(), b->info()))
                    throw Found{};
            },
            fewBoxes);
    } catch (const Found&) {
        return true;
    } catch (const GivenUp&) {
        return std::nullopt;
    }
    return false;
}

} // namespace idiophone
