// The stand of a single object, by its form: a gallows for bells, a ring under bowls, pegs under
// plates, legs under a table, a post for what is clamped. As Editor/ObjectStand.cpp does. `shape`
// has `form` and, in the picture's metres, `middle`, `half` and `places`.
import { Vector2, Vector3 } from "three";

import { looks } from "./appearance.js";

const [roundSides, legSides] = [48, 20];
const upwards = new Vector3(0, 0, 1);

const vector = (x, y, z) => new Vector3(x, y, z);
const isSheet = ({ half }) => half.z < 0.12 * Math.min(half.x, half.y);

/** The largest radius about the object's axis in a share of its height from one end. */
function radiusAt({ places, middle, half }, atTop) {
    let widest = 0;
    for (let i = 0; i < places.length; i += 3) {
        const above = places[i + 2] - middle.z;
        if ((atTop ? above : -above) > 0.76 * half.z)
            widest = Math.max(widest, Math.hypot(places[i] - middle.x, places[i + 1] - middle.y));
    }
    return widest;
}

/** A bell hangs from a slender frame. */
function addGallows(parts, { middle, half }) {
    const radius = half.x;
    const top = middle.z + half.z;
    const beam = top + 0.3 * radius;
    const floor = middle.z - half.z - 0.4 * radius;
    const thick = 0.05 * radius;
    const aside = 1.45 * radius;
    const foot = floor + thick;
    const at = (x, y, z) => vector(middle.x + x, middle.y + y, z);
    const addRod = (from, to, wide) => parts.addRod(from, to, wide, wide, legSides);
    addRod(at(0, 0, top - 0.05 * radius), at(0, 0, beam), 0.6 * thick);
    addRod(at(-aside - thick, 0, beam), at(aside + thick, 0, beam), thick);
    for (const side of [-aside, aside]) {
        addRod(at(side, 0, foot), at(side, 0, beam), thick);
        addRod(at(side, -0.8 * radius, foot), at(side, 0.8 * radius, foot), thick);
    }
    parts.finish(looks.standSteel, "turned");
    return floor;
}

function addRingBelow(parts, { middle, half }, radius) {
    const thickness = Math.min(Math.max(0.16 * half.x, 0.004), 0.03);
    const ring = Math.max(radius, 0.25 * half.x) + 0.4 * thickness;
    const bottom = middle.z - half.z;
    parts.addRing(vector(middle.x, middle.y, bottom - 0.1 * thickness), ring, thickness, roundSides);
    parts.finish(looks.felt);
    return bottom - 0.6 * thickness;
}

/** Cones of felt under a sheet, near its rest lines. */
function addPegs(parts, { middle, half }, isRound) {
    const extent = Math.max(half.x, half.y);
    const bottom = middle.z - half.z;
    const floor = bottom - 0.16 * extent;
    const corners = [
        [-0.55, -0.55],
        [0.55, -0.55],
        [-0.55, 0.55],
        [0.55, 0.55],
    ];
    const circle = [0, 1, 2].map(i => {
        const angle = 1.57 + 2.0944 * i;
        return [0.97 * Math.cos(angle), 0.97 * Math.sin(angle)];
    });
    for (const [x, y] of isRound ? circle : corners) {
        const at = vector(middle.x + x * half.x, middle.y + y * half.y, bottom);
        parts.addRod(at.clone().setZ(floor), at, 0.06 * extent, 0.02 * extent, legSides);
    }
    parts.finish(looks.felt);
    return floor;
}

/** A post on a board holds what is clamped. */
function addPost(parts, { middle, half }, clamp) {
    const pad = 0.06 * half.length();
    const floor = middle.z - half.z - 0.4 * half.length();
    const at = clamp.middle;
    const size = clamp.half
        .clone()
        .multiplyScalar(2)
        .addScalar(2 * pad);
    const top = at.z + clamp.half.z + pad / 2;
    parts.addBeam(
        vector(at.x, at.y, floor + pad),
        vector(at.x, at.y, top),
        size.x,
        size.y,
        vector(0, 1, 0),
    );
    parts.finish(looks.standSteel);
    const aside = half.x + 2 * pad;
    const z = floor + pad / 2;
    const [left, right] = [vector(middle.x - aside, middle.y, z), vector(middle.x + aside, middle.y, z)];
    parts.addBeam(left, right, 2 * half.y + 4 * pad, pad);
    parts.finish(looks.walnut);
    return floor;
}

