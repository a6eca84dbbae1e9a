// Places of parameters in their ranges and their texts. As Parameters/ParameterTable.cpp and
// ParameterText.cpp; `info` is a row of the package's table.

/** Converts a value to a place from 0 to 1. */
export function placeInRange({ scale, minimum, maximum }, value) {
    if (scale === "logarithmic") return Math.log(value / minimum) / Math.log(maximum / minimum);
    if (scale === "cubic") return Math.cbrt(value / maximum);
    return (value - minimum) / (maximum - minimum);
}

export function valueAt({ scale, minimum, maximum }, place) {
    if (scale === "logarithmic") return minimum * (maximum / minimum) ** place;
    if (scale === "cubic") return place ** 3 * maximum;
    return minimum + place * (maximum - minimum);
}

/** Decimals that show at least that many digits of the rounded value. */
function decimalsFor(value, digits) {
    if (value === 0) return 0;
    const rounded = Number(value.toPrecision(digits));
    return Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(rounded)) + 1e-9));
}

/** Returns "1.00 ×" or "−12 %". */
export function textOf({ scale, decimals, unit }, value) {
    const byDigits = scale === "logarithmic" || scale === "cubic";
    const number = value.toFixed(byDigits ? decimalsFor(value, decimals) : decimals);
    const shown = Number(number) === 0 ? number.replace("-", "") : number.replace("-", "−");
    return unit ? `${shown} ${unit}` : shown;
}
