// SPDX-License-Identifier: Apache-2.0
#include "Gltf/RigidBodies.h"

#include "Gltf/GltfValue.h"
#include "Gltf/PrincipalInertia.h"
#include "Gltf/TinyGltf.h"

#include <algorithm>
#include <map>

namespace idiophone {
namespace {

constexpr const char* extensionName = "KHR_physics_rigid_bodies";
constexpr double largest = 1e9; ///< of any size, mass or speed

Eigen::Vector3d vectorOf(const GltfValue& value) {
    const auto numbers = value.numbers<3>({0, 0, 0});
    return {numbers[0], numbers[1], numbers[2]};
}

class Reader {
public:
    Reader(const GltfDocument& document, const AudioRigidBodies& audio)
        : document_(document), audio_(audio),
          physics_(GltfValue::extension(document, extensionName)),
          shapes_(GltfValue::extension(document, "KHR_implicit_shapes")["shapes"]) {}

    GltfRigidBodies read() {
        for (std::size_t place = 0; place < document_.nodes().size(); ++place) {
            const auto node = physicsOf(place);
            if (node["motion"].exists())
                addBody(place, node["motion"]);
            if (node["collider"].exists())
                addCollider(place, node["collider"]);
            isLeftOut_ = isLeftOut_ || node["joint"].exists() || node["trigger"].exists();
        }
        finish();
        return std::move(result_);
    }

private:
    GltfValue physicsOf(std::size_t place) const {
        const auto number = static_cast<std::size_t>(document_.nodes()[place].node);
        return GltfValue::extensionOfNode(document_, number, extensionName);
    }

    const GltfAudioNode& audioOf(std::size_t place) const {
        return audio_.nodes[static_cast<std::size_t>(document_.nodes()[place].node)];
    }

    /// Returns the nearest of a place and its ancestors for which `isIt` holds.
    template <class IsIt>
    std::optional<std::size_t> nearest(std::size_t place, IsIt isIt) const {
        for (int at = static_cast<int>(place); at >= 0;
             at = document_.nodes()[static_cast<std::size_t>(at)].parent)
            if (isIt(static_cast<std::size_t>(at)))
                return static_cast<std::size_t>(at);
        return {};
    }

    void addBody(std::size_t place, const GltfValue& motion) {
        GltfRigidBody body{.place = place};
        body.isFixed = motion["isKinematic"].flag(false);
        // The extension writes 0 for infinity.
        const double mass = motion["mass"].number(0, 0, largest);
        body.isFixed = body.isFixed || (motion["mass"].exists() && mass == 0);
        if (mass > 0)
            body.mass = MassProperties{
                .massKg = mass,
                .centreMetres = motion["centerOfMass"].numbers<3>({0, 0, 0}),
                .inertiaKgM2 = inertiaMatrix(
                    {.diagonalKgM2 = motion["inertiaDiagonal"].numbers<3>({0, 0, 0}),
                     .orientation = motion["inertiaOrientation"].numbers<4>({0, 0, 0, 1})})};
        body.velocityMetresPerSecond = vectorOf(motion["linearVelocity"]);
        body.spinRadiansPerSecond = vectorOf(motion["angularVelocity"]);
        isLeftOut_ = isLeftOut_ || motion["gravityFactor"].number(1, -largest, largest) != 1;
        bodyAt_[place] = result_.bodies.size();
        result_.bodies.push_back(std::move(body));
    }

