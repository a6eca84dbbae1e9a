// Triangles to draw from an object's mesh: corner normals with creases, its form, and finer faces
// for round objects. As Editor/DrawingMesh.cpp does.
import { Box3, Vector3 } from "three";

const creaseCosine = Math.cos((35 * Math.PI) / 180);
const flatness = 0.02; // distance from the box that counts as on it, of its extent

const pointAt = (vertices, index, target = new Vector3()) => target.fromArray(vertices, 3 * index);

/** Returns the `middle` and half the size (`half`) of the box around points, three numbers each. */
export function boxOf(vertices) {
    const box = new Box3().setFromArray(vertices);
    return {
        middle: box.getCenter(new Vector3()),
        half: box.getSize(new Vector3()).multiplyScalar(0.5),
    };
}

/** Returns "turned" for a body of revolution about z, "box", or "free". */
export function formOf(vertices) {
    const { middle, half } = boxOf(vertices);
    const count = vertices.length / 3;
    const width = 2 * Math.max(half.x, half.y);
    let widest = 0;
    let onBox = 0;
    for (let i = 0; i < vertices.length; i += 3) {
        const away = [0, 1, 2].map(axis => Math.abs(vertices[i + axis] - middle.getComponent(axis)));
        widest = Math.max(widest, Math.hypot(away[0], away[1]));
        const isOn = (extent, axis) => extent - away[axis] <= 2 * flatness * extent + 1e-6;
        if (half.toArray().some(isOn)) ++onBox;
    }
    const roundness = 1.03;
    if (
        count > 16 &&
        widest < (roundness * width) / 2 &&
        2 * Math.abs(half.x - half.y) < (roundness - 1) * width
    )
        return "turned";
    return onBox === count ? "box" : "free";
}

/** Returns whether each edge has two faces. */
export function isClosed({ vertices, faces }) {
    const count = vertices.length / 3;
    const uses = new Map();
    for (let i = 0; i < faces.length; i += 3)
        for (let corner = 0; corner < 3; ++corner) {
            const from = faces[i + corner];
            const to = faces[i + ((corner + 1) % 3)];
            const key = Math.min(from, to) * count + Math.max(from, to);
            uses.set(key, (uses.get(key) ?? 0) + 1);
        }
    for (const times of uses.values()) if (times !== 2) return false;
    return true;
}

/** Returns a unit normal for each corner of each face; those across a crease are not mixed. */
function cornerNormals({ vertices, faces }) {
    const faceCount = faces.length / 3;
    const weighted = new Float32Array(faces.length); // by area
    const unit = new Float32Array(faces.length);
    const around = Array.from({ length: vertices.length / 3 }, () => []);
    const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
    for (let face = 0; face < faceCount; ++face) {
        pointAt(vertices, faces[3 * face], a);
        pointAt(vertices, faces[3 * face + 1], b).sub(a);
        pointAt(vertices, faces[3 * face + 2], c).sub(a);
        b.cross(c).toArray(weighted, 3 * face);
        b.normalize().toArray(unit, 3 * face);
        for (let corner = 0; corner < 3; ++corner) around[faces[3 * face + corner]].push(face);
    }
    const normals = new Float32Array(3 * faces.length);
    for (let face = 0; face < faceCount; ++face)
        for (let corner = 0; corner < 3; ++corner) {
            b.fromArray(unit, 3 * face);
            c.set(0, 0, 0);
            for (const other of around[faces[3 * face + corner]])
                if (a.fromArray(unit, 3 * other).dot(b) > creaseCosine)
                    c.add(a.fromArray(weighted, 3 * other));
            c.normalize().toArray(normals, 9 * face + 3 * corner);
        }
    return normals;
}

/** Doubles an open sheet: both sides at half the thickness, joined along its edges. */
export function thickened({ vertices, faces }, thicknessMetres) {
    const count = vertices.length / 3;
    const normals = new Float32Array(vertices.length);
    const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
    const uses = new Map();
    for (let i = 0; i < faces.length; i += 3) {
        pointAt(vertices, faces[i], a);
        pointAt(vertices, faces[i + 1], b).sub(a);
        pointAt(vertices, faces[i + 2], c).sub(a);
        b.cross(c);
        for (let corner = 0; corner < 3; ++corner) {
            const at = faces[i + corner];
            c.fromArray(normals, 3 * at)
                .add(b)
                .toArray(normals, 3 * at);
            const to = faces[i + ((corner + 1) % 3)];
            const key = Math.min(at, to) * count + Math.max(at, to);
            uses.set(key, uses.has(key) ? null : [at, to]);
        }
    }
    const doubled = new Float32Array(2 * vertices.length);
    for (let vertex = 0; vertex < count; ++vertex) {
        a.fromArray(normals, 3 * vertex).setLength(thicknessMetres / 2);
        pointAt(vertices, vertex, b)
            .add(a)
            .toArray(doubled, 3 * vertex);
        pointAt(vertices, vertex, b)
            .sub(a)
            .toArray(doubled, 3 * (vertex + count));
    }
    const all = [...faces];
    for (let i = 0; i < faces.length; i += 3)
        all.push(faces[i + 2] + count, faces[i + 1] + count, faces[i] + count);
    for (const edge of uses.values())
        if (edge) {
            const [from, to] = edge;
            all.push(from + count, to + count, to, from + count, to, from);
        }
    return { vertices: doubled, faces: Uint32Array.from(all) };
}

/**
 * Returns places and normals of the corners of all triangles, as Float32Array of nine numbers a
 * triangle, in the mesh's coordinates. Round objects are divided into at most `maximumFaces`
 * (PN triangles with linear normals, bent by three quarters).
 */
export function drawnCorners(mesh, form, maximumFaces) {
    const { vertices, faces } = mesh;
    const faceCount = faces.length / 3;
    const finest = Math.floor(Math.sqrt(maximumFaces / faceCount));
    const parts = form === "turned" ? Math.min(Math.max(finest, 1), 4) : 1;
    const flatNormals = cornerNormals(mesh);
    const places = new Float32Array(9 * parts * parts * faceCount);
    const normals = new Float32Array(places.length);
    const corners = [0, 1, 2].map(() => ({ place: new Vector3(), normal: new Vector3() }));
    const [flat, bent, away, normal] = [0, 1, 2, 3].map(() => new Vector3());
    let written = 0;
    const add = (second, third) => {
        const weights = [(parts - second - third) / parts, second / parts, third / parts];
        flat.set(0, 0, 0);
        normal.set(0, 0, 0);
        corners.forEach((corner, i) => {
            flat.addScaledVector(corner.place, weights[i]);
            normal.addScaledVector(corner.normal, weights[i]);
        });
        bent.copy(flat);
        corners.forEach((corner, i) => {
            const above = corner.normal.dot(away.copy(flat).sub(corner.place));
            bent.addScaledVector(corner.normal, -0.75 * weights[i] * above);
        });
        bent.toArray(places, written);
        normal.normalize().toArray(normals, written);
        written += 3;
    };
    for (let face = 0; face < faceCount; ++face) {
        corners.forEach(({ place, normal: own }, i) => {
            pointAt(vertices, faces[3 * face + i], place);
            own.fromArray(flatNormals, 9 * face + 3 * i);
        });
        for (let i = 0; i < parts; ++i)
            for (let k = 0; i + k < parts; ++k) {
                add(i, k);
                add(i + 1, k);
                add(i, k + 1);
                if (i + k + 1 === parts) continue;
                add(i + 1, k);
                add(i + 1, k + 1);
                add(i, k + 1);
            }
    }
    return { places, normals };
}
