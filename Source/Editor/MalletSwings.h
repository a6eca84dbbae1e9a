// The mallets of the picture: each touches the struck place, rebounds and leaves.
#pragma once

#include "Editor/SceneFrame.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// For the message thread. Lengths in metres, in the scene.
class MalletSwings {
public:
    static constexpr double contactSeconds = 0.04; ///< so that one frame shows the contact
    static constexpr double swingSeconds = 1.0;    ///< from the contact to the mallet's end
    static constexpr std::size_t maximumMallets = 6;

    /// Swings a mallet to a place of a surface with that unit normal. `strength` is from 0 to 1. A
    /// mallet that is back from an earlier strike is taken again.
    void strike(const ScenePlace& place, const ScenePlace& normal, float strength);
    void advance(double seconds);
    void reset() { swings.clear(); }
    bool moves() const { return !swings.empty(); }

    /// The mallets now, with heads and sticks of that size.
    std::vector<DrawnMallet> mallets(float headMetres, float stickMetres) const;

private:
    struct Swing {
        Eigen::Vector3f place, normal;
        float strength = 0;
        float side = 1; ///< the player's hand: −1 left, 1 right
        double age = 0; ///< seconds since the contact
    };

    std::vector<Swing> swings; ///< oldest first
    float nextSide = 1;
};

} // namespace idiophone
