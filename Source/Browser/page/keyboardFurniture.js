// The frames of instruments with a keyboard: rails, cords, pins and tubes under bars, the rack of
// chimes, and the board of tines. As Editor/KeyboardFurniture.cpp does. A bar has `middle`, `half`
// (Vector3, metres), `tubeRadius`, `tubeMetres` (0: no tube), `isBehind` and `finish`. Each
// function returns the height of the floor.
import { Box3, Vector3 } from "three";

import { looks } from "./appearance.js";

const nodeShare = 0.552; // of half a free bar's length: where its first mode is at rest

const vector = (x, y, z) => new Vector3(x, y, z);
const bottomOf = bar => bar.middle.z - bar.half.z;

/** The mean width of the bars, the unit of the frame's sizes. */
const unitOf = bars => bars.reduce((sum, bar) => sum + 2 * bar.half.x, 0) / bars.length;

const rowOf = (bars, isBehind) => bars.filter(bar => bar.isBehind === isBehind);

/** The place where the cord passes through a bar: towards (-1) or away from the player (1). */
function cordPlace(bar, side) {
    return bar.middle.clone().add(vector(0, side * nodeShare * bar.half.y, 0));
}

/** The line of a row's rests, drawn on beyond the outer bars: the middle of its upper side. */
function railOf(row, side, unit) {
    const [from, to] = [cordPlace(row[0], side), cordPlace(row.at(-1), side)];
    const along = row.length > 1 ? to.clone().sub(from).normalize() : vector(1, 0, 0);
    const lowest = Math.min(...row.map(bottomOf));
    const [left, right] = [
        from.addScaledVector(along, -1.1 * unit),
        to.addScaledVector(along, 1.1 * unit),
    ];
    left.z = right.z = lowest - 0.16 * unit;
    return { left, right };
}

function addCords(parts, row, unit) {
    for (const side of [-1, 1])
        for (let i = 1; i < row.length; ++i)
            parts.addRod(
                cordPlace(row[i - 1], side),
                cordPlace(row[i], side),
                0.045 * unit,
                0.045 * unit,
                6,
            );
}

/** Pins in the gaps, which hold the cords above the rails. */
function addPins(parts, row, rails, unit) {
    rails.forEach((rail, which) => {
        for (let i = 0; i <= row.length; ++i) {
            const side = which === 0 ? -1 : 1;
            const near = row[Math.min(i, row.length - 1)];
            const at = cordPlace(near, side);
            if (i > 0 && i < row.length) at.add(cordPlace(row[i - 1], side)).multiplyScalar(0.5);
            else at.x += (i === 0 ? -1 : 1) * (near.half.x + 0.09 * unit);
            const head = at.clone().setZ(at.z + 0.06 * unit);
            parts.addRod(vector(at.x, at.y, rail.left.z), head, 0.05 * unit, 0.05 * unit, 6);
        }
    });
}

/** Returns the height of the lowest end. */
function addTubes(parts, bars, unit, hasDiscs) {
    const sides = 24;
    const withTubes = bars.filter(bar => bar.tubeMetres > 0);
    if (withTubes.length === 0) return bottomOf(bars[0]);
    let lowest = Infinity;
    for (const bar of withTubes) {
        const top = vector(bar.middle.x, bar.middle.y, bottomOf(bar) - 0.3 * unit);
        parts.addPipe(top, bar.tubeMetres, bar.tubeRadius, 0.05 * bar.tubeRadius, sides);
        lowest = Math.min(lowest, top.z - bar.tubeMetres);
    }
    parts.finish(bars[0].finish === "wood" ? looks.brass : looks.silver, "turned");
    if (!hasDiscs) return lowest;
    for (const { middle, half, tubeRadius } of withTubes) {
        const below = half.z + 0.3 * unit + 0.35 * tubeRadius;
        const axis = vector(middle.x, middle.y, middle.z - below);
        parts.addDisc(axis, vector(0, 0, 1), 0.9 * tubeRadius, 0.06 * tubeRadius, sides);
    }
    parts.finish(looks.blackSteel);
    return lowest;
}

/** The ends of the frame, which join the rails, and its legs to the floor. */
function addEnds(parts, rails, unit, floor) {
    for (const end of ["left", "right"]) {
        const [near, far] = [rails[0][end].clone(), rails.at(-1)[end].clone()];
        near.z = far.z = near.z - 0.5 * unit;
        const across = far.clone().sub(near).normalize();
        near.addScaledVector(across, -0.5 * unit);
        far.addScaledVector(across, 0.5 * unit);
        parts.addBeam(near, far, 0.4 * unit, 0.9 * unit);
        for (const at of [
            near.addScaledVector(across, 0.6 * unit),
            far.addScaledVector(across, -0.6 * unit),
        ])
            parts.addBeam(vector(at.x, at.y, floor), at, 0.42 * unit, 0.42 * unit, vector(0, 1, 0));
    }
}

