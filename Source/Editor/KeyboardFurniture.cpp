#include "Editor/KeyboardFurniture.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <vector>

namespace idiophone {
namespace {

using Vector = Eigen::Vector3f;

constexpr float nodeShare = 0.552f; // of half a free bar's length: where its first mode is at rest

constexpr Appearance walnut{Finish::wood, {0.34f, 0.20f, 0.12f}};
constexpr Appearance blackSteel{Finish::metal, {0.20f, 0.21f, 0.23f}};
constexpr Appearance steel{Finish::metal, {0.72f, 0.74f, 0.77f}};
constexpr Appearance brass{Finish::metal, {0.80f, 0.62f, 0.30f}};
constexpr Appearance silver{Finish::metal, {0.80f, 0.82f, 0.85f}};
constexpr Appearance cord{Finish::cloth, {0.78f, 0.72f, 0.60f}};
constexpr Appearance felt{Finish::cloth, {0.45f, 0.10f, 0.12f}};

/// The mean width of the bars, the unit of the frame's sizes.
float unitOf(std::span<const KeyboardBar> bars) {
    float sum = 0;
    for (const auto& bar : bars)
        sum += 2 * bar.half.x();
    return sum / float(bars.size());
}

std::vector<KeyboardBar> rowOf(std::span<const KeyboardBar> bars, bool isBehind) {
    std::vector<KeyboardBar> row;
    std::ranges::copy_if(bars, std::back_inserter(row),
                         [&](const auto& bar) { return bar.isBehind == isBehind; });
    return row;
}

Eigen::AlignedBox3f boxAround(std::span<const KeyboardBar> bars) {
    Eigen::AlignedBox3f box;
    for (const auto& bar : bars) {
        box.extend(Vector(bar.middle - bar.half));
        box.extend(Vector(bar.middle + bar.half));
    }
    return box;
}

/// The place where the cord passes through a bar: at its rest line towards (−1) or away from the
/// player (1).
Vector cordPlace(const KeyboardBar& bar, float side) {
    return bar.middle + Vector(0, side * nodeShare * bar.half.y(), 0);
}

struct Rail {
    Vector left, right; ///< the middle of its upper side
};

/// The line of a row's rests, drawn on beyond the outer bars.
Rail railOf(std::span<const KeyboardBar> row, float side, float unit) {
    const Vector from = cordPlace(row.front(), side), to = cordPlace(row.back(), side);
    const Vector along =
        row.size() > 1 ? Vector((to - from).normalized()) : Vector(Vector::UnitX());
    const float lowest =
        std::ranges::min(row, {}, [](const auto& bar) { return bar.middle.z() - bar.half.z(); })
            .middle.z() -
        std::ranges::max(row, {}, [](const auto& bar) { return bar.half.z(); }).half.z();
    Rail rail{from - 1.1f * unit * along, to + 1.1f * unit * along};
    rail.left.z() = rail.right.z() = lowest - 0.16f * unit;
    return rail;
}

void addRails(FurnitureParts& parts, const std::vector<Rail>& rails, float unit) {
    const Vector down(0, 0, -0.36f * unit);
    for (const auto& [left, right] : rails)
        parts.addBeam(left + down, right + down, 0.34f * unit, 0.72f * unit);
}

void addCords(FurnitureParts& parts, std::span<const KeyboardBar> row, float unit) {
    constexpr int sides = 6;
    const float radius = 0.045f * unit;
    for (const float side : {-1.0f, 1.0f})
        for (std::size_t i = 1; i < row.size(); ++i)
            parts.addRod(cordPlace(row[i - 1], side), cordPlace(row[i], side), radius, radius,
                         sides);
}

/// Pins in the gaps, which hold the cords above the rails.
void addPins(FurnitureParts& parts,
             std::span<const KeyboardBar> row,
             const std::array<Rail, 2>& rails,
             float unit) {
    constexpr int sides = 6;
    for (std::size_t which = 0; which < rails.size(); ++which)
        for (std::size_t i = 0; i <= row.size(); ++i) {
            const float side = which == 0 ? -1.0f : 1.0f;
            const auto& near = row[std::min(i, row.size() - 1)];
            Vector at = cordPlace(near, side);
            if (i > 0 && i < row.size())
                at = (at + cordPlace(row[i - 1], side)) / 2;
            else
                at.x() += (i == 0 ? -1.0f : 1.0f) * (near.half.x() + 0.09f * unit);
            const float head = 0.06f * unit;
            parts.addRod({at.x(), at.y(), rails[which].left.z()}, at + Vector(0, 0, head),
                         0.05f * unit, 0.05f * unit, sides);
        }
}

/// Returns the height of the lowest end.
float addTubes(FurnitureParts& parts, std::span<const KeyboardBar> bars, float unit, bool discs) {
    constexpr int sides = 24;
    const auto& look = bars.front().finish == Finish::wood ? brass : silver;
    float lowest = std::numeric_limits<float>::max();
    for (const auto& bar : bars) {
        if (bar.tubeMetres <= 0)
            continue;
        Vector top = bar.middle;
        top.z() -= bar.half.z() + 0.30f * unit;
        parts.addPipe(top, bar.tubeMetres, bar.tubeRadius, 0.05f * bar.tubeRadius, sides);
        lowest = std::min(lowest, top.z() - bar.tubeMetres);
    }
    if (lowest == std::numeric_limits<float>::max())
        return bars.front().middle.z() - bars.front().half.z();
    parts.finish(look, Form::turned);
    for (const auto& bar : bars) {
        if (!discs || bar.tubeMetres <= 0)
            continue;
        const Vector axis =
            bar.middle - Vector(0, 0, bar.half.z() + 0.30f * unit + 0.35f * bar.tubeRadius);
        parts.addDisc(axis, Vector::UnitZ(), 0.9f * bar.tubeRadius, 0.06f * bar.tubeRadius, sides);
        parts.finish(blackSteel).turnsAbout = scenePlace(axis);
    }
    return lowest;
}

/// The ends of the frame, which join the rails, and its legs to the floor.
void addEnds(FurnitureParts& parts, const std::vector<Rail>& rails, float unit, float floor) {
    const auto& front = rails.front();
    const auto& back = rails.back();
    for (const bool isLeft : {true, false}) {
        const auto end = [&](const Rail& rail) { return isLeft ? rail.left : rail.right; };
        Vector near = end(front), far = end(back);
        near.z() = far.z() = near.z() - 0.5f * unit;
        const Vector across = (far - near).normalized();
        near -= 0.5f * unit * across;
        far += 0.5f * unit * across;
        parts.addBeam(near, far, 0.4f * unit, 0.9f * unit);
        for (const auto& at :
             {Vector(near + 0.6f * unit * across), Vector(far - 0.6f * unit * across)})
            parts.addBeam({at.x(), at.y(), floor}, at, 0.42f * unit, 0.42f * unit, Vector::UnitY());
    }
}

} // namespace

float addKeyboardFrame(FurnitureParts& parts, std::span<const KeyboardBar> bars) {
    const float unit = unitOf(bars);
    const bool isMetal = bars.front().finish == Finish::metal;
    std::vector<Rail> rails;
    for (const bool isBehind : {false, true}) {
        const auto row = rowOf(bars, isBehind);
        if (row.empty())
            continue;
        const std::array pair{railOf(row, -1, unit), railOf(row, 1, unit)};
        rails.insert(rails.end(), pair.begin(), pair.end());
        addCords(parts, row, unit);
        parts.finish(isMetal ? felt : cord);
        addPins(parts, row, pair, unit);
        parts.finish(steel);
    }
    const float tubesEnd = addTubes(parts, bars, unit, isMetal);
    const float floor = std::min(tubesEnd, rails.front().left.z() - unit) - 0.8f * unit;
    addRails(parts, rails, unit);
    addEnds(parts, rails, unit, floor);
    parts.finish(isMetal ? blackSteel : walnut);
    return floor;
}

float addChimeFrame(FurnitureParts& parts, std::span<const KeyboardBar> chimes) {
    const float unit = unitOf(chimes);
    const auto box = boxAround(chimes);
    const float beam = box.max().z() + 2 * unit, floor = box.min().z() - 3 * unit;
    constexpr int sides = 20;
    for (const bool isBehind : {false, true}) {
        const auto row = rowOf(chimes, isBehind);
        if (row.empty())
            continue;
        const float y = row.front().middle.y();
        parts.addBeam({box.min().x() - unit, y, beam}, {box.max().x() + unit, y, beam}, 0.5f * unit,
                      0.9f * unit);
    }
    parts.finish(walnut);
    for (const auto& chime : chimes)
        for (const float side : {-0.7f, 0.7f}) {
            const Vector hole = chime.middle + Vector(side * chime.half.x(), 0, chime.half.z());
            parts.addRod(hole - Vector(0, 0, 0.4f * unit), {hole.x(), hole.y(), beam}, 0.04f * unit,
                         0.04f * unit, 6);
        }
    parts.finish(cord);
    const float y = box.center().y();
    for (const float x : {box.min().x() - 1.3f * unit, box.max().x() + 1.3f * unit}) {
        parts.addRod({x, y, floor}, {x, y, beam + 0.6f * unit}, 0.36f * unit, 0.36f * unit, sides);
        parts.addBeam({x, y - 5 * unit, floor + 0.3f * unit},
                      {x, y + 5 * unit, floor + 0.3f * unit}, 0.7f * unit, 0.6f * unit);
        parts.addBeam({x, box.min().y(), beam}, {x, box.max().y(), beam}, 0.5f * unit, 0.5f * unit);
    }
    parts.finish(steel, Form::turned);
    return floor;
}

float addTineBoard(FurnitureParts& parts, std::span<const KeyboardBar> tines) {
    const float unit = unitOf(tines);
    const auto box = boxAround(tines);
    const float length = box.sizes().y(), left = box.min().x() - 2 * unit,
                right = box.max().x() + 2 * unit;
    // Blocks from one side to the other between two places along the tines and two heights.
    const auto addBlock = [&](float near, float far, float bottom, float top) {
        const float y = (near + far) / 2, z = (bottom + top) / 2;
        parts.addBeam({left, y, z}, {right, y, z}, far - near, top - bottom);
    };
    const float under = box.min().z(), over = box.max().z(), end = box.max().y();
    const float board = under - 2.5f * unit, floor = board - 2 * unit;
    addBlock(end - 0.03f * length, end + 0.12f * length, board, under);
    addBlock(end - 0.02f * length, end + 0.10f * length, over, over + 0.8f * unit);
    parts.finish(blackSteel);
    addBlock(box.min().y() - 0.08f * length, end + 0.3f * length, floor, board);
    parts.finish(walnut);
    return floor;
}

} // namespace idiophone
