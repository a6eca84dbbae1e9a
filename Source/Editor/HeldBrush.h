// Paints where an object is held, and draws it over the picture: the painted places, and the held
// vertices of every object.
#pragma once

#include "Editor/ObjectScene.h"
#include "Editor/OrbitCamera.h"
#include "Editor/ProcessorView.h"
#include "Editor/ShownInstrument.h"

#include <Eigen/Geometry>
#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

/// For the message thread.
class HeldBrush {
public:
    /// How the mouse acts in the picture, in a sentence for the user.
    static constexpr const char* hint =
        "Drag over the object to hold it there, with Shift to let it go; drag beside it to turn, "
        "wheel to zoom";

    /// Takes the objects of the picture, unless they are on a stage. A stroke goes on, because the
    /// preview of the object may be replaced meanwhile.
    void show(const ProcessorView& view, const ShownInstrument& shown);

    /// Continues the stroke to a place: holds the object there, or frees what is held around.
    void drawTo(const ScenePick& pick, bool frees);
    bool isDrawing() const { return drawing; }
    /// Ends the stroke: the object is analysed again if it still plays and places hold it.
    void finishDrawing(ProcessorView& view);

    /// Covers the component.
    void paint(juce::Graphics& g,
               const juce::Component& component,
               const ObjectScene& scene,
               const OrbitCamera& camera) const;

private:
    void touch(const Eigen::Vector3d& place, bool frees);

    std::vector<ScenePlace> vertices; ///< held, of all objects; at most `maximumVertices`
    float wallMetres = 0;             ///< in the scene: the thickest wall of a shell that is held
    Eigen::Vector3d corner = Eigen::Vector3d::Zero(); ///< lowest, of the object's bounding box
    double longestMetres = 0;                         ///< its longest side; 0: nothing to hold
    double sceneScale = 1;                            ///< of the object in the scene
    std::vector<Eigen::Vector3d> places;              ///< as in `HeldSettings`
    Eigen::Vector3d last = Eigen::Vector3d::Zero();   ///< of the stroke
    bool drawing = false;
};

} // namespace idiophone
