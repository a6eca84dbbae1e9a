// The objects of an instrument in space, to be drawn and picked: several laid out as a keyboard,
// one as it is, and those on a stage where their bodies are. It knows neither windows nor OpenGL.
#pragma once

#include "Editor/ProcessorView.h"
#include "Geometry/SurfaceQuery.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// In metres of the scene, where x goes right, y away from the player, z up.
using ScenePlace = std::array<float, 3>;

struct SceneVertex {
    ScenePlace place;
    std::array<float, 3> normal; ///< unit, or zero
};

/// A run of vertices, three a face.
struct SceneObject {
    std::size_t firstVertex = 0;
    std::size_t vertexCount = 0;
    std::array<float, 3> colour{}; ///< red, green, blue; 0 to 1
    float radius = 0;              ///< half of the way across it
    bool isBox = false;            ///< drawn in the place of more faces than are drawn
};

struct ScenePick {
    std::size_t object = 0;              ///< index into the played objects
    std::array<double, 3> pointMetres{}; ///< on the object's own mesh
    ScenePlace place{};
    double towardsPlayer = 0; ///< 0 at the object's far end, 1 at its near end
};

/// Immutable once built, which takes a while for large meshes.
class ObjectScene {
public:
    /// Of all objects. Each takes some 450 bytes, and together a few seconds; objects beyond are
    /// boxes.
    static constexpr Eigen::Index mostFaces = 1'000'000;

    enum class Layout {
        keyboard, ///< or one alone
        stage     ///< each in its own coordinates, in its size: bodies say where it is
    };

    explicit ObjectScene(const std::vector<ProcessorView::PlayedObject>& played,
                         Layout layout = Layout::keyboard);

    std::span<const SceneVertex> vertices() const { return corners; }
    std::span<const SceneObject> objects() const { return runs; }
    bool empty() const { return corners.empty(); }

    /// The corners of the boxes that hold each object, eight each: all there is lies between them.
    const std::vector<ScenePlace>& outline() const { return boxCorners; }
    /// The same of bodies on a stage.
    std::vector<ScenePlace> outline(std::span<const BodyNow> bodies) const;
    /// Half of the way across everything; 0 for an empty scene.
    float radius() const { return reach; }

    /// A place in metres of an object's own mesh, in the scene. The object exists.
    ScenePlace placeOf(std::size_t object, const std::array<double, 3>& pointMetres) const;

    /// For each of an object's vertices here, how far it is moved where every vertex of its own
    /// mesh is moved so, [N,3] in the directions and units of the mesh.
    std::vector<ScenePlace> offsetsOf(std::size_t object,
                                      std::span<const float> displacements) const;

    /// What a ray meets first.
    std::optional<ScenePick> pick(const ScenePlace& origin, const ScenePlace& direction) const;
    /// The same of bodies on a stage.
    std::optional<ScenePick> pick(const ScenePlace& origin,
                                  const ScenePlace& direction,
                                  std::span<const BodyNow> bodies) const;

private:
    /// scene = origin + axes · (own − pivot) · scale.
    struct Placement {
        Eigen::Vector3d inScene(const Eigen::Vector3d& own) const;
        Eigen::Vector3d onMesh(const Eigen::Vector3d& place) const; ///< back again

        Eigen::Vector3d pivot = Eigen::Vector3d::Zero(), origin = Eigen::Vector3d::Zero();
        Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< own x, y, z as columns
        double scale = 1;
        double nearest = 0, farthest = 0; ///< y in the scene
    };

    static std::vector<Placement>
    keyboardOf(const std::vector<ProcessorView::PlayedObject>& played);

    void addFaces(const ModalObject& object, const Mesh& mesh, const Placement& placement);
    void addBox(SceneObject& run);
    SurfaceQuery surfaceOf(std::size_t firstVertex, std::size_t vertexCount) const;

    std::vector<SceneVertex> corners;
    std::vector<SceneObject> runs;
    std::vector<Placement> placements;
    std::vector<std::int32_t> ownVertices; ///< of each corner, in its object's own mesh; −1: none
    std::vector<std::size_t> objectOfFace;
    std::vector<ScenePlace> boxCorners;
    std::vector<std::size_t> firstBoxCorners; ///< of the objects; those without faces have none
    std::optional<SurfaceQuery> surface;      ///< all faces, but of a stage
    std::vector<SurfaceQuery> surfaces;       ///< of a stage's objects
    float reach = 0;
};

} // namespace idiophone