    void addCollider(std::size_t place, const GltfValue& collider) {
        const auto geometry = collider["geometry"];
        GltfCollider read{.place = place, .isConvexHull = geometry["convexHull"].flag(false)};
        const auto& model = document_.model();
        if (geometry["shape"].exists()) {
            const auto shape = shapes_[geometry["shape"].index(shapes_.size())];
            if (!readShape(read, shape)) {
                isLeftOut_ = true;
                return;
            }
        } else {
            read.form = GltfCollider::Form::mesh;
            read.meshNode = static_cast<int>(geometry["node"].index(model.nodes.size()));
        }
        const auto moving = nearest(place, [&](std::size_t at) { return bodyAt_.contains(at); });
        if (!moving)
            result_.bodies.push_back({.place = place, .isFixed = true});
        auto& body = moving ? result_.bodies[bodyAt_[*moving]] : result_.bodies.back();
        body.colliders.push_back(read);
        readMaterial(body, collider["physicsMaterial"]);
        addSound(body, place);
    }

    /// Returns false for a shape that is unknown.
    static bool readShape(GltfCollider& collider, const GltfValue& shape) {
        using Form = GltfCollider::Form;
        constexpr double least = 1e-9;
        const auto type = shape["type"].text();
        const auto own = shape[type.c_str()];
        if (type == "box") {
            const auto sizes = own["size"].numbers<3>({1, 1, 1});
            collider.form = Form::box;
            collider.sizesMetres = {sizes[0], sizes[1], sizes[2]};
        } else if (type == "plane") {
            collider.form = Form::plane;
            collider.sizesMetres = {1, 0, 1};
            return true;
        } else if (type == "sphere") {
            collider.form = Form::sphere;
            collider.sizesMetres.setConstant(2 * own["radius"].number(0.5, least, largest));
        } else if (type == "cylinder" || type == "capsule") {
            const double top = own["radiusTop"].number(0.25, 0, largest);
            const double bottom = own["radiusBottom"].number(0.25, 0, largest);
            const double greater = std::max({top, bottom, least});
            const bool isCapsule = type == "capsule";
            collider.form = isCapsule ? Form::capsule : Form::cylinder;
            collider.sizesMetres = {
                2 * greater, own["height"].number(0.5, 0, largest) + (isCapsule ? top + bottom : 0),
                2 * greater};
            collider.topRatio = top / greater;
            collider.bottomRatio = bottom / greater;
        } else {
            return false;
        }
        if (!(collider.sizesMetres.minCoeff() >= least))
            shape.fail("has no size");
        return true;
    }

    void readMaterial(GltfRigidBody& body, const GltfValue& index) const {
        const auto materials = physics_["physicsMaterials"];
        if (!index.exists() || body.friction)
            return;
        const auto material = materials[index.index(materials.size())];
        body.friction = std::min(material["dynamicFriction"].number(0.6, 0, largest), 10.0);
        body.restitution = material["restitution"].number(0, 0, 1);
    }

    void addSound(GltfRigidBody& body, std::size_t place) const {
        if (!body.soundPlace)
            body.soundPlace =
                nearest(place, [&](std::size_t at) { return audioOf(at).model.has_value(); });
        if (!body.finishPlace)
            body.finishPlace =
                nearest(place, [&](std::size_t at) { return audioOf(at).surface.has_value(); });
    }

    void finish() {
        std::erase_if(result_.bodies, [](const auto& body) { return body.colliders.empty(); });
        if (isLeftOut_)
            result_.notes = "Joints, triggers, unknown shapes and the gravity of single bodies are "
                            "left out.";
    }

    const GltfDocument& document_;
    const AudioRigidBodies& audio_;
    GltfValue physics_, shapes_;
    GltfRigidBodies result_;
    std::map<std::size_t, std::size_t> bodyAt_; ///< with a motion, by the place of their nodes
    bool isLeftOut_ = false;
};

} // namespace

bool hasRigidBodies(const GltfDocument& document) {
    return std::ranges::find(document.model().extensionsUsed, extensionName) !=
           document.model().extensionsUsed.end();
}

Result<GltfRigidBodies> rigidBodies(const GltfDocument& document, const AudioRigidBodies& audio) {
    try {
        return Reader(document, audio).read();
    } catch (const GltfValue::Fault& fault) {
        return failure(fault.sentence);
    }
}

} // namespace idiophone
