#include "Editor/SceneLight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace idiophone {
namespace {

using Eigen::Vector2f, Eigen::Vector3f;

constexpr int mapSize = 512;               // texels along each side of a depth map
constexpr std::size_t lampDirections = 20; // over the lamp
constexpr std::size_t skyDirections = 40;
constexpr std::size_t fewestDirections = 8;
constexpr std::size_t maximumWork = 6'000'000; // vertices times directions
constexpr float lampRadius = 0.13f;            // tangent of half the lamp's angle

/// The heights of the triangles above a plane across a direction, nearest to the light first.
class DepthMap {
public:
    DepthMap(std::span<const SceneVertex> vertices, const Vector3f& direction)
        : towards(direction), right(direction.unitOrthogonal()), up(direction.cross(right)),
          depths(std::size_t(mapSize) * mapSize, nothing) {
        Eigen::AlignedBox2f box;
        std::vector<Vector3f> seen;
        seen.reserve(vertices.size());
        for (const auto& vertex : vertices) {
            const auto place = vectorOf(vertex.place);
            seen.emplace_back(place.dot(right), place.dot(up), place.dot(towards));
            box.extend(seen.back().head<2>());
        }
        corner = box.min();
        const float extent = box.sizes().maxCoeff() * 1.001f + 1e-6f;
        scale = float(mapSize) / extent;
        for (std::size_t i = 0; i + 2 < seen.size(); i += 3)
            draw(seen[i], seen[i + 1], seen[i + 2]);
    }

    float texelMetres() const { return 1 / scale; }

    /// Whether nothing lies between the place and the light, apart from a margin in metres.
    bool sees(const Vector3f& place, float margin) const {
        const Vector2f at = (Vector2f(place.dot(right), place.dot(up)) - corner) * scale;
        const int x = static_cast<int>(std::floor(at.x())),
                  y = static_cast<int>(std::floor(at.y()));
        if (x < 0 || y < 0 || x >= mapSize || y >= mapSize)
            return true;
        return depths[std::size_t(y) * mapSize + std::size_t(x)] <= place.dot(towards) + margin;
    }

private:
    static constexpr float nothing = std::numeric_limits<float>::lowest();

    void draw(const Vector3f& a, const Vector3f& b, const Vector3f& c) {
        const auto placed = [&](const Vector3f& point) -> Vector2f {
            return (point.head<2>() - corner) * scale;
        };
        const Vector2f p = placed(a), q = placed(b), r = placed(c);
        const Vector2f side = q - p, other = r - p;
        const float area = side.x() * other.y() - side.y() * other.x();
        if (std::abs(area) < 1e-9f)
            return;
        const auto range = [](float x, float y, float z) {
            const auto limited = [](float value) {
                return std::clamp(static_cast<int>(std::floor(value)), 0, mapSize - 1);
            };
            return std::pair(limited(std::min({x, y, z})), limited(std::max({x, y, z})));
        };
        const auto [left, rightmost] = range(p.x(), q.x(), r.x());
        const auto [bottom, top] = range(p.y(), q.y(), r.y());
        for (int y = bottom; y <= top; ++y)
            for (int x = left; x <= rightmost; ++x) {
                const Vector2f at = Vector2f(float(x) + 0.5f, float(y) + 0.5f) - p;
                const float second = (at.x() * other.y() - at.y() * other.x()) / area;
                const float third = (side.x() * at.y() - side.y() * at.x()) / area;
                if (second < 0 || third < 0 || second + third > 1)
                    continue;
                const float depth = a.z() + second * (b.z() - a.z()) + third * (c.z() - a.z());
                auto& nearest = depths[std::size_t(y) * mapSize + std::size_t(x)];
                nearest = std::max(nearest, depth);
            }
    }

