// A scene made ready to move and to sound: everything is loaded that it names.
#pragma once

#include "Instrument/ObjectLibrary.h"
#include "Instrument/ObjectSurface.h"
#include "Scene/RigidBodyModel.h"
#include "Scene/RigidWorld.h"
#include "Scene/Scene.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// Immutable, so any number of performances share it.
class SceneCast {
public:
    struct Role {
        RigidWorld::Kind kind;
        std::string object; ///< the factory's name or a file's path; empty for a ball
        /// Of the object, not scaled; none of a ball, which is not heard.
        std::shared_ptr<const ObjectSurface> surface;
        Surface sound; ///< of what slides and rolls on it

        bool isHeard() const { return surface != nullptr; }
    };

    /// What stands in the scene from the start on.
    struct Standing {
        std::size_t role = 0;
        BodyMotion motion;
    };

    /// Loads what the scene names. The error names the kind, the object or the preset at fault.
    static Result<std::shared_ptr<const SceneCast>> make(Scene scene, ObjectLibrary& library);

    const Scene& scene() const { return played; }
    /// The scene's kinds in their order, then the keyboard's bars.
    const std::vector<Role>& roles() const { return allRoles; }
    const std::vector<Standing>& keyboard() const { return bars; }
    /// Where a note hits, if it does.
    const std::optional<Eigen::Vector3d>& target(int midiNote) const {
        return targets[static_cast<std::size_t>(midiNote & 127)];
    }
    SynthesiserSlot slotOf(std::size_t role) const;

private:
    explicit SceneCast(Scene scene) : played(std::move(scene)) {}

    /// Its object is `object`, by the name that it has there.
    Result<void> addRole(const BodyTemplate& kind,
                         const std::shared_ptr<const ModalObject>& object,
                         int group,
                         int collidesWith);
    Result<void> castKinds(ObjectLibrary& library);
    Result<void> castKeyboard(ObjectLibrary& library);

    Scene played;
    std::vector<Role> allRoles;
    std::vector<Standing> bars;
    std::array<std::optional<Eigen::Vector3d>, 128> targets;
};

} // namespace idiophone
