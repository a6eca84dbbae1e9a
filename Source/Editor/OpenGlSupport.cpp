#include "Editor/OpenGlSupport.h"

#if defined(__linux__)
#include <GL/glx.h>
#include <X11/Xlib.h>
#endif

namespace idiophone {

#if defined(__linux__)

namespace {

bool displayHasOpenGl(Display* display) {
    int errorBase = 0, eventBase = 0;
    if (glXQueryExtension(display, &errorBase, &eventBase) == False)
        return false;
    // JUCE's minimum requirements.
    constexpr int wanted[]{GLX_RENDER_TYPE,
                           GLX_RGBA_BIT,
                           GLX_DOUBLEBUFFER,
                           True,
                           GLX_DRAWABLE_TYPE,
                           GLX_WINDOW_BIT,
                           GLX_DEPTH_SIZE,
                           24,
                           None};
    int count = 0;
    GLXFBConfig* const configurations =
        glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
    if (configurations != nullptr)
        XFree(configurations);
    return count > 0;
}

} // namespace

bool hasOpenGl() {
    static const bool has = [] {
        Display* const display = XOpenDisplay(nullptr);
        if (display == nullptr)
            return false;
        const bool found = displayHasOpenGl(display);
        XCloseDisplay(display);
        return found;
    }();
    return has;
}

#else

bool hasOpenGl() {
    return true;
}

#endif

} // namespace idiophone
