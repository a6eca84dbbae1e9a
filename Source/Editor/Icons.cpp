#include "Editor/Icons.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone::icons {
namespace {

/// Returns the outline of lines, for filling.
juce::Path drawn(const juce::Path& lines) {
    constexpr float lineWidth = 0.1f;
    juce::Path outline;
    juce::PathStrokeType(lineWidth, juce::PathStrokeType::curved, juce::PathStrokeType::rounded)
        .createStrokedPath(outline, lines);
    return outline;
}

/// The lines are in SVG's notation.
juce::Path drawn(const char* lines) {
    return drawn(juce::Drawable::parseSVGPath(lines));
}

juce::Path mirrored(juce::Path path) {
    path.applyTransform(juce::AffineTransform::scale(-1, 1).translated(1, 0));
    return path;
}

} // namespace

juce::Path previous() {
    return drawn("M.62 .2 L.34 .5 L.62 .8");
}

juce::Path next() {
    return mirrored(previous());
}

juce::Path star() {
    juce::Path path;
    path.addStar({0.5f, 0.53f}, 5, 0.22f, 0.5f);
    return path;
}

juce::Path starOutline() {
    juce::Path lines;
    lines.addStar({0.5f, 0.53f}, 5, 0.2f, 0.45f);
    return drawn(lines);
}

juce::Path save() { // an arrow into a tray
    return drawn("M.5 .1 L.5 .62 M.28 .42 L.5 .64 L.72 .42 "
                 "M.12 .66 L.12 .88 L.88 .88 L.88 .66");
}

juce::Path dice() {
    juce::Path square;
    square.addRoundedRectangle(0.12f, 0.12f, 0.76f, 0.76f, 0.16f);
    auto path = drawn(square);
    for (const auto& [x, y] :
         {std::pair(0.32f, 0.32f), {0.68f, 0.32f}, {0.5f, 0.5f}, {0.32f, 0.68f}, {0.68f, 0.68f}})
        path.addEllipse(juce::Rectangle<float>(0.15f, 0.15f).withCentre({x, y}));
    return path;
}

juce::Path undo() {
    return drawn("M.34 .16 L.12 .36 L.34 .56 M.14 .36 L.6 .36 C.95 .36 .95 .84 .6 .84 L.34 .84");
}

juce::Path redo() {
    return mirrored(undo());
}

juce::Path silence() { // a stop sign
    juce::Path octagon;
    octagon.addPolygon({0.5f, 0.5f}, 8, 0.46f, juce::MathConstants<float>::pi / 8);
    juce::Path square;
    square.addRoundedRectangle(0.33f, 0.33f, 0.34f, 0.34f, 0.05f);
    auto path = drawn(octagon);
    path.addPath(square);
    return path;
}

juce::Path soundFile() { // a wave, and an arrow that takes it out
    return drawn("M.1 .5 L.1 .62 M.27 .3 L.27 .82 M.44 .14 L.44 .98 M.61 .62 L.61 .82 "
                 "M.58 .36 L.92 .36 M.76 .18 L.94 .36 L.76 .54");
}

juce::Path record() {
    juce::Path ring;
    ring.addEllipse(0.1f, 0.1f, 0.8f, 0.8f);
    auto path = drawn(ring);
    path.addEllipse(0.28f, 0.28f, 0.44f, 0.44f);
    return path;
}

juce::Path samples() { // keys, and an arrow that takes them out
    return drawn("M.46 .3 L.1 .3 L.1 .9 L.78 .9 L.78 .64 M.33 .62 L.33 .88 M.55 .62 L.55 .88 "
                 "M.58 .36 L.92 .36 M.76 .18 L.94 .36 L.76 .54");
}

juce::Path frame() { // corners around a dot
    auto path = drawn("M.34 .12 L.12 .12 L.12 .34 M.66 .12 L.88 .12 L.88 .34 "
                      "M.34 .88 L.12 .88 L.12 .66 M.66 .88 L.88 .88 L.88 .66");
    path.addEllipse(0.38f, 0.38f, 0.24f, 0.24f);
    return path;
}

juce::Path folder() {
    return drawn("M.1 .8 L.1 .2 L.4 .2 L.5 .32 L.9 .32 L.9 .8 Z");
}

juce::Path sheet() { // with a folded corner
    return drawn("M.2 .08 L.6 .08 L.8 .28 L.8 .92 L.2 .92 Z M.6 .08 L.6 .28 L.8 .28");
}

juce::Path close() {
    return drawn("M.24 .24 L.76 .76 M.76 .24 L.24 .76");
}

juce::Path minimise() {
    return drawn("M.22 .5 L.78 .5");
}

juce::Path copy() { // a sheet before another
    auto lines = juce::Drawable::parseSVGPath("M.22 .66 L.12 .66 L.12 .12 L.66 .12 L.66 .22");
    lines.addRoundedRectangle(0.34f, 0.34f, 0.54f, 0.54f, 0.08f);
    return drawn(lines);
}

} // namespace idiophone::icons
