// Lays out the objects of a kit in the picture: in rows on the floor, in the order of their
// keys.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace idiophone {

/// How an object would lie in a keyboard.
enum class KeyboardForm { bar, chime, tine, other };

inline KeyboardForm keyboardForm(const Eigen::Vector3d& sizes, bool isClamped) {
    constexpr double leastLength = 1.5; // in widths
    if (isClamped)
        return KeyboardForm::tine;
    if (sizes.z() > sizes.x())
        return KeyboardForm::chime;
    return sizes.x() >= leastLength * sizes.y() ? KeyboardForm::bar : KeyboardForm::other;
}

/// Returns whether objects of these forms are no keyboard: less than three of four are alike.
inline bool standOnShelf(std::span<const KeyboardForm> forms) {
    const auto isRare = [&](KeyboardForm form) {
        return 4 * std::ranges::count(forms, form) < 3 * std::ssize(forms);
    };
    return std::ranges::all_of(forms, isRare);
}

struct ShelfPlace {
    Eigen::Vector3d middle; ///< z is half the height: it stands on z = 0
    double scale = 1;       ///< of the object's size
};

/// Returns the places for objects of these sizes in metres. Large and small ones are drawn more
/// alike than they are, so that all are seen.
inline std::vector<ShelfPlace> shelfPlaces(std::span<const Eigen::Vector3d> sizes) {
    constexpr double evenness = 0.6, gapShare = 0.25, widthOfDepth = 1.8;
    std::vector<double> lengths;
    for (const auto& size : sizes)
        lengths.push_back(std::max(size.maxCoeff(), 1e-6));
    auto sorted = lengths;
    std::ranges::sort(sorted);
    const double usual = sorted.empty() ? 1 : sorted[sorted.size() / 2];
    const double gap = gapShare * usual;
    std::vector<ShelfPlace> places;
    double area = 0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double scale = std::pow(usual / lengths[i], evenness);
        places.push_back({.middle = {0, 0, scale * sizes[i].z() / 2}, .scale = scale});
        area += (scale * sizes[i].x() + gap) * (scale * sizes[i].y() + gap);
    }
    const double rowWidth = std::sqrt(area * widthOfDepth);
    double front = 0;
    for (std::size_t first = 0; first < sizes.size();) {
        double width = 0, depth = 0;
        auto end = first;
        for (; end < sizes.size() && (end == first || width < rowWidth); ++end) {
            width += places[end].scale * sizes[end].x() + gap;
            depth = std::max(depth, places[end].scale * sizes[end].y());
        }
        double x = -width / 2;
        for (; first < end; ++first) {
            const double share = places[first].scale * sizes[first].x() + gap;
            places[first].middle.x() = x + share / 2;
            places[first].middle.y() = front + depth / 2;
            x += share;
        }
        front += depth + gap;
    }
    return places;
}

} // namespace idiophone
