// The furniture for a layout of objects. As Editor/InstrumentFurniture.cpp does.
import { FurnitureParts } from "./furnitureParts.js";
import { addChimeFrame, addKeyboardFrame, addTineBoard } from "./keyboardFurniture.js";
import { addLegs, addPips, addStand, isDie, isTableTop } from "./stands.js";

/** Speed of sound in air over four: a closed tube is a quarter of a wave long. */
const quarterWaveMetresPerSecond = 343 / 4;
const endCorrection = 0.61; // of the radius, at the open end (Levine & Schwinger 1948)
const tubeShare = 0.86; // of the bar's width

function barOf({ shape, placement, info, look }) {
    const tubeRadius = tubeShare * shape.half.x;
    const metres =
        (quarterWaveMetresPerSecond * info.sizeRatio) / info.tubeHz - endCorrection * tubeRadius;
    return {
        middle: shape.middle,
        half: shape.half,
        tubeRadius,
        tubeMetres: info.tubeHz > 0 ? Math.max(metres, tubeRadius) : 0,
        isBehind: placement.isBehind ?? false,
        finish: look.finish,
    };
}

/** Whether an object is long, round and upright, as a chime that hangs. */
const isTube = ({ form, half }) => form === "turned" && half.z > 5 * half.x;

function furnishKeyboard(parts, objects) {
    const bars = objects.map(barOf);
    if (objects[0].clamp) return addTineBoard(parts, bars);
    return bars[0].half.z > bars[0].half.y ? addChimeFrame(parts, bars) : addKeyboardFrame(parts, bars);
}

function furnishSingle(parts, object) {
    if (isTube(object.shape)) return addChimeFrame(parts, [barOf(object)]);
    const clamp = object.clamp && {
        middle: object.clamp.middle.clone().applyMatrix4(object.placement.matrix),
        half: object.clamp.half.clone().multiplyScalar(object.info.sizeRatio),
    };
    return addStand(parts, object.shape, object.look.finish, clamp);
}

/** Legs of tables and pips of dice, which follow their bodies. */
function furnishStage(parts, objects) {
    objects.forEach(({ shape }, object) => {
        if (isTableTop(shape)) {
            addLegs(parts, shape);
            parts.parts.at(-1).object = object;
        }
        if (isDie(shape)) {
            addPips(parts, shape);
            parts.parts.at(-1).object = object;
        }
    });
    return 0;
}

/**
 * Returns the parts (furnitureParts.js) and the height of the floor in metres. `kind` is the
 * layout's; an object has `shape`, `placement`, `info`, `clamp` and `look`. A part with `object`
 * follows that body of a scene.
 */
export function furnish(kind, objects) {
    const parts = new FurnitureParts();
    let floorHeight = 0; // of a shelf
    if (kind === "stage") floorHeight = furnishStage(parts, objects);
    else if (kind === "keyboard") floorHeight = furnishKeyboard(parts, objects);
    else if (kind === "single") floorHeight = furnishSingle(parts, objects[0]);
    return { parts: parts.parts, floorHeight };
}

/** Returns the frame under bars of a scene (keyboardFurniture.js), as above. */
export function frameOfBars(bars) {
    const parts = new FurnitureParts();
    const floorHeight = addKeyboardFrame(parts, bars);
    return { parts: parts.parts, floorHeight };
}
