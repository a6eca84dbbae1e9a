#include "Analysis/CordSupport.h"

#include "Analysis/BarTuning.h"

#include <array>
#include <cmath>

namespace idiophone {
namespace {

/// The vertices on a bar's top as lines across it, by growing x.
class TopLines {
public:
    explicit TopLines(const ModalObject& bar)
        : bar_(bar), count_(bar.shapeVertexCount() / BarOutline::topAcross) {}

    std::size_t count() const { return count_; }
    double xMetres(std::size_t line) const {
        return bar_.vertices[3 * static_cast<std::size_t>(bar_.shapeVertices[line])];
    }
    /// The vertical φ at the front edge, the middle or the back edge (0 to 2) of a line.
    double upward(std::size_t line, std::size_t across, std::size_t mode) const {
        return bar_.shapesAt(across * count_ + line)[3 * mode + 2];
    }
    /// φ² at x, averaged over the width. x lies within the bar.
    double meanSquare(double x, std::size_t mode) const {
        std::size_t line = 0;
        while (line + 2 < count_ && xMetres(line + 1) < x)
            ++line;
        const double share = (x - xMetres(line)) / (xMetres(line + 1) - xMetres(line));
        constexpr std::array<double, BarOutline::topAcross> weights{0.25, 0.5, 0.25};
        double sum = 0;
        for (std::size_t j = 0; j < weights.size(); ++j) {
            const double shape = std::lerp(upward(line, j, mode), upward(line + 1, j, mode), share);
            sum += weights[j] * shape * shape;
        }
        return sum;
    }

private:
    const ModalObject& bar_;
    std::size_t count_;
};

} // namespace

std::vector<double> cordPlacesMetres(const ModalObject& bar) {
    const auto bending = verticalBendingModes(bar);
    if (bending.empty())
        return {};
    const auto fundamental = static_cast<std::size_t>(bending.front());
    const TopLines top(bar);
    std::vector<double> nodes;
    for (std::size_t line = 0; line + 1 < top.count(); ++line) {
        const double here = top.upward(line, 1, fundamental);
        const double next = top.upward(line + 1, 1, fundamental);
        if ((here < 0) != (next < 0))
            nodes.push_back(
                std::lerp(top.xMetres(line), top.xMetres(line + 1), here / (here - next)));
    }
    return nodes;
}

void addCordLoss(ModalObject& bar, const CordSupport& cords) {
    const auto places = cordPlacesMetres(bar);
    if (places.size() != 2)
        return;
    const TopLines top(bar);
    const double spreadMetres =
        cords.spreadOverLength * (top.xMetres(top.count() - 1) - top.xMetres(0));
    bar.extraDecaysPerSecond.resize(bar.modeCount());
    for (std::size_t mode = 0; mode < bar.modeCount(); ++mode) {
        double squares = 0;
        for (const double x : places)
            squares +=
                (top.meanSquare(x - spreadMetres, mode) + top.meanSquare(x + spreadMetres, mode)) /
                2;
        const double resistance =
            cords.resistanceNsPerM *
            std::pow(bar.dampedFrequencyHz(mode) / 1000, cords.resistanceExponent);
        bar.extraDecaysPerSecond[mode] += resistance / 2 * squares;
    }
}

} // namespace idiophone
