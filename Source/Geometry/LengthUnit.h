// The length unit of a mesh file: by name, or guessed from the mesh's size.
#pragma once

#include "Mesh/Mesh.h"

#include <optional>
#include <string>
#include <string_view>

namespace idiophone {

struct LengthUnit {
    std::string_view name;   ///< "millimetres"
    std::string_view symbol; ///< "mm"
    double metresPerUnit = 1;

    bool operator==(const LengthUnit&) const = default;
};

/// Returns the unit of a lower-case symbol or name: m, cm, mm, in, ft, metres, centimetres,
/// millimetres, inches, feet. Returns nothing for any other word.
std::optional<LengthUnit> lengthUnitNamed(std::string_view symbolOrName);

/// Formats a length for a sentence, such as "12.5 mm": three significant digits, or whole
/// millimetres from 100 mm up.
std::string millimetresText(double lengthMetres);

struct UnitGuess {
    LengthUnit unit;
    bool isSure = false; ///< false if the size fits no instrument in any unit
    /// for example "The mesh measures 350 x 50 x 20, which looks like millimetres."
    std::string sentence;
};

/// Guesses from the largest extent of the faces' bounding box, in units of the file. No instrument
/// is larger than 20 m, and few meshes of instruments are smaller than 5 mm:
///     above 20          millimetres (a spoon to a church bell), certain up to 20,000;
///     0.005 to 20       metres;
///     below, or empty   metres, uncertain.
/// Size cannot tell centimetres and inches from millimetres: the user has to name them.
/// With `isInMetres`, the format says metres: they are certain from 0.005 to 20.
UnitGuess guessLengthUnit(const Mesh& meshInFileUnits, bool isInMetres = false);

} // namespace idiophone
