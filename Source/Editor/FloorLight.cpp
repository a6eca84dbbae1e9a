#include "Editor/FloorLight.h"

#include "Editor/PictureParts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

using namespace juce::gl;

namespace idiophone {

void FloorLight::begin(const SceneFrame& shown) {
    constexpr std::uint8_t full[]{255, 255};
    upload(1, 1, full);
    isUploaded = false;
    if (scene == shown.scene)
        return;
    scene = shown.scene;
    auto vertices = placedVertices(shown);
    measure(vertices, shown.furniture->floorHeight());
    worker.begin(std::move(vertices), floor);
}

const SceneLight* FloorLight::takeUploaded() {
    const auto* light = worker.light();
    if (isUploaded || light == nullptr)
        return nullptr;
    upload(floor.columns, floor.rows, light->floor.data());
    isUploaded = true;
    return light;
}

void FloorLight::measure(std::span<const SceneVertex> vertices, float floorHeight) {
    constexpr float longestSide = 288; // texels
    Eigen::AlignedBox3f box(Eigen::Vector3f::Zero());
    if (!vertices.empty())
        box = Eigen::AlignedBox3f(vectorOf(vertices.front().place));
    for (const auto& vertex : vertices)
        box.extend(vectorOf(vertex.place));
    centre = box.center();
    radius = std::max(box.diagonal().norm() / 2, 1e-4f);
    const float surround = 0.2f * radius + 1.5f * box.sizes().z();
    const Eigen::Vector2f size = box.sizes().head<2>().array() + 2 * surround;
    const float texel = size.maxCoeff() / longestSide;
    floor = {.left = box.min().x() - surround,
             .front = box.min().y() - surround,
             .width = size.x(),
             .depth = size.y(),
             .height = floorHeight,
             .columns = static_cast<int>(std::ceil(size.x() / texel)),
             .rows = static_cast<int>(std::ceil(size.y() / texel))};
}

void FloorLight::upload(int columns, int rows, const std::uint8_t* shares) {
    if (texture == 0)
        glGenTextures(1, &texture);
    bindTexture();
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RG8, columns, rows, 0, GL_RG, GL_UNSIGNED_BYTE, shares);
    for (const auto name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR);
    for (const auto name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
}

void FloorLight::bindTexture() const {
    glBindTexture(GL_TEXTURE_2D, texture);
}

void FloorLight::release() {
    glDeleteTextures(1, &texture);
    texture = 0;
    isUploaded = false;
}

} // namespace idiophone
