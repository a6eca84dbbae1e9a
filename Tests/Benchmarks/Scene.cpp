#include "Benchmarks/Scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace idiophone {

BenchScene::BenchScene(std::vector<SynthesiserSlot> slots,
                       std::vector<SceneStrike> timedStrikes,
                       const SynthesisSettings& settings)
    : synth(std::move(slots), benchSampleRateHz), strikes(std::move(timedStrikes)) {
    synth.setSettings(settings);
}

void BenchScene::restart() {
    synth.reset();
    next = 0;
    cellIndex = 0;
}

std::span<const float, cellSamples> BenchScene::nextCell() {
    synth.beginCell(cell);
    const double start = static_cast<double>(cellIndex++) * cellSamples;
    for (; next < strikes.size(); ++next) {
        const double within = strikes[next].seconds * benchSampleRateHz - start;
        if (within >= cellSamples)
            break;
        synth.strike(strikes[next].slot, strikes[next].strike, std::max(within, 0.0), cell);
    }
    return cell;
}

std::vector<float> BenchScene::render(std::size_t cells) {
    restart();
    std::vector<float> output;
    output.reserve(cells * cellSamples);
    for (std::size_t k = 0; k < cells; ++k) {
        const auto rendered = nextCell();
        output.insert(output.end(), rendered.begin(), rendered.end());
    }
    return output;
}

std::vector<std::int64_t> BenchScene::modesMixed(std::size_t cells) {
    restart();
    std::vector<std::int64_t> modes;
    for (std::size_t k = 0; k < cells; ++k) {
        nextCell();
        modes.push_back(synth.modesMixed());
    }
    return modes;
}

double meanOf(std::span<const std::int64_t> numbers) {
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) /
           static_cast<double>(numbers.size());
}

double share(std::minstd_rand& random) {
    return static_cast<double>(random() - std::minstd_rand::min()) /
           static_cast<double>(std::minstd_rand::max() - std::minstd_rand::min());
}

std::size_t cellsIn(double seconds) {
    return static_cast<std::size_t>(std::ceil(seconds * benchSampleRateHz / cellSamples));
}

StrikePoint strikePointAt(const ModalObject& object, const std::array<double, 3>& place) {
    std::array<double, 3> point{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = object.vertices[axis];
        double high = low;
        for (std::size_t k = axis; k < object.vertices.size(); k += 3) {
            low = std::min<double>(low, object.vertices[k]);
            high = std::max<double>(high, object.vertices[k]);
        }
        point[axis] = std::lerp(low, high, (place[axis] + 1) / 2);
    }
    return strikePointOfRow(object, nearestShapeRow(object, point));
}

StrikePoint strikePointOfRow(const ModalObject& object, std::size_t row) {
    const auto vertex = static_cast<std::size_t>(object.shapeVertices[row]);
    const auto normals = vertexNormals(object);
    return {.shapeRows = {static_cast<std::int32_t>(row), 0, 0},
            .weights = {1, 0, 0},
            .normal = {normals[3 * vertex], normals[3 * vertex + 1], normals[3 * vertex + 2]}};
}

Strike strikeInto(const StrikePoint& point, double newtonSeconds, double contactSeconds) {
    Strike strike{.point = point, .durationSeconds = contactSeconds};
    for (std::size_t axis = 0; axis < 3; ++axis)
        strike.impulseNewtonSeconds[axis] = static_cast<float>(-newtonSeconds) * point.normal[axis];
    return strike;
}

std::shared_ptr<const ModalObject>
longRingingObject(const ModalObject& body, std::size_t modes, double shiftHz) {
    ModalObject object = body;
    object.name = "long-ringing " + body.name;
    object.material.damping = {.fluidPerSecond = 0.2};
    object.bending.clear();
    object.radiation = {};
    object.decaysPerSecond.clear();
    object.extraDecaysPerSecond.clear();
    object.gains.clear();
    object.eigenvalues.clear();
    object.shapes.clear();
    for (std::size_t i = 1; i <= modes; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(modes);
        const double hz = 18000 * share + shiftHz;
        object.eigenvalues.push_back(std::pow(2 * std::numbers::pi * hz, 2));
    }
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row)
        for (std::size_t i = 0; i < modes; ++i)
            object.shapes.insert(object.shapes.end(), {0, 0, 1});
    return std::make_shared<const ModalObject>(std::move(object));
}

} // namespace idiophone