export function addKeyboardFrame(parts, bars) {
    const unit = unitOf(bars);
    const isMetal = bars[0].finish === "metal";
    const rails = [];
    for (const isBehind of [false, true]) {
        const row = rowOf(bars, isBehind);
        if (row.length === 0) continue;
        const pair = [railOf(row, -1, unit), railOf(row, 1, unit)];
        rails.push(...pair);
        addCords(parts, row, unit);
        parts.finish(isMetal ? looks.redFelt : looks.cord);
        addPins(parts, row, pair, unit);
        parts.finish(looks.steel);
    }
    const tubesEnd = addTubes(parts, bars, unit, isMetal);
    const floor = Math.min(tubesEnd, rails[0].left.z - unit) - 0.8 * unit;
    const down = vector(0, 0, -0.36 * unit);
    for (const { left, right } of rails)
        parts.addBeam(left.clone().add(down), right.clone().add(down), 0.34 * unit, 0.72 * unit);
    addEnds(parts, rails, unit, floor);
    parts.finish(isMetal ? looks.blackSteel : looks.walnut);
    return floor;
}

/** The box around all bars. */
function boxAround(bars) {
    return new Box3().setFromPoints(
        bars.flatMap(({ middle, half }) => [middle.clone().sub(half), middle.clone().add(half)]),
    );
}

export function addChimeFrame(parts, chimes) {
    const unit = unitOf(chimes);
    const { min: minimum, max: maximum } = boxAround(chimes);
    const beam = maximum.z + 2 * unit;
    const floor = minimum.z - 3 * unit;
    for (const isBehind of [false, true]) {
        const row = rowOf(chimes, isBehind);
        if (row.length === 0) continue;
        const { y } = row[0].middle;
        const [left, right] = [vector(minimum.x - unit, y, beam), vector(maximum.x + unit, y, beam)];
        parts.addBeam(left, right, 0.5 * unit, 0.9 * unit);
    }
    parts.finish(looks.walnut);
    for (const { middle, half } of chimes)
        for (const side of [-0.7, 0.7]) {
            const hole = middle.clone().add(vector(side * half.x, 0, half.z - 0.4 * unit));
            parts.addRod(hole, vector(hole.x, hole.y, beam), 0.04 * unit, 0.04 * unit, 6);
        }
    parts.finish(looks.cord);
    const y = (minimum.y + maximum.y) / 2;
    for (const x of [minimum.x - 1.3 * unit, maximum.x + 1.3 * unit]) {
        parts.addRod(vector(x, y, floor), vector(x, y, beam + 0.6 * unit), 0.36 * unit, 0.36 * unit, 20);
        const foot = floor + 0.3 * unit;
        parts.addBeam(
            vector(x, y - 5 * unit, foot),
            vector(x, y + 5 * unit, foot),
            0.7 * unit,
            0.6 * unit,
        );
        parts.addBeam(vector(x, minimum.y, beam), vector(x, maximum.y, beam), 0.5 * unit, 0.5 * unit);
    }
    parts.finish(looks.steel, "turned");
    return floor;
}

export function addTineBoard(parts, tines) {
    const unit = unitOf(tines);
    const { min: minimum, max: maximum } = boxAround(tines);
    const length = maximum.y - minimum.y;
    const [left, right] = [minimum.x - 2 * unit, maximum.x + 2 * unit];
    // Blocks from one side to the other between two places along the tines and two heights.
    const addBlock = (near, far, bottom, top) => {
        const [y, z] = [(near + far) / 2, (bottom + top) / 2];
        parts.addBeam(vector(left, y, z), vector(right, y, z), far - near, top - bottom);
    };
    const [under, over, end] = [minimum.z, maximum.z, maximum.y];
    const board = under - 2.5 * unit;
    const floor = board - 2 * unit;
    addBlock(end - 0.03 * length, end + 0.12 * length, board, under);
    addBlock(end - 0.02 * length, end + 0.1 * length, over, over + 0.8 * unit);
    parts.finish(looks.blackSteel);
    addBlock(minimum.y - 0.08 * length, end + 0.3 * length, floor, board);
    parts.finish(looks.walnut);
    return floor;
}
