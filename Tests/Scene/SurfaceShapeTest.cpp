// Tests which faces of a surface Bullet gets to see.
#include "Scene/SurfaceShape.h"

#include "Geometry/ParametricMesh.h"
#include "Scene/BulletMath.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <random>
#include <vector>

using namespace idiophone;

namespace {

using Box = Eigen::AlignedBox3d;

struct Surface {
    explicit Surface(const Mesh& shown) : mesh(shown), shape(filled(), mesh) {}

    std::vector<int> facesIn(const Box& box) const {
        struct Found final : btTriangleCallback {
            void processTriangle(btVector3*, int, int face) override { faces.push_back(face); }
            std::vector<int> faces;
        } found;
        shape.processAllTriangles(&found, toBullet(box.min()), toBullet(box.max()));
        std::ranges::sort(found.faces);
        return found.faces;
    }

    /// Returns the corners of a face.
    Eigen::Matrix3d corners(Eigen::Index face) const {
        Eigen::Matrix3d rows;
        for (int corner = 0; corner < 3; ++corner)
            rows.row(corner) = mesh.vertices.row(mesh.faces(face, corner));
        return rows;
    }

    Mesh mesh;
    btTriangleMesh triangles;
    SurfaceShape shape;

private:
    btTriangleMesh& filled() {
        for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
            const auto rows = corners(face);
            triangles.addTriangle(toBullet(Eigen::Vector3d(rows.row(0))),
                                  toBullet(Eigen::Vector3d(rows.row(1))),
                                  toBullet(Eigen::Vector3d(rows.row(2))));
        }
        return triangles;
    }
};

Box boxOf(const Eigen::Matrix3d& corners) {
    return {corners.colwise().minCoeff().transpose(), corners.colwise().maxCoeff().transpose()};
}

} // namespace

TEST_CASE("Without a body, Bullet finds exactly the faces whose boxes meet the query") {
    for (const double radiusMetres : {1.0, 1e-4}) { // also far below Bullet's minimum box size
        const Surface ball(icosphereMesh(radiusMetres, 3));
        std::mt19937 random(1);
        std::uniform_real_distribution<double> anywhere(-radiusMetres, radiusMetres);
        std::size_t all = 0;
        for (int query = 0; query < 200; ++query) {
            Box box;
            for (int corner = 0; corner < 2; ++corner)
                box.extend(Eigen::Vector3d(anywhere(random), anywhere(random), anywhere(random)));
            std::vector<int> met;
            for (Eigen::Index face = 0; face < ball.mesh.faceCount(); ++face)
                if (box.intersects(boxOf(ball.corners(face))))
                    met.push_back(static_cast<int>(face));
            CHECK(ball.facesIn(box) == met);
            all += met.size();
        }
        CHECK(all > 1000);
    }
}

TEST_CASE("A body in a bowl finds all faces that it can touch, and leaves out most in its box") {
    const double radius = 0.2, ballRadius = 0.03, reach = 0.001;
    const Surface bowl(icosphereMesh(radius, 5));
    const btSphereShape ball(ballRadius);
    std::mt19937 random(2);
    std::normal_distribution<double> anywhere;
    std::size_t found = 0, possible = 0;
    for (int place = 0; place < 100; ++place) {
        const Eigen::Vector3d centre =
            (radius - ballRadius) *
            Eigen::Vector3d(anywhere(random), anywhere(random), anywhere(random)).normalized();
        const SurfaceShape::NearBody near{
            .shape = &ball,
            .pose = btTransform(btQuaternion::getIdentity(), toBullet(centre)),
            .reachMetres = reach};
        const Box box(centre.array() - ballRadius - reach, centre.array() + ballRadius + reach);
        const auto inBox = bowl.facesIn(box);
        bowl.shape.searchFor(&near);
        const auto touchable = bowl.facesIn(box);
        bowl.shape.searchFor(nullptr);
        for (const int face : inBox) {
            const auto corners = bowl.corners(face);
            const bool isNear = ((corners.rowwise() - centre.transpose()).rowwise().norm().array() <
                                 ballRadius + reach)
                                    .any();
            if (isNear)
                CHECK(std::ranges::binary_search(touchable, face));
        }
        possible += inBox.size();
        found += touchable.size();
    }
    CHECK(found > 100);
    // Within reach lies a disc of 8.5 mm radius, in the box some 62 x 62 mm. The faces at the
    // disc's edge count, so that of edges of 6.6 mm a seventh of the faces is left.
    CHECK(5 * found < possible);
}