export function isTableTop(shape) {
    const longer = Math.max(shape.half.x, shape.half.y);
    return shape.form === "box" && isSheet(shape) && longer > 0.25 && longer < 0.75;
}

/** Returns the height of the floor. */
export function addLegs(parts, { middle, half }) {
    const leg = 0.045 * Math.hypot(half.x, half.y);
    const bottom = middle.z - half.z;
    const floor = bottom - 0.9 * Math.min(half.x, half.y);
    for (const x of [-1, 1])
        for (const y of [-1, 1]) {
            const at = vector(
                middle.x + x * (half.x - 2.4 * leg),
                middle.y + y * (half.y - 2.4 * leg),
                bottom,
            );
            const foot = vector(at.x + 0.8 * x * leg, at.y + 0.8 * y * leg, floor);
            parts.addRod(foot, at, 0.45 * leg, 0.8 * leg, legSides);
        }
    parts.finish(looks.legs);
    return floor;
}

export function isDie({ form, half }) {
    const sizes = half.toArray();
    return form === "box" && Math.min(...sizes) > 0.97 * Math.max(...sizes);
}

/** Adds the pips of a die in its own coordinates. */
export function addPips(parts, { middle, half: { x: half } }) {
    const spread = 0.5 * half;
    const addSide = (out, count) => {
        const right = vector(out.y, out.z, out.x);
        const up = out.clone().cross(right);
        const places = count % 2 === 1 ? [[0, 0]] : [];
        if (count >= 2) places.push([-1, -1], [1, 1]);
        if (count >= 4) places.push([-1, 1], [1, -1]);
        if (count === 6) places.push([-1, 0], [1, 0]);
        for (const [x, y] of places) {
            const at = middle.clone().addScaledVector(out, half);
            at.addScaledVector(right, spread * x).addScaledVector(up, spread * y);
            parts.addDisc(at, out, 0.19 * half, 0.02 * half, legSides);
        }
    };
    [vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)].forEach((out, axis) => {
        addSide(out, axis + 1);
        addSide(out.clone().negate(), 6 - axis);
    });
    parts.finish(looks.pip);
}

/** `finish` is the object's; `clamp`, if it is held, is the box of what is held. */
export function addStand(parts, shape, finish, clamp) {
    const { form, middle, half } = shape;
    if (clamp && 2 * clamp.half.length() < half.length()) return addPost(parts, shape, clamp);
    if (form === "turned" && !isSheet(shape)) {
        const flare = 1.25;
        const above = radiusAt(shape, true);
        const below = radiusAt(shape, false);
        // A shallow gong lies, and a tall bottle stands.
        const slenderness = half.z / half.x;
        if (below > flare * above && slenderness > 0.4 && slenderness < 2.5)
            return addGallows(parts, shape);
        if (above > flare * below) return addRingBelow(parts, shape, below);
        if (half.z < half.x) return addPegs(parts, shape, true);
    } else if (isSheet(shape)) {
        if (finish === "wood" && isTableTop(shape)) return addLegs(parts, shape);
        return addPegs(parts, shape, form === "turned");
    }
    // Anything else stands on a pad of felt.
    const thickness = 0.03 * Math.max(half.x, half.y);
    const bottom = middle.z - half.z;
    const radius = 1.15 * new Vector2(half.x, half.y).length();
    const pad = vector(middle.x, middle.y, bottom - thickness / 2);
    parts.addDisc(pad, upwards, radius, thickness, roundSides);
    parts.finish(looks.felt);
    return bottom - thickness;
}
