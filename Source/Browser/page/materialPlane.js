// The map of materials: from slow to fast sound, from dull to ringing, with mixtures between the
// named ones. Mathematics only, as Editor/MaterialPlane.cpp; materials have the names and figures of
// Resources/Materials/materials.json.

const [slowestMetresPerSecond, fastestMetresPerSecond] = [700, 7000];
const [dullestSeconds, longestRingSeconds] = [0.03, 200];
const planeOmega = 2 * Math.PI * 1000; // of the frequency at which decay is compared

const shareBetween = (value, lowest, highest) =>
    Math.min(Math.max(Math.log(value / lowest) / Math.log(highest / lowest), 0), 1);
const between = (share, lowest, highest) => lowest * (highest / lowest) ** share;

/** Contributions of the three damping laws at 1 kHz, in 1/s. */
const termsOf = material => [
    material.fluid_damping_per_s ?? 0,
    (material.loss_factor ?? 0) * planeOmega,
    (material.viscoelastic_damping_s ?? 0) * planeOmega ** 2,
];
const sumOf = terms => terms[0] + terms[1] + terms[2];

/** Seconds in which a mode at 1 kHz decays by 60 dB. */
export const decaySeconds = material => (2 * Math.log(1000)) / sumOf(termsOf(material));

/** Returns the place on the map: `fast` and `ringing`, both from 0 to 1. */
export function placeOf(material) {
    const metresPerSecond = Math.sqrt(material.youngs_modulus_pa / material.density_kg_per_m3);
    return {
        fast: shareBetween(metresPerSecond, slowestMetresPerSecond, fastestMetresPerSecond),
        ringing: shareBetween(decaySeconds(material), dullestSeconds, longestRingSeconds),
    };
}

export const soundMetresPerSecond = place =>
    between(place.fast, slowestMetresPerSecond, fastestMetresPerSecond);
export const decaySecondsAt = place => between(place.ringing, dullestSeconds, longestRingSeconds);

/**
 * Returns the material at a place. Density and the mix of damping kinds are averages over `known`,
 * weighted with the inverse square of the distance on the map. Young's modulus and the amount of
 * damping are then solved for the place.
 */
export function materialAt(place, known) {
    let weights = 0;
    let logDensity = 0;
    const kinds = [0, 0, 0];
    for (const material of known) {
        const own = placeOf(material);
        const squared = (own.fast - place.fast) ** 2 + (own.ringing - place.ringing) ** 2;
        const weight = 1 / (1e-9 + squared);
        const terms = termsOf(material);
        const total = sumOf(terms);
        weights += weight;
        logDensity += weight * Math.log(material.density_kg_per_m3);
        if (total > 0) terms.forEach((term, kind) => (kinds[kind] += (weight * term) / total));
    }
    const density = Math.exp(logDensity / weights);
    const perSecond = (2 * Math.log(1000)) / decaySecondsAt(place);
    const [fluid, loss, viscoelastic] = kinds.map(kind => (perSecond * kind) / sumOf(kinds));
    return {
        youngs_modulus_pa: density * soundMetresPerSecond(place) ** 2,
        density_kg_per_m3: density,
        fluid_damping_per_s: fluid,
        loss_factor: loss / planeOmega,
        viscoelastic_damping_s: viscoelastic / planeOmega ** 2,
    };
}