    Vector3f towards, right, up;
    Vector2f corner;
    float scale = 1; ///< texels per metre
    std::vector<float> depths;
};

/// Points of a unit disc, evenly spread (Vogel's spiral).
Vector2f discPoint(std::size_t index, std::size_t count) {
    const float radius = std::sqrt((float(index) + 0.5f) / float(count));
    const float angle = float(index) * std::numbers::pi_v<float> * (3 - std::sqrt(5.0f));
    return radius * Vector2f(std::cos(angle), std::sin(angle));
}

std::uint8_t shareOf(float seen, float all) {
    return static_cast<std::uint8_t>(std::lround(255 * (all > 0 ? seen / all : 1)));
}

Vector3f texelPlace(const FloorArea& area, std::size_t index) {
    const auto columns = static_cast<std::size_t>(area.columns);
    return {area.left + area.width * (float(index % columns) + 0.5f) / float(area.columns),
            area.front + area.depth * (float(index / columns) + 0.5f) / float(area.rows),
            area.height};
}

/// Averages each texel with its neighbours, which hides the steps between directions.
std::vector<float> blurred(const std::vector<float>& texels, const FloorArea& area) {
    constexpr int around = 2;
    std::vector<float> result(texels.size());
    for (int row = 0; row < area.rows; ++row)
        for (int column = 0; column < area.columns; ++column) {
            float sum = 0, count = 0;
            for (int y = std::max(row - around, 0); y <= std::min(row + around, area.rows - 1); ++y)
                for (int x = std::max(column - around, 0);
                     x <= std::min(column + around, area.columns - 1); ++x, ++count)
                    sum += texels[static_cast<std::size_t>(y * area.columns + x)];
            result[static_cast<std::size_t>(row * area.columns + column)] = sum / count;
        }
    return result;
}

} // namespace

std::optional<SceneLight> sceneLight(std::span<const SceneVertex> vertices,
                                     const FloorArea& area,
                                     const std::atomic<bool>* isAbandoned) {
    const auto texels =
        static_cast<std::size_t>(area.columns) * static_cast<std::size_t>(area.rows);
    const auto affordable =
        std::max(maximumWork / (vertices.size() + texels + 1), fewestDirections);
    std::vector<float> seenSky(vertices.size()), allSky(vertices.size());
    std::vector<float> floorLamp(texels), floorSky(texels);

    const auto lampCount = std::min(lampDirections, affordable),
               skyCount = std::min(skyDirections, affordable);
    const auto ends = [isAbandoned] { return isAbandoned != nullptr && *isAbandoned; };
    const auto lamp = vectorOf(SceneLight::lamp).normalized();
    const Vector3f lampRight = lamp.unitOrthogonal(), lampUp = lamp.cross(lampRight);
    for (std::size_t i = 0; i < lampCount && !ends(); ++i) {
        const Vector2f at = lampRadius * discPoint(i, lampCount);
        const DepthMap map(vertices, (lamp + at.x() * lampRight + at.y() * lampUp).normalized());
        for (std::size_t texel = 0; texel < texels; ++texel)
            floorLamp[texel] += map.sees(texelPlace(area, texel), map.texelMetres()) ? 1.0f : 0.0f;
    }
    for (std::size_t i = 0; i < skyCount && !ends(); ++i) {
        // Directions are denser towards the zenith, as light from an even sky on the floor is.
        const Vector2f at = discPoint(i, skyCount);
        const Vector3f direction(at.x(), at.y(), std::sqrt(1 - at.squaredNorm()));
        const DepthMap map(vertices, direction);
        for (std::size_t texel = 0; texel < texels; ++texel)
            floorSky[texel] += map.sees(texelPlace(area, texel), map.texelMetres()) ? 1.0f : 0.0f;
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            const auto normal = vectorOf(vertices[v].normal);
            const float weight = normal.dot(direction) / direction.z();
            if (weight <= 0)
                continue;
            allSky[v] += weight;
            const float away = 2 * map.texelMetres();
            if (map.sees(vectorOf(vertices[v].place) + away * normal, away))
                seenSky[v] += weight;
        }
    }
    if (ends())
        return std::nullopt;
    floorLamp = blurred(floorLamp, area);
    floorSky = blurred(blurred(floorSky, area), area);
    SceneLight light;
    for (std::size_t v = 0; v < vertices.size(); ++v)
        light.sky.push_back(shareOf(seenSky[v], allSky[v]));
    for (std::size_t texel = 0; texel < texels; ++texel) {
        light.floor.push_back(shareOf(floorLamp[texel], float(lampCount)));
        light.floor.push_back(shareOf(floorSky[texel], float(skyCount)));
    }
    return light;
}

} // namespace idiophone
