#include "Scene/GltfScene.h"

#include "Gltf/GltfFile.h"
#include "Gltf/GltfObject.h"
#include "Gltf/RigidBodies.h"
#include "Object/ByteOrderMark.h"
#include "Object/FileBytes.h"
#include "Object/OneLine.h"
#include "Scene/GltfColliders.h"
#include "Scene/SilentBody.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr std::uintmax_t largestFileBytes = std::uintmax_t{2} << 30;

/// Returns how an acoustic surface sounds when something slides or rolls on it.
Surface soundOf(const GltfAcousticSurface& finish) {
    // Asperities pass at the speed over their spacing. The draft's exponent is that of the heights,
    // ours that of van den Doel, Kry & Pai for the same fractal dimension.
    const double asperitiesHz = 1 / finish.correlationLengthMetres; // at 1 m/s
    Surface surface{.name = oneLine(finish.name),
                    .spectrumExponent = finish.spectralSlope + 1,
                    .resonFrequencyHz = asperitiesHz,
                    .resonDampingPerSecond = 2 * asperitiesHz,
                    .slowestSpeedMetresPerSecond = 0.005,
                    .roughness = roughnessOf(finish)};
    return heldToRanges(std::move(surface));
}

/// All that makes one body's object and behaviour another than the next one's.
struct BodyKey {
    std::optional<std::size_t> model = {}, surface = {}, finish = {};
    double gain = 1, scale = 1;
    MassProperties mass;
    bool isFixed = false;
    BodyForm form = BodyForm::hull;
    std::optional<double> friction, restitution;
    ColliderSurface colliders = {};

    bool operator==(const BodyKey&) const = default;
};

class SceneBuilder {
public:
    SceneBuilder(const GltfDocument& document,
                 const AudioRigidBodies& audio,
                 const std::vector<GltfPart>& meshes)
        : document_(document), audio_(audio), meshes_(meshes) {}

    /// The error is the end of a sentence.
    Result<void> add(const GltfRigidBody& body) {
        // A body's mesh is in the space of the node that sounds, so that strikes find its points.
        auto pose = placedPose(document_.nodes()[body.soundPlace.value_or(body.place)].transform);
        const auto form = formOf(body);
        if (form == BodyForm::ground) // everything below the mesh's z
            pose.worldFromBody.linear() *= zUpFromYUp().transpose();
        auto colliders = surfaceOf(document_, meshes_, body, pose, pointsLeft_);
        if (!colliders)
            return failure("its colliders have too many faces together");
        BodyKey key{.gain = 1,
                    .scale = pose.scale,
                    .mass = massIn(pose, body),
                    .isFixed = body.isFixed,
                    .form = form,
                    .friction = body.friction,
                    .restitution = body.restitution,
                    .colliders = *std::move(colliders)};
        if (key.colliders.points.empty())
            return {}; // its mesh is not in the scene
        if (body.soundPlace) {
            const auto& audio = audioAt(*body.soundPlace);
            key.model = audio.model;
            key.surface = audio.surface;
            key.gain = audio.gain;
        }
        if (body.finishPlace)
            key.finish = audioAt(*body.finishPlace).surface;
        auto known = std::ranges::find(keys_, key);
        if (known == keys_.end()) {
            if (const auto added = addKind(key); !added)
                return added;
            known = keys_.insert(keys_.end(), std::move(key));
        }
        Release release;
        release.kind = static_cast<std::size_t>(known - keys_.begin());
        place(release, body, pose, *scene_.kinds[release.kind].given);
        scene_.releases.push_back(release);
        return {};
    }

    Scene finish(std::string name, std::string description) {
        scene_.name = std::move(name);
        scene_.description = std::move(description);
        scene_.seconds = 5;
        scene_.parameters.set(ParameterId::radiation, 100); // the draft's signal is a pressure
        scene_.parameters.set(ParameterId::level, -30);     // full scale is 124 dB SPL
        scene_.listener = listener();
        return std::move(scene_);
    }

private:
    const GltfAudioNode& audioAt(std::size_t place) const {
        return audio_.nodes[static_cast<std::size_t>(document_.nodes()[place].node)];
    }

