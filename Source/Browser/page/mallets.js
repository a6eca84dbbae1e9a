// The mallets that strike: they come from the player's side, touch, and swing back. As
// Editor/MalletSwings.cpp and MalletAppearance.h.
import { Quaternion, Vector3 } from "three";

import { channelsOf } from "./appearance.js";
import { FurnitureParts } from "./furnitureParts.js";

const maximumMallets = 6;
const [contactSeconds, swingSeconds] = [0.04, 1]; // one frame shows the contact
const backSeconds = 0.25; // until a mallet may strike again
const [riseSeconds, leaveSeconds] = [0.09, 0.55];
const stickRadius = 0.0042;
const [longestStickMetres, stickShare] = [0.38, 1.1];
const birch = { finish: "wood", colour: [0.8, 0.66, 0.46] };

const upwards = new Vector3(0, 0, 1);

/** The height of the head above the surface, as a share of the stick. */
function heightAt(age, strength) {
    const risen = 1 - Math.exp(-Math.max(age - contactSeconds, 0) / riseSeconds);
    const leaving = Math.max(age - leaveSeconds, 0) / (swingSeconds - leaveSeconds);
    return (0.1 + 0.16 * strength) * risen + 1.6 * leaving * leaving;
}

function lookOf({ name, effective_modulus_pa: modulus, force_exponent: exponent, colour }) {
    let finish = "plastic";
    if (exponent > 2) finish = "cloth";
    else if (modulus > 1e10) finish = "metal";
    else if (name === "Wood") finish = "wood";
    return { finish, colour: channelsOf(colour) };
}

export class Mallets {
    #build;
    #swings = [];
    #side = 1;
    #pairs = []; // of meshes: head, stick
    #stickMetres = longestStickMetres;
    #headMetres = 0.0125;

    /** `build(part)` makes a mesh of a part (furnitureParts.js). */
    constructor(build) {
        this.#build = build;
    }

    /** Starts anew in a scene of a radius in metres, with a mallet of mallets.json. Returns the meshes. */
    reset({ mallet, headMetres }, reachMetres) {
        this.#swings = [];
        this.#stickMetres = Math.min(longestStickMetres, stickShare * reachMetres);
        const parts = new FurnitureParts();
        parts.addBall(new Vector3(), 1, 24);
        const head = parts.finish(lookOf(mallet));
        parts.addRod(new Vector3(), upwards, 1, 1, 12);
        const stick = parts.finish(birch);
        this.#headMetres = headMetres;
        const mesh = part => {
            const built = this.#build(part);
            built.visible = false;
            built.frustumCulled = false;
            return built;
        };
        this.#pairs = Array.from({ length: maximumMallets }, () => ({
            head: mesh(head),
            stick: mesh(stick),
        }));
        return this.#pairs.flatMap(pair => [pair.head, pair.stick]);
    }

    /** A strike at a place of the picture with a surface normal; `strength` from 0 to 1. */
    strike(place, normal, strength) {
        const [first] = this.#swings;
        if (first && (first.age > backSeconds || this.#swings.length >= maximumMallets)) {
            this.#side = first.side;
            this.#swings.shift();
        }
        this.#swings.push({ place: place.clone(), normal, strength, side: this.#side, age: 0 });
        this.#side = -this.#side;
    }

    /** Returns whether mallets are seen. */
    advance(seconds) {
        for (const swing of this.#swings) swing.age += seconds;
        this.#swings = this.#swings.filter(({ age }) => age < swingSeconds);
        this.#pairs.forEach((pair, i) => this.#pose(pair, this.#swings[i]));
        return this.#swings.length > 0;
    }

    /** The hand is on the player's side, above the surface, and rises less than the head. */
    #pose({ head, stick }, swing) {
        head.visible = stick.visible = swing !== undefined;
        if (!swing) return;
        const { place, normal, strength, side, age } = swing;
        const reach = new Vector3(0.26 * side, -0.92, 0.06).addScaledVector(normal, 0.16);
        reach.addScaledVector(normal, Math.max(0.3 - reach.dot(normal), 0)).normalize();
        const height = this.#stickMetres * heightAt(age, strength);
        const touching = place.clone().addScaledVector(normal, this.#headMetres);
        const hand = touching.clone().addScaledVector(reach, this.#stickMetres);
        hand.addScaledVector(normal, 0.3 * height);
        const middle = touching.addScaledVector(normal, height);
        const turn = new Quaternion().setFromUnitVectors(upwards, hand.sub(middle).normalize());
        const sizes = [
            [head, new Vector3().setScalar(this.#headMetres)],
            [stick, new Vector3(stickRadius, stickRadius, this.#stickMetres)],
        ];
        for (const [mesh, size] of sizes) {
            mesh.matrix.compose(middle, turn, size);
            mesh.matrixWorldNeedsUpdate = true;
        }
    }
}
