// The scene assets: a scene with every object and preset that it names loaded.
#pragma once

#include "Instrument/ObjectSource.h"
#include "Scene/RigidBodyModel.h"
#include "Scene/RigidWorld.h"
#include "Scene/Scene.h"
#include "Synth/Synthesiser.h"
#include "World/ObjectSurface.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// Immutable, so that any number of simulations share it.
class SceneAssets {
public:
    struct Role {
        RigidWorld::Kind kind;
        std::string object; ///< factory name or file path; empty for a ball
        /// The places on the object, not scaled. Null for a ball, which is not heard.
        std::shared_ptr<const ObjectSurface> surface;
        std::size_t surfaceIndex = 0; ///< in `surfaces`

        bool isHeard() const { return surface != nullptr; }
    };

    /// A body that is in the scene from the start.
    struct Standing {
        std::size_t role = 0;
        BodyMotion motion;
    };

    /// Loads the objects and presets of a scene. The error names the kind, object or preset at
    /// fault.
    static Result<std::shared_ptr<const SceneAssets>> make(Scene scene, ObjectSource& objects);

    const Scene& scene() const { return played; }
    /// Returns the scene's kinds in their order, then the keyboard's bars.
    const std::vector<Role>& roles() const { return allRoles; }
    /// Returns the different surfaces for sliding and rolling.
    const std::vector<Surface>& surfaces() const { return allSurfaces; }
    const std::vector<Standing>& keyboard() const { return bars; }
    /// Returns the place that a note hits, if it has one.
    const std::optional<Eigen::Vector3d>& target(int midiNote) const {
        return targets[static_cast<std::size_t>(midiNote & 127)];
    }
    SynthesiserSlot slotOf(std::size_t role) const;

private:
    explicit SceneAssets(Scene scene) : played(std::move(scene)) {}

    std::size_t indexOf(const Surface& surface);
    /// Adds a role whose object is `object`; `kind.object` is its name in the objects.
    Result<void> addRole(const BodyTemplate& kind,
                         const std::shared_ptr<const ModalObject>& object,
                         int group,
                         int collidesWith);
    Result<void> loadKinds(ObjectSource& objects);
    Result<void> loadKeyboard(ObjectSource& objects);

    Scene played;
    std::vector<Role> allRoles;
    std::vector<Surface> allSurfaces;
    std::vector<Standing> bars;
    std::array<std::optional<Eigen::Vector3d>, 128> targets;
};

} // namespace idiophone