    /// Returns the mass in the coordinates of the body's object; none if the file has none.
    MassProperties massIn(const PlacedPose& object, const GltfRigidBody& body) const {
        if (!body.mass)
            return {};
        auto mass = *body.mass;
        Eigen::Map<Eigen::Vector3d> centre(mass.centreMetres.data());
        if (body.soundPlace.value_or(body.place) == body.place) {
            centre *= object.scale;
            return mass;
        }
        const auto& own = document_.nodes()[body.place].transform;
        const Eigen::Isometry3d objectFromWorld = object.worldFromBody.inverse();
        const Eigen::Matrix3d turn =
            objectFromWorld.linear() * placedPose(own).worldFromBody.linear();
        centre = (objectFromWorld * (zUpFromYUp() * (own * Eigen::Vector3d(centre)))).eval();
        Eigen::Map<Eigen::Matrix3d> inertia(mass.inertiaKgM2.data());
        inertia = (turn * inertia * turn.transpose()).eval();
        return mass;
    }

    Result<void> addKind(const BodyKey& key) {
        const auto object = objectFor(key);
        if (!object)
            return failure(object.error().message);
        BodyTemplate kind{.name = std::to_string(keys_.size() + 1) + " " + oneLine((*object)->name),
                          .object = {},
                          .given = *object,
                          .form = key.form,
                          .isFixed = key.isFixed,
                          .friction = key.friction,
                          .restitution = key.restitution};
        if (key.finish)
            kind.surface = soundOf(audio_.surfaces[*key.finish]);
        scene_.kinds.push_back(std::move(kind));
        return {};
    }

    Result<std::shared_ptr<const ModalObject>> objectFor(const BodyKey& key) const {
        Eigen::AlignedBox3d box;
        for (const auto& point : key.colliders.points)
            box.extend(point);
        if (!key.model) {
            GltfAcousticMaterial material;
            if (key.finish && audio_.surfaces[*key.finish].material)
                material = audio_.materials[*audio_.surfaces[*key.finish].material];
            return silentBody(key.colliders.points, key.colliders.faces, materialOf(material),
                              key.mass);
        }
        GltfInstance instance{.surface = key.surface,
                              .gain = key.gain,
                              .scale = key.scale,
                              .isRetuned = isRetuned(audio_.models[*key.model], key)};
        if (key.mass.massKg > 0)
            instance.mass = key.mass;
        return objectOf(document_, audio_, *key.model, instance).map([&](ModalObject&& object) {
            object.mass = withInertia(object.mass, box);
            return std::make_shared<const ModalObject>(std::move(object));
        });
    }

    /// The draft says that a model describes the body as it is placed. Its samples place one model
    /// at several scales, and their masses say that it describes the body at scale 1.
    static bool isRetuned(const GltfModalModel& model, const BodyKey& key) {
        constexpr double tolerance = 0.01;
        return model.mass &&
               std::abs(key.mass.massKg / (model.mass->massKg * std::pow(key.scale, 3)) - 1) <
                   tolerance;
    }

    static BodyForm formOf(const GltfRigidBody& body) {
        using Form = GltfCollider::Form;
        const auto form = body.colliders.front().form;
        if (body.colliders.size() > 1)
            return BodyForm::hull;
        if (form == Form::plane && body.isFixed && !body.soundPlace)
            return BodyForm::ground;
        if (form == Form::mesh && body.isFixed && !body.soundPlace &&
            !body.colliders.front().isConvexHull)
            return BodyForm::mesh;
        return form == Form::sphere ? BodyForm::sphere : BodyForm::hull;
    }

