// The images that the picture is drawn into: a multisampled one, and the lamp's depth map.
#pragma once

#include <juce_opengl/juce_opengl.h>

namespace idiophone {

/// A multisampled image, independent of what the window's own surface offers. OpenGL thread.
class MultisampledImage {
public:
    /// Begins drawing into the image of that size in pixels. If the driver refuses samples, there
    /// is one a pixel. Returns false if it refuses that too; the target is then unchanged.
    bool begin(int width, int height);
    /// Copies the image to the target that was bound before, and binds that again.
    void finish();
    void release();

private:
    void create(int samples);

    juce::uint32 frame = 0, colour = 0, depth = 0;
    int width = 0, height = 0;
    int former = 0; ///< the target bound before
};

/// The distances from the lamp, for shadows. OpenGL thread.
class ShadowMap {
public:
    static constexpr int size = 1280; ///< texels along each side

    /// Begins drawing depths. Returns false if the driver refuses the map.
    bool begin();
    void finish() const;
    void bindTexture() const;
    void release();

private:
    juce::uint32 frame = 0, texture = 0;
    int former = 0;
};

} // namespace idiophone
