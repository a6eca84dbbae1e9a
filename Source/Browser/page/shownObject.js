// One object of an instrument as a mesh of the picture.
import { BufferAttribute, Vector3 } from "three";

import { boxOf, drawnCorners, formOf, isClosed, thickened } from "./geometry.js";
import { bendOf, carried, meshOf } from "./meshes.js";

/** The eight corners of a box. */
export function cornersOf({ middle, half }) {
    const signs = [-1, 1];
    return signs.flatMap(x =>
        signs.flatMap(y => signs.map(z => new Vector3(x, y, z).multiply(half).add(middle))),
    );
}

/** The box of what is held, in the object's own metres, or null. */
function clampOf({ clampedVertices }, { vertices }) {
    if (clampedVertices.length === 0) return null;
    return boxOf(clampedVertices.flatMap(at => [...vertices.subarray(3 * at, 3 * at + 3)]));
}

/**
 * `info`: the object's part of an InstrumentInfo. `own`: its mesh. `placement`: see
 * layout.js. `material(object)` makes the material for a result.
 */
export function shownObject({ info, own, placement, look, maximumFaces, swings, material }) {
    const isOpen = !isClosed(own);
    const isSheet = isOpen && info.thicknessMetres > 0;
    const drawn = isSheet ? thickened(own, info.thicknessMetres) : own;
    const form = formOf(drawn.vertices);
    const corners = drawnCorners(drawn, form, maximumFaces);
    carried(corners, placement.matrix);
    const box = boxOf(corners.places);
    const object = {
        info,
        clamp: clampOf(info, own),
        placement,
        look,
        shape: { form, ...box, places: corners.places },
        isClosed: isSheet || !isOpen,
        swingMetres: swings ? 0.05 * Math.max(...box.half) : 0,
        corners: cornersOf(box),
    };
    const mesh = meshOf(corners, material(object));
    if (swings) {
        const bend = bendOf(corners.places, box, object.clamp !== null);
        mesh.geometry.setAttribute("offset", new BufferAttribute(bend, 3));
    }
    object.meshes = [mesh]; // one for each body
    return object;
}
