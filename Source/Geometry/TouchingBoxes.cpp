#include "Geometry/TouchingBoxes.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>
#include <vector>

namespace idiophone {
namespace {

using Box =
    CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_FROM_BOX_ADDRESS>;

struct TooMany {};

} // namespace

std::optional<std::size_t> touchingBoxes(const Mesh& mesh, std::size_t most) {
    constexpr std::ptrdiff_t fewBoxes = 2000; // below this CGAL's own advice is to test all pairs
    std::vector<Box> boxes;
    boxes.reserve(static_cast<std::size_t>(mesh.faceCount()));
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        CGAL::Bbox_3 box;
        for (int corner = 0; corner < 3; ++corner) {
            const Eigen::RowVector3d at = mesh.vertices.row(mesh.faces(face, corner));
            box += CGAL::Bbox_3(at.x(), at.y(), at.z(), at.x(), at.y(), at.z());
        }
        boxes.emplace_back(box);
    }
    std::vector<const Box*> pointers;
    pointers.reserve(boxes.size());
    for (const auto& box : boxes)
        pointers.push_back(&box);
    std::size_t pairs = 0;
    try {
        CGAL::box_self_intersection_d(
            pointers.begin(), pointers.end(),
            [&](const Box*, const Box*) {
                if (++pairs > most)
                    throw TooMany{};
            },
            fewBoxes);
    } catch (const TooMany&) {
        return std::nullopt;
    }
    return pairs;
}

} // namespace idiophone
