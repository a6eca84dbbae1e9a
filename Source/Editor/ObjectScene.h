// The geometry of an instrument's objects, for drawing and picking. Several objects form a
// keyboard or stand on a shelf, a single object is shown alone, and objects on a stage follow their
// bodies. Independent of windows and OpenGL.
#pragma once

#include "Editor/DrawingMesh.h"
#include "Editor/ProcessorView.h"
#include "Editor/SceneObject.h"
#include "Mesh/SurfaceQuery.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// From the object's coordinates, scaled to its size, to the stage.
inline Eigen::Isometry3f poseOf(const BodyNow& body) {
    return Eigen::Translation3f(Eigen::Vector3f(body.originMetres.data())) *
           Eigen::Quaternionf(body.turn.data());
}

struct ScenePick {
    std::size_t object = 0;              ///< index into the played objects
    std::array<double, 3> pointMetres{}; ///< on the object's own mesh
    ScenePlace place{};
    ScenePlace normal{};           ///< unit normal of the surface in the scene
    double towardsPlayer = 0;      ///< 0 at the object's far end, 1 at its near end
    std::optional<BodyNow> body{}; ///< on a stage
};

/// Immutable. Construction takes a while for large meshes.
class ObjectScene {
public:
    /// Limit on the faces of all objects together; objects beyond it are drawn as boxes. A face
    /// takes about 450 bytes, and the maximum takes a few seconds to build.
    static constexpr std::size_t maximumFaces = 1'000'000;

    enum class Layout {
        keyboard, ///< several objects, as a keyboard or on a shelf, or a single one
        stage     ///< each object in its own coordinates and size; bodies place them
    };

    explicit ObjectScene(const std::vector<InstrumentView::PlayedObject>& played,
                         Layout layout = Layout::keyboard);

    std::span<const SceneVertex> vertices() const { return corners; }
    std::span<const SceneObject> objects() const { return runs; }
    bool empty() const { return corners.empty(); }

    /// The corners of the objects' bounding boxes, eight each.
    const std::vector<ScenePlace>& outline() const { return boxCorners; }
    /// The corners of the bounding boxes of bodies on a stage, eight each.
    std::vector<ScenePlace> outline(std::span<const BodyNow> bodies) const;
    /// Half the diagonal of the scene in metres; 0 if it is empty.
    float radius() const { return reach; }

    /// Converts a point of an object's mesh, in metres, to the scene. The object must exist.
    ScenePlace placeOf(std::size_t object, const std::array<double, 3>& pointMetres) const;

    /// Whether several objects of mixed forms stand on the floor (ObjectShelf.h).
    bool isShelf() const { return onShelf; }
    /// Whether the object stands in the second row of a keyboard, that of the accidentals.
    bool isBehind(std::size_t object) const { return placements[object].isBehind; }

    /// The unit normal of the surface nearest to a place of the scene; upward on a stage.
    ScenePlace normalAt(const ScenePlace& place) const;

    /// The displacement of each scene vertex of an object. `displacements` is [N,3], one for each
    /// vertex of the mesh, in the mesh's directions and units.
    std::vector<ScenePlace> offsetsOf(std::size_t object,
                                      std::span<const float> displacements) const;

    /// The first hit of a ray.
    std::optional<ScenePick> pick(const ScenePlace& origin, const ScenePlace& direction) const;
    /// The first hit of a ray among bodies on a stage.
    std::optional<ScenePick> pick(const ScenePlace& origin,
                                  const ScenePlace& direction,
                                  std::span<const BodyNow> bodies) const;

private:
    /// scene = origin + axes · (own − pivot) · scale.
    struct Placement {
        Eigen::Vector3d inScene(const Eigen::Vector3d& own) const;
        Eigen::Vector3d onMesh(const Eigen::Vector3d& place) const; ///< the inverse

        Eigen::Vector3d pivot = Eigen::Vector3d::Zero(), origin = Eigen::Vector3d::Zero();
        Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< object axes as columns
        double scale = 1;
        double nearest = 0, farthest = 0; ///< range of y in the scene
        bool isBehind = false;
    };

    static std::vector<Placement>
    keyboardOf(const std::vector<InstrumentView::PlayedObject>& played);
    /// Empty if the objects form a keyboard.
    static std::vector<Placement> shelfOf(const std::vector<InstrumentView::PlayedObject>& played);

    void addFaces(const DrawingMesh& mesh, const Placement& placement);
    void addBox(SceneObject& run);
    ScenePick pickOf(std::size_t object, const SurfacePoint& hit) const;
    SurfaceQuery surfaceOf(std::size_t firstVertex, std::size_t vertexCount) const;

    std::vector<SceneVertex> corners;
    std::vector<SceneObject> runs;
    std::vector<Placement> placements;
    std::vector<MeshPlace> meshPlaces; ///< of each corner on its object's mesh
    std::vector<std::size_t> objectOfFace;
    std::vector<ScenePlace> boxCorners;
    std::vector<std::size_t> firstBoxCorners; ///< per object; objects without faces have no corners
    std::optional<SurfaceQuery> surface;      ///< all faces; empty on a stage
    std::vector<SurfaceQuery> surfaces;       ///< one per object, only on a stage
    float reach = 0;
    bool onShelf = false;
};

} // namespace idiophone
