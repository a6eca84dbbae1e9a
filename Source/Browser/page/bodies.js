// The moving bodies of a scene. Several may share an object.
import { Matrix4, Mesh, Quaternion } from "three";

import { boxOf } from "./geometry.js";

const numbersOfPose = 8; // isThere, origin in metres, quaternion xyzw

/** Another mesh of the same shape. */
function copyOf(mesh, material) {
    const copy = new Mesh(mesh.geometry, material);
    copy.matrixAutoUpdate = false;
    material.uniforms.pose.value = copy.matrixWorld;
    return copy;
}

/** Bars lie along y and are longer than wide, and wider than high. */
const isBar = ({ half }) => half.y > 2 * half.x && half.x > half.z;

export class Bodies {
    #bodies;

    /**
     * `indices`: of the object of each body. Adds a mesh to the object for each further body, with a
     * material of `materialOf(index)`. A part of furniture with `object` is drawn by `build(part)` at
     * each body of that object.
     */
    constructor(indices, objects, parts, { build, materialOf }) {
        const isUsed = new Set();
        this.#bodies = indices.map(index => {
            const object = objects[index];
            const [first] = object.meshes;
            const mesh = isUsed.has(index) ? copyOf(first, materialOf(index)) : first;
            if (isUsed.has(index)) object.meshes.push(mesh);
            isUsed.add(index);
            const furniture = parts.filter(part => part.object === index).map(part => build(part));
            return { object, mesh, furniture };
        });
    }

    get meshes() {
        return this.#bodies.flatMap(({ mesh, furniture }) => [mesh, ...furniture]);
    }

    /** Takes all poses. */
    setPoses(poses) {
        const pose = new Matrix4();
        this.#bodies.forEach((body, i) => {
            const first = numbersOfPose * i;
            const [isThere, x, y, z, ...turn] = poses.subarray(first, first + numbersOfPose);
            pose.makeRotationFromQuaternion(new Quaternion(...turn)).setPosition(x, y, z);
            for (const mesh of [body.mesh, ...body.furniture]) {
                mesh.visible = isThere === 1;
                mesh.matrix.copy(pose);
                mesh.matrixWorldNeedsUpdate = true;
            }
        });
    }

    /** The corners of the boxes of all bodies that are there, in the picture's metres. */
    get corners() {
        return this.#present().flat();
    }

    /** The bodies that lie as the bars of a keyboard, from left to right (keyboardFurniture.js). */
    get bars() {
        return this.#present()
            .map(corners => boxOf(corners.flatMap(corner => corner.toArray())))
            .map(box => ({ ...box, tubeMetres: 0, isBehind: false, finish: "wood" }))
            .filter(isBar)
            .sort((a, b) => a.middle.x - b.middle.x);
    }

    /** The corners of each body that is there. */
    #present() {
        return this.#bodies
            .filter(({ mesh }) => mesh.visible)
            .map(({ object, mesh }) =>
                object.corners.map(corner => corner.clone().applyMatrix4(mesh.matrix)),
            );
    }
}
