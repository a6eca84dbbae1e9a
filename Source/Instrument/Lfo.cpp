#include "Instrument/Lfo.h"

#include "Instrument/Scatter.h"

#include <cmath>
#include <numbers>

namespace idiophone {

double lfoValue(LfoShape shape, double swings, std::uint32_t seed) noexcept {
    const double whole = std::floor(swings);
    const double place = swings - whole;
    switch (shape) {
    case LfoShape::sine:
        return std::sin(2 * std::numbers::pi * place);
    case LfoShape::triangle:
        return 4 * std::abs(place + 0.25 - std::floor(place + 0.75)) - 1;
    case LfoShape::square:
        return place < 0.5 ? 1 : -1;
    case LfoShape::rising:
        return 2 * place - 1;
    case LfoShape::falling:
        return 1 - 2 * place;
    case LfoShape::random:
        break;
    }
    const auto count = static_cast<std::uint32_t>(static_cast<std::int64_t>(whole));
    return scatter(count * 0x9e3779b1u + seed);
}

void Lfo::beginCell(double rateHz,
                    double beatsPerSwing,
                    double beatsPerMinute,
                    std::optional<double> beats) noexcept {
    const bool isSynced = beatsPerSwing > 0 && beatsPerMinute > 0;
    now = isSynced && beats ? *beats / beatsPerSwing : next;
    next = now + cellSeconds * (isSynced ? beatsPerMinute / 60 / beatsPerSwing : rateHz);
}

} // namespace idiophone
