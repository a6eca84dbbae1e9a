// Meshes of the stage, with the attributes that the plugin's shaders read.
import { BufferAttribute, BufferGeometry, Matrix4, Mesh, Vector3 } from "three";

/** A mesh of corners in the picture's coordinates (or a body's). */
export function meshOf({ places, normals }, material) {
    const geometry = new BufferGeometry();
    const place = new BufferAttribute(places, 3);
    geometry.setAttribute("position", place); // for rays
    geometry.setAttribute("place", place);
    geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    const sky = new Uint8Array(places.length / 3).fill(255);
    geometry.setAttribute("sky", new BufferAttribute(sky, 1, true));
    const mesh = new Mesh(geometry, material);
    material.uniforms.pose.value = mesh.matrixWorld;
    mesh.matrixAutoUpdate = false;
    return mesh;
}

/** How the corners of a long object bend at its lowest mode; the largest offset is about 1. */
export function bendOf(places, { middle, half }, isHeld) {
    const offsets = new Float32Array(places.length);
    const isUpright = half.z > half.y;
    const [axis, direction] = isUpright ? [2, 1] : [1, 2];
    for (let i = 0; i < places.length; i += 3) {
        const along = (places[i + axis] - middle.getComponent(axis)) / half.getComponent(axis);
        const free = Math.cos(2.365 * along) / -1.427 + Math.cosh(2.365 * along) / 10.74;
        offsets[i + direction] = isHeld ? ((1 - along) / 2) ** 2 : free;
    }
    return offsets;
}

/** Carries corners by a matrix that turns, scales evenly and shifts. */
export function carried({ places, normals }, matrix) {
    const turn = new Matrix4().extractRotation(matrix);
    const point = new Vector3();
    for (let i = 0; i < places.length; i += 3) {
        point.fromArray(places, i).applyMatrix4(matrix).toArray(places, i);
        point.fromArray(normals, i).applyMatrix4(turn).toArray(normals, i);
    }
}

/** The normal of the corner nearest to a place. */
export function normalAt({ geometry }, place) {
    const { position, normal } = geometry.attributes;
    const point = new Vector3();
    let nearest = 0;
    let distance = Infinity;
    for (let i = 0; i < position.count; ++i) {
        const squared = point.fromBufferAttribute(position, i).distanceToSquared(place);
        if (squared < distance) [nearest, distance] = [i, squared];
    }
    return point.fromBufferAttribute(normal, nearest);
}
