#include "Parameters/Units.h"

#include "Parameters/Words.h"

#include <algorithm>
#include <array>
#include <locale>
#include <sstream>
#include <string>
#include <utility>

namespace idiophone {
namespace {

enum class Quantity {
    pressure,
    density,
    length,
    mass,
    time,
    rate,
    frequency,
    turning,
    speed,
    force,
    ratio,
    interval
};

struct Unit {
    std::string_view name; ///< as `plainUnit` writes it
    Quantity quantity;
    double factor; ///< to the first unit of its quantity
};

using enum Quantity;

constexpr std::array units{
    Unit{"Pa", pressure, 1},
    Unit{"kPa", pressure, 1e3},
    Unit{"MPa", pressure, 1e6},
    Unit{"N/mm2", pressure, 1e6},
    Unit{"GPa", pressure, 1e9},
    Unit{"kg/m3", density, 1},
    Unit{"g/l", density, 1},
    Unit{"kg/l", density, 1e3},
    Unit{"kg/dm3", density, 1e3},
    Unit{"g/cm3", density, 1e3},
    Unit{"g/ml", density, 1e3},
    Unit{"m", length, 1},
    Unit{"cm", length, 0.01},
    Unit{"mm", length, 0.001},
    Unit{"um", length, 1e-6},
    Unit{"in", length, 0.0254},
    Unit{"inch", length, 0.0254},
    Unit{"\"", length, 0.0254},
    Unit{"ft", length, 0.3048},
    Unit{"kg", mass, 1},
    Unit{"g", mass, 1e-3},
    Unit{"mg", mass, 1e-6},
    Unit{"oz", mass, 0.028349523125},
    Unit{"lb", mass, 0.45359237},
    Unit{"s", time, 1},
    Unit{"sec", time, 1},
    Unit{"ms", time, 1e-3},
    Unit{"us", time, 1e-6},
    Unit{"min", time, 60},
    Unit{"1/s", rate, 1},
    Unit{"/s", rate, 1},
    Unit{"1/ms", rate, 1e3},
    Unit{"Hz", frequency, 1},
    Unit{"kHz", frequency, 1e3},
    Unit{"turns/s", turning, 1},
    Unit{"turns/min", turning, 1.0 / 60},
    Unit{"rpm", turning, 1.0 / 60},
    Unit{"m/s", speed, 1},
    Unit{"cm/s", speed, 0.01},
    Unit{"mm/s", speed, 0.001},
    Unit{"km/h", speed, 1 / 3.6},
    Unit{"ft/s", speed, 0.3048},
    Unit{"N", force, 1},
    Unit{"kN", force, 1e3},
    Unit{"", ratio, 1},
    Unit{"x", ratio, 1},
    Unit{"%", ratio, 0.01},
    Unit{"cents", interval, 1},
    Unit{"cent", interval, 1},
    Unit{"ct", interval, 1},
    Unit{"semitones", interval, 100},
    Unit{"semitone", interval, 100},
    Unit{"st", interval, 100},
    Unit{"octaves", interval, 1200},
    Unit{"octave", interval, 1200},
    Unit{"oct", interval, 1200},
};

/// Returns the unit with letters of a plain keyboard: u for both code points of µ.
std::string plainUnit(std::string_view unit) {
    std::string plain(unit);
    for (const auto& [shown, typed] : {std::pair<std::string_view, const char*>("µ", "u"),
                                       {"μ", "u"},
                                       {"²", "2"},
                                       {"³", "3"},
                                       {"^", ""},
                                       {"×", "x"}})
        for (auto at = plain.find(shown); at != std::string::npos; at = plain.find(shown))
            plain.replace(at, shown.size(), typed);
    return plain;
}

const Unit* findUnit(const std::string& name) {
    const auto found =
        std::ranges::find_if(units, [&](const Unit& unit) { return sameWord(unit.name, name); });
    return found == units.end() ? nullptr : &*found;
}

/// Returns the length of the number that the text begins with. Streams cannot tell: those of libc++
/// take letters of hexadecimal numbers too, which are also letters of units.
std::size_t lengthOfNumber(std::string_view text) {
    const auto after = [&](std::size_t begin, std::string_view characters) {
        return std::min(text.find_first_not_of(characters, begin), text.size());
    };
    constexpr std::string_view digits = "0123456789";
    const auto signEnd = text.find_first_not_of("+-") == 1 ? 1U : 0U;
    auto end = after(signEnd, digits);
    if (end < text.size() && text[end] == '.')
        end = after(end + 1, digits);
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const auto sign = text.find_first_not_of("+-", end + 1) == end + 2 ? 1U : 0U;
        if (const auto exponent = after(end + 1 + sign, digits); exponent > end + 1 + sign)
            end = exponent;
    }
    return end;
}

} // namespace

std::optional<TypedNumber> parseTypedNumber(std::string_view text) {
    constexpr std::string_view space = " \t\r\n";
    text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
    std::string plain(text);
    std::ranges::replace(plain, ',', '.');
    const auto length = lengthOfNumber(plain);
    std::istringstream stream(plain.substr(0, length));
    stream.imbue(std::locale::classic()); // the host's locale may differ
    TypedNumber typed;
    if (!(stream >> typed.number) || !stream.eof())
        return std::nullopt;
    typed.unit = plain.substr(std::min(plain.find_first_not_of(space, length), plain.size()));
    typed.unit.erase(typed.unit.find_last_not_of(space) + 1);
    return typed;
}

std::optional<double> inUnit(double number, std::string_view typed, std::string_view wanted) {
    const auto from = plainUnit(typed), to = plainUnit(wanted);
    if (sameWord(from, to))
        return number;
    const auto *source = findUnit(from), *target = findUnit(to);
    if (source == nullptr || target == nullptr || source->quantity != target->quantity)
        return std::nullopt;
    return number * (source->factor / target->factor);
}

} // namespace idiophone
