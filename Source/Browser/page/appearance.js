// How materials look: the finish and colour of each, by its name or by the nearest ones of the
// library. As Editor/Appearance.cpp does. Colours are as on the screen, 0 to 1.
import { decaySeconds } from "./materialPlane.js";

/** In the order of the shaders' numbers (Resources/Shaders/scene.frag). */
export const finishes = ["wood", "metal", "glass", "stone", "ceramic", "plastic", "cloth"];

const look = (finish, ...colour) => ({ finish, colour });

/** Looks of furniture. */
export const looks = {
    walnut: look("wood", 0.34, 0.2, 0.12),
    legs: look("wood", 0.5, 0.35, 0.22),
    blackSteel: look("metal", 0.2, 0.21, 0.23),
    steel: look("metal", 0.72, 0.74, 0.77),
    standSteel: look("metal", 0.62, 0.64, 0.67),
    brass: look("metal", 0.8, 0.62, 0.3),
    silver: look("metal", 0.8, 0.82, 0.85),
    cord: look("cloth", 0.78, 0.72, 0.6),
    redFelt: look("cloth", 0.45, 0.1, 0.12),
    felt: look("cloth", 0.24, 0.26, 0.3),
    pip: look("plastic", 0.95, 0.94, 0.9),
};

/** Converts "#rrggbb" to three channels from 0 to 1. */
export const channelsOf = colour =>
    [1, 3, 5].map(place => parseInt(colour.slice(place, place + 2), 16) / 255);

/** A distance that makes kinds compact: density separates metals and woods best. */
function squaredDistance(a, b) {
    const decay = material => Math.log10(Math.min(Math.max(decaySeconds(material), 1e-3), 100));
    const stiffness = Math.log10(a.youngs_modulus_pa / b.youngs_modulus_pa);
    const density = 2 * Math.log10(a.density_kg_per_m3 / b.density_kg_per_m3);
    const ringing = 0.4 * (decay(a) - decay(b));
    return stiffness ** 2 + density ** 2 + ringing ** 2;
}

/**
 * `material` and those of the library have the names and figures of materials.json; `hasGrain` says
 * whether an unknown material is wood.
 */
export function appearanceOf(material, library) {
    const name = material.name?.toLowerCase(); // a mixture has none
    const known = library.find(each => each.name.toLowerCase() === name);
    if (known) return { finish: known.kind, colour: channelsOf(known.colour) };
    const near = library.map(each => ({ each, distance: squaredDistance(material, each) }));
    const nearest = near.reduce((a, b) => (b.distance < a.distance ? b : a));
    const finish = material.hasGrain ? "wood" : nearest.each.kind;
    const colour = [0, 0, 0];
    let sum = 0;
    for (const { each, distance } of near) {
        if (each.kind !== finish) continue;
        const weight = 1 / (1e-6 + distance) ** 2;
        sum += weight;
        channelsOf(each.colour).forEach((channel, i) => (colour[i] += weight * channel));
    }
    return { finish, colour: colour.map(channel => channel / sum) };
}
