#include "Editor/PlainPicture.h"

#include "Editor/PictureParts.h"
#include "Editor/PixelProjection.h"
#include "Editor/SceneLight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <vector>

namespace idiophone {
namespace {

using Eigen::Vector3f;

constexpr std::size_t maximumFaces = 3000; // of an object; painting one takes microseconds

struct Face {
    std::array<Vector3f, 3> corners;
    juce::Colour colour;
    float distance = 0; ///< from the eye
};

juce::Colour shaded(const Appearance& look, const Vector3f& normal) {
    const float light = 0.5f + 0.5f * std::max(normal.dot(vectorOf(SceneLight::lamp)), 0.0f);
    const auto& [red, green, blue] = look.colour;
    return juce::Colour::fromFloatRGBA(light * red, light * green, light * blue, 1);
}

/// The corners of an object's faces, three each; of its box if it has many.
std::vector<Vector3f> cornersOf(const SceneFrame& frame, const SceneObject& shape) {
    std::vector<Vector3f> corners;
    if (shape.vertexCount <= 3 * maximumFaces) {
        for (const auto& vertex :
             frame.scene->vertices().subspan(shape.firstVertex, shape.vertexCount))
            corners.push_back(vectorOf(vertex.place));
        return corners;
    }
    const Vector3f middle = vectorOf(shape.middle), half = vectorOf(shape.halfExtent);
    const auto box = boxMesh(
        Eigen::AlignedBox3f(Vector3f(middle - half), Vector3f(middle + half)).cast<double>());
    for (const auto& corner : box.corners)
        corners.push_back(corner.place);
    return corners;
}

} // namespace

void paintPlainPicture(juce::Graphics& g, juce::Rectangle<float> area, const SceneFrame& frame) {
    const Vector3f eye = vectorOf(frame.eye);
    std::vector<Face> faces;
    for (const auto& part : partsOf(frame)) {
        if (!part.object)
            continue;
        auto corners = cornersOf(frame, part.shape);
        for (auto& corner : corners)
            corner = (part.pose * corner.homogeneous()).head<3>();
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            const auto &a = corners[i], &b = corners[i + 1], &c = corners[i + 2];
            Vector3f normal = (b - a).cross(c - a).normalized();
            const Vector3f middle = (a + b + c) / 3;
            if (normal.dot(eye - middle) < 0) {
                if (part.shape.isClosed)
                    continue;
                normal = -normal;
            }
            faces.push_back({{a, b, c}, shaded(part.look, normal), (middle - eye).norm()});
        }
    }
    std::ranges::sort(faces, std::greater(), &Face::distance);
    const PixelProjection projection(frame.viewProjection, area);
    for (const auto& face : faces) {
        const auto a = projection.pixelOf(face.corners[0]), b = projection.pixelOf(face.corners[1]),
                   c = projection.pixelOf(face.corners[2]);
        if (!a || !b || !c)
            continue;
        juce::Path path;
        path.addTriangle(*a, *b, *c);
        g.setColour(face.colour);
        g.fillPath(path);
        g.strokePath(path, juce::PathStrokeType(0.6f)); // closes the seams between faces
    }
}

} // namespace idiophone
