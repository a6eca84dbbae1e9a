#include "Scene/SurfaceTree.h"

#include "Geometry/ParametricMesh.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <random>
#include <vector>

using namespace idiophone;

namespace {

using Box = Eigen::AlignedBox3d;

std::vector<int> facesIn(const btOptimizedBvh& tree, const Box& box) {
    struct Found final : btNodeOverlapCallback {
        void processNode(int, int face) override { faces.push_back(face); }
        std::vector<int> faces;
    } found;
    tree.reportAabbOverlappingNodex(&found, toBullet(box.min()), toBullet(box.max()));
    std::ranges::sort(found.faces);
    return found.faces;
}

Box boxOf(const Mesh& mesh, Eigen::Index face) {
    Box box;
    for (int corner = 0; corner < 3; ++corner)
        box.extend(mesh.vertices.row(mesh.faces(face, corner)).transpose());
    return box;
}

} // namespace

TEST_CASE("Bullet finds exactly the faces whose boxes meet the query in a surface's tree") {
    for (const double radiusMetres : {1.0, 1e-4}) { // also far below Bullet's minimum box size
        const auto ball = icosphereMesh(radiusMetres, 3);
        const SurfaceTree tree(ball);
        std::mt19937 random(1);
        std::uniform_real_distribution<double> anywhere(-radiusMetres, radiusMetres);
        std::size_t all = 0;
        for (int query = 0; query < 200; ++query) {
            Box box;
            for (int corner = 0; corner < 2; ++corner)
                box.extend(Eigen::Vector3d(anywhere(random), anywhere(random), anywhere(random)));
            std::vector<int> met;
            for (Eigen::Index face = 0; face < ball.faceCount(); ++face)
                if (box.intersects(boxOf(ball, face)))
                    met.push_back(static_cast<int>(face));
            CHECK(facesIn(tree, box) == met);
            all += met.size();
        }
        CHECK(all > 1000);
    }
}
