// Builds what stands around the objects from simple bodies: beams, rods, pipes, rings and discs.
// It cannot be struck. Lengths in metres. As Editor/FurnitureParts.cpp does.
import { Vector3 } from "three";

const vector = (x, y, z) => new Vector3(x, y, z);
const upwards = vector(0, 0, 1);

/** Two axes across a direction; an upright direction gets x and y. */
function axesAcross(along) {
    const first = Math.abs(along.z) > 0.99 ? vector(1, 0, 0) : along.clone().cross(upwards).normalize();
    return { first, second: along.clone().cross(first) };
}

function around({ first, second }, step, sides) {
    const angle = (2 * Math.PI * step) / sides;
    return first.clone().multiplyScalar(Math.cos(angle)).addScaledVector(second, Math.sin(angle));
}

const moved = (from, direction, metres) => from.clone().addScaledVector(direction, metres);

export class FurnitureParts {
    /** `places` and `normals`: nine numbers a triangle. `look`: finish and colour (appearance.js). */
    parts = [];
    #places = [];
    #normals = [];

    addBeam(from, to, width, height, up = upwards) {
        const along = to.clone().sub(from).normalize();
        const side = along.clone().cross(up).normalize();
        const top = side.clone().cross(along).normalize();
        const corner = (x, y, z) => {
            const place = moved(x ? to : from, side, (y ? 0.5 : -0.5) * width);
            return place.addScaledVector(top, (z ? 0.5 : -0.5) * height);
        };
        const addSide = (...bits) => {
            const [a, b, c, d] = bits.map(bit => corner(bit & 4, bit & 2, bit & 1));
            this.#addFace(a, b, c);
            this.#addFace(a, c, d);
        };
        addSide(1, 3, 7, 5);
        addSide(2, 0, 4, 6);
        addSide(3, 2, 6, 7);
        addSide(0, 1, 5, 4);
        addSide(0, 2, 3, 1);
        addSide(6, 4, 5, 7);
    }

    /** A round bar with closed ends, which may taper. */
    addRod(from, to, fromRadius, toRadius, sides) {
        const along = to.clone().sub(from).normalize();
        this.#addWall(from, to, fromRadius, toRadius, sides, false);
        this.#addCap(from, along.clone().negate(), fromRadius, sides);
        this.#addCap(to, along, toRadius, sides);
    }

    /** An upright pipe, open above and closed below. */
    addPipe(top, length, radius, wall, sides) {
        const bottom = moved(top, upwards, -length);
        const floor = moved(bottom, upwards, wall);
        const inner = radius - wall;
        this.#addWall(bottom, top, radius, radius, sides, false);
        this.#addWall(floor, top, inner, inner, sides, true);
        this.#addCap(bottom, vector(0, 0, -1), radius, sides);
        this.#addCap(floor, upwards, inner, sides);
        const axes = axesAcross(upwards);
        for (let step = 0; step < sides; ++step) {
            const [left, right] = [around(axes, step, sides), around(axes, step + 1, sides)];
            const rim = [moved(top, left, inner), moved(top, left, radius)];
            rim.push(moved(top, right, radius), moved(top, right, inner));
            this.#addQuad(rim, Array(4).fill(upwards));
        }
    }

    /** A lying ring of round section. */
    addRing(middle, radius, thickness, sides) {
        const section = 10;
        const axes = axesAcross(upwards);
        const normal = (step, turn) => {
            const angle = (2 * Math.PI * turn) / section;
            const out = around(axes, step, sides).multiplyScalar(Math.cos(angle));
            return out.addScaledVector(upwards, Math.sin(angle));
        };
        for (let step = 0; step < sides; ++step)
            for (let turn = 0; turn < section; ++turn) {
                const corners = [
                    [0, 0],
                    [1, 0],
                    [1, 1],
                    [0, 1],
                ].map(([s, t]) => [step + s, turn + t]);
                const normals = corners.map(([s, t]) => normal(s, t));
                const places = corners.map(([s], i) =>
                    moved(moved(middle, around(axes, s, sides), radius), normals[i], thickness / 2),
                );
                this.#addQuad(places, normals);
            }
    }

    /** A thin round plate, which faces along `normal`. */
    addDisc(middle, normal, radius, thickness, sides) {
        const [below, above] = [-thickness / 2, thickness / 2].map(away => moved(middle, normal, away));
        this.addRod(below, above, radius, radius, sides);
    }

    addBall(middle, radius, sides) {
        const rings = sides / 2;
        const axes = axesAcross(upwards);
        const normal = (step, ring) => {
            const angle = (Math.PI * ring) / rings;
            const out = around(axes, step, sides).multiplyScalar(Math.sin(angle));
            return out.addScaledVector(upwards, -Math.cos(angle));
        };
        for (let step = 0; step < sides; ++step)
            for (let ring = 0; ring < rings; ++ring) {
                const corners = [
                    [0, 0],
                    [1, 0],
                    [1, 1],
                    [0, 1],
                ];
                const normals = corners.map(([s, r]) => normal(step + s, ring + r));
                this.#addQuad(
                    normals.map(each => moved(middle, each, radius)),
                    normals,
                );
            }
    }

    /** Ends the part of all that was added since the last one. */
    finish(look, form = "free") {
        this.parts.push({
            places: Float32Array.from(this.#places),
            normals: Float32Array.from(this.#normals),
            look,
            form,
        });
        this.#places = [];
        this.#normals = [];
        return this.parts.at(-1);
    }

    #add(place, normal) {
        this.#places.push(place.x, place.y, place.z);
        this.#normals.push(normal.x, normal.y, normal.z);
    }

    #addFace(a, b, c) {
        const normal = b.clone().sub(a).cross(c.clone().sub(a)).normalize();
        for (const place of [a, b, c]) this.#add(place, normal);
    }

    #addQuad(places, normals) {
        for (const corner of [0, 1, 2, 0, 2, 3]) this.#add(places[corner], normals[corner]);
    }

    #addWall(from, to, fromRadius, toRadius, sides, isInward) {
        const axes = axesAcross(to.clone().sub(from).normalize());
        for (let step = 0; step < sides; ++step) {
            const [left, right] = [around(axes, step, sides), around(axes, step + 1, sides)];
            const places = [moved(from, left, fromRadius), moved(from, right, fromRadius)];
            places.push(moved(to, right, toRadius), moved(to, left, toRadius));
            const normals = [left, right, right, left];
            if (isInward)
                this.#addQuad(
                    places.reverse(),
                    normals.map(normal => normal.clone().negate()),
                );
            else this.#addQuad(places, normals);
        }
    }

    #addCap(middle, normal, radius, sides) {
        const axes = axesAcross(normal);
        for (let step = 0; step < sides; ++step)
            this.#addFace(
                middle,
                moved(middle, around(axes, step, sides), radius),
                moved(middle, around(axes, step + 1, sides), radius),
            );
    }
}
