#include "Geometry/LengthUnit.h"

#include "Object/NumberText.h"

#include <array>
#include <cmath>

namespace idiophone {
namespace {

constexpr LengthUnit metres{"metres", "m", 1}, millimetres{"millimetres", "mm", 1e-3};
constexpr std::array units{metres, LengthUnit{"centimetres", "cm", 1e-2}, millimetres,
                           LengthUnit{"inches", "in", 0.0254}, LengthUnit{"feet", "ft", 0.3048}};

/// Formats with three significant digits, or as an integer from 100 up.
std::string figureOf(double length) {
    return length >= 100 && length < 1e9 ? numberText(std::round(length), 9)
                                         : numberText(length, 3);
}

} // namespace

std::optional<LengthUnit> lengthUnitNamed(std::string_view word) {
    for (const auto& unit : units)
        if (word == unit.symbol || word == unit.name)
            return unit;
    return std::nullopt;
}

std::string millimetresText(double lengthMetres) {
    return figureOf(lengthMetres / millimetres.metresPerUnit) + " mm";
}

UnitGuess guessLengthUnit(const Mesh& mesh, bool isInMetres) {
    constexpr double largestMetres = 20, smallestMetres = 0.005;
    Eigen::Vector3d extent = Eigen::Vector3d::Zero();
    if (mesh.faceCount() > 0)
        extent = boxOfFaces(mesh).sizes();
    const double largest = extent.maxCoeff();
    const auto& unit = isInMetres || !(largest > largestMetres) ? metres : millimetres;
    const double size = largest * unit.metresPerUnit;
    UnitGuess guess{
        .unit = unit, .isSure = size >= smallestMetres && size <= largestMetres, .sentence = {}};
    guess.sentence = "The mesh measures " + figureOf(extent.x()) + " x " + figureOf(extent.y()) +
                     " x " + figureOf(extent.z());
    if (isInMetres)
        guess.sentence += guess.isSure
                              ? " metres."
                              : ", which its format takes for metres, but no instrument has "
                                "this size: set the unit if it is another.";
    else if (guess.isSure)
        guess.sentence += ", which looks like " + std::string(guess.unit.name) + ".";
    else
        guess.sentence += ", which no unit makes the size of an instrument; it is taken to be in " +
                          std::string(guess.unit.name) + ".";
    return guess;
}

} // namespace idiophone