    static void place(Release& release,
                      const GltfRigidBody& body,
                      const PlacedPose& pose,
                      const ModalObject& object) {
        const Eigen::Vector3d centre =
            Eigen::Map<const Eigen::Vector3d>(object.mass.centreMetres.data());
        release.positionMetres.mean = body.isFixed ? pose.worldFromBody.translation()
                                                   : Eigen::Vector3d(pose.worldFromBody * centre);
        const Eigen::AngleAxisd turn(pose.worldFromBody.linear());
        release.turnedDegrees.mean = turn.angle() * 180 / std::numbers::pi * turn.axis();
        release.velocityMetresPerSecond.mean =
            pose.worldFromBody.linear() * body.velocityMetresPerSecond;
        release.spinTurnsPerSecond.mean =
            pose.worldFromBody.linear() * body.spinRadiansPerSecond / (2 * std::numbers::pi);
    }

    /// Returns the file's camera, or someone who stands before the bodies and sees them all.
    Listener listener() const {
        for (const auto& placed : document_.nodes())
            if (placed.isCamera) {
                const Eigen::Affine3d camera = zUpFromYUp() * placed.transform;
                return {.positionMetres = camera.translation(),
                        .towardsMetres = camera * Eigen::Vector3d(0, 0, -1)};
            }
        Eigen::AlignedBox3d box;
        for (const auto& release : scene_.releases)
            if (!scene_.kinds[release.kind].isFixed)
                box.extend(release.positionMetres.mean);
        if (box.isEmpty())
            return {};
        const double distance = 1 + box.diagonal().norm();
        return {.positionMetres = box.center() + distance * Eigen::Vector3d(0, -0.8, 0.6),
                .towardsMetres = box.center()};
    }

    const GltfDocument& document_;
    const AudioRigidBodies& audio_;
    const std::vector<GltfPart>& meshes_;
    Scene scene_;
    std::vector<BodyKey> keys_; ///< of the scene's kinds
    std::size_t pointsLeft_ = std::size_t{1} << 24;
};

bool hasMeshColliders(const GltfRigidBodies& physics) {
    return std::ranges::any_of(physics.bodies, [](const auto& body) {
        return std::ranges::any_of(body.colliders, [](const auto& collider) {
            return collider.form == GltfCollider::Form::mesh;
        });
    });
}

/// The error is the end of a sentence.
Result<Scene> sceneOf(const GltfDocument& document, const std::string& name) {
    const auto audio = audioRigidBodies(document);
    if (!audio)
        return failure(audio.error().message);
    const auto physics = rigidBodies(document, *audio);
    if (!physics)
        return failure(physics.error().message);
    if (physics->bodies.empty())
        return failure("it has no rigid bodies (KHR_physics_rigid_bodies)");
    const auto meshes = hasMeshColliders(*physics) ? meshesOf(document) : GltfMeshes{};
    if (!meshes)
        return failure(meshes.error().message);
    if (physics->bodies.size() > std::size_t{maximumSceneBodies})
        return failure("it has more than " + std::to_string(maximumSceneBodies) + " bodies");
    SceneBuilder builder(document, *audio, meshes->parts);
    for (const auto& body : physics->bodies)
        if (const auto added = builder.add(body); !added)
            return failure(added.error().message);
    return builder.finish(name, physics->notes);
}

} // namespace

Result<Scene> gltfScene(std::string_view bytes, const std::filesystem::path& file) {
    return GltfDocument::parse(withoutByteOrderMark(bytes), buffersIn(file.parent_path()))
        .and_then([&](const GltfDocument& document) {
            return sceneOf(document, shownName(nameOf(file.stem())));
        })
        .map_error(
            [&](const Error& error) { return Error{shownNameOf(file) + ": " + error.message}; });
}

Result<Scene> readGltfScene(const std::filesystem::path& file) {
    const auto bytes = readBytes(file, largestFileBytes);
    if (!bytes)
        return failure(shownNameOf(file) + ": " + bytes.error().message);
    try {
        return gltfScene(*bytes, file);
    } catch (const std::bad_alloc&) {
        return failure(shownNameOf(file) + ": it is too large for this machine's memory");
    }
}

} // namespace idiophone
