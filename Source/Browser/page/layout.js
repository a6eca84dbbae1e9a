// Lays the objects of an instrument out in the picture, in metres, z up: bars of a keyboard in two
// rows, a kit on a shelf, a single object alone. As Editor/ObjectScene.cpp and ObjectShelf.h do.
import { Matrix4, Vector3 } from "three";

export const isAccidental = note => [1, 3, 6, 8, 10].includes(note % 12);

// Turns an object's x axis, along which bars lie, to the picture's y.
const turned = new Matrix4().makeBasis(
    new Vector3(0, 1, 0),
    new Vector3(-1, 0, 0),
    new Vector3(0, 0, 1),
);

/** The matrix from an object's own metres to the picture. */
function matrixOf({ pivot, origin, scale, isTurned = false }) {
    const matrix = new Matrix4().makeTranslation(origin);
    if (isTurned) matrix.multiply(turned);
    return matrix
        .multiply(new Matrix4().makeScale(scale, scale, scale))
        .multiply(new Matrix4().makeTranslation(pivot.clone().negate()));
}

function keyboardOf(objects) {
    const gapMetres = 0.006;
    const overlap = 0.9;
    const combColumn = 3.2; // in widths of a tine
    const sizes = objects.map(({ box, sizeRatio }) => box.half.clone().multiplyScalar(2 * sizeRatio));
    const widest = Math.max(...sizes.map(size => size.y));
    const tallest = Math.max(...sizes.map(size => size.z));
    const isComb = objects.every(object => object.isClamped);
    const column = isComb ? combColumn * widest : widest + gapMetres;
    let x = 0;
    let naturalLength = 0;
    return objects.map(({ box, sizeRatio, lowestNote }, i) => {
        const { x: length, z: height } = sizes[i];
        const behind = isAccidental(lowestNote);
        const across = behind ? x - column / 2 : x;
        const origin = new Vector3(across, 0, 0);
        if (height > length) origin.set(across, behind ? column : 0, -height / 2);
        else if (isComb) origin.y = -length / 2;
        else if (behind) origin.set(across, (overlap * (naturalLength + length)) / 2, 1.5 * tallest);
        else naturalLength = length;
        if (!behind) x += column;
        return {
            matrix: matrixOf({ pivot: box.middle, origin, scale: sizeRatio, isTurned: true }),
            isBehind: behind && !isComb,
        };
    });
}

/** How an object would lie in a keyboard. */
function keyboardForm({ box, isClamped }) {
    const { x, y, z } = box.half;
    if (isClamped) return "tine";
    if (z > x) return "chime";
    return x >= 1.5 * y ? "bar" : "other";
}

/** Whether objects are no keyboard: less than three of four are alike. */
function standOnShelf(objects) {
    const forms = objects.map(keyboardForm);
    return forms.every(form => 4 * forms.filter(other => other === form).length < 3 * forms.length);
}

/** Rows on the floor. Large and small objects are drawn more alike than they are. */
function shelfOf(objects) {
    const evenness = 0.6;
    const widthOfDepth = 1.8;
    const sizes = objects.map(({ box, sizeRatio }) => box.half.clone().multiplyScalar(2 * sizeRatio));
    const lengths = sizes.map(size => Math.max(size.x, size.y, size.z, 1e-6));
    const usual = lengths.toSorted((a, b) => a - b)[Math.floor(lengths.length / 2)];
    const gap = 0.25 * usual;
    const scales = lengths.map(length => (usual / length) ** evenness);
    sizes.forEach((size, i) => size.multiplyScalar(scales[i]));
    const area = sizes.reduce((sum, size) => sum + (size.x + gap) * (size.y + gap), 0);
    const rowWidth = Math.sqrt(area * widthOfDepth);
    const placements = [];
    let front = 0;
    for (let first = 0; first < sizes.length; first = placements.length) {
        let end = first;
        let width = 0;
        for (; end < sizes.length && (end === first || width < rowWidth); ++end)
            width += sizes[end].x + gap;
        const depth = Math.max(...sizes.slice(first, end).map(size => size.y));
        let x = -width / 2;
        for (let i = first; i < end; ++i) {
            const share = sizes[i].x + gap;
            const origin = new Vector3(x + share / 2, front + depth / 2, sizes[i].z / 2);
            const scale = scales[i] * objects[i].sizeRatio;
            placements.push({ matrix: matrixOf({ pivot: objects[i].box.middle, origin, scale }) });
            x += share;
        }
        front += depth + gap;
    }
    return placements;
}

/**
 * Returns the kind of the layout ("stage", "shelf", "keyboard" or "single") and a placement for
 * each object: the matrix from its own metres to the picture, and whether it is in the row of
 * accidentals. `objects` have `box` (geometry.js), `sizeRatio`, `lowestNote` and `isClamped`.
 */
export function layoutOf(objects, isScene) {
    if (isScene) {
        const own = ({ sizeRatio }) => ({
            matrix: new Matrix4().makeScale(sizeRatio, sizeRatio, sizeRatio),
        });
        return { kind: "stage", placements: objects.map(own) };
    }
    if (objects.length > 1)
        return standOnShelf(objects)
            ? { kind: "shelf", placements: shelfOf(objects) }
            : { kind: "keyboard", placements: keyboardOf(objects) };
    const alone = ({ box, sizeRatio }) => ({
        matrix: matrixOf({ pivot: box.middle, origin: new Vector3(), scale: sizeRatio }),
    });
    return { kind: "single", placements: objects.map(alone) };
}
