// The unit of length that a mesh file is in: by name, or guessed from the size of the mesh.
#pragma once

#include "Geometry/Mesh.h"

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

/// The unit of a symbol or a name in lower case: m, cm, mm, in, ft; metres, centimetres,
/// millimetres, inches, feet; nothing for any other word.
std::optional<LengthUnit> lengthUnitNamed(std::string_view symbolOrName);

/// A length for a sentence: "12.5 mm", to three figures, or whole millimetres where it has more.
std::string millimetresText(double lengthMetres);

struct UnitGuess {
    LengthUnit unit;
    bool isSure = false; ///< false where the size fits no sounding thing in any unit
    /// Such as "The mesh measures 350 x 50 x 20, which looks like millimetres."
    std::string sentence;
};

/// Guesses from the largest extent of the bounding box, in units of the file. No instrument is
/// larger than 20 m, and few meshes of one are smaller than 5 mm:
///     above 20          millimetres (a spoon to a church bell), surely so up to 20,000;
///     0.005 to 20       metres;
///     below, or empty   metres, but not surely so.
/// Centimetres and inches cannot be told from millimetres by size: whoever knows says so.
UnitGuess guessLengthUnit(const Mesh& meshInFileUnits);

} // namespace idiophone
