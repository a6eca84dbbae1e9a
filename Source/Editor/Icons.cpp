#include "Editor/Icons.h"

namespace idiophone::icons {
namespace {

constexpr float lineWidth = 0.1f;

/// Returns the outline of lines, for filling.
juce::Path drawn(const juce::Path& lines) {
    juce::Path outline;
    juce::PathStrokeType(lineWidth, juce::PathStrokeType::curved, juce::PathStrokeType::rounded)
        .createStrokedPath(outline, lines);
    return outline;
}

juce::Path mirrored(juce::Path path) {
    path.applyTransform(juce::AffineTransform::scale(-1, 1).translated(1, 0));
    return path;
}

} // namespace

juce::Path previous() {
    juce::Path lines;
    lines.startNewSubPath(0.62f, 0.2f);
    lines.lineTo(0.34f, 0.5f);
    lines.lineTo(0.62f, 0.8f);
    return drawn(lines);
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
    juce::Path lines;
    lines.startNewSubPath(0.5f, 0.1f);
    lines.lineTo(0.5f, 0.62f);
    lines.startNewSubPath(0.28f, 0.42f);
    lines.lineTo(0.5f, 0.64f);
    lines.lineTo(0.72f, 0.42f);
    lines.startNewSubPath(0.12f, 0.66f);
    lines.lineTo(0.12f, 0.88f);
    lines.lineTo(0.88f, 0.88f);
    lines.lineTo(0.88f, 0.66f);
    return drawn(lines);
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
    juce::Path lines;
    lines.startNewSubPath(0.34f, 0.16f);
    lines.lineTo(0.12f, 0.36f);
    lines.lineTo(0.34f, 0.56f);
    lines.startNewSubPath(0.14f, 0.36f);
    lines.lineTo(0.6f, 0.36f);
    lines.cubicTo(0.95f, 0.36f, 0.95f, 0.84f, 0.6f, 0.84f);
    lines.lineTo(0.34f, 0.84f);
    return drawn(lines);
}

juce::Path redo() {
    return mirrored(undo());
}

juce::Path copy() { // a sheet before another
    juce::Path lines;
    lines.addRoundedRectangle(0.34f, 0.34f, 0.54f, 0.54f, 0.08f);
    lines.startNewSubPath(0.22f, 0.66f);
    lines.lineTo(0.12f, 0.66f);
    lines.lineTo(0.12f, 0.12f);
    lines.lineTo(0.66f, 0.12f);
    lines.lineTo(0.66f, 0.22f);
    return drawn(lines);
}

} // namespace idiophone::icons
