// The materials of the picture. Their programs are the ones of the plugin's window
// (Resources/Shaders).
import {
    DoubleSide,
    FrontSide,
    GLSL3,
    LessEqualDepth,
    Matrix4,
    RawShaderMaterial,
    Vector3,
    Vector4,
} from "three";

import { finishes } from "./appearance.js";

const precision = "precision highp float;\nprecision highp sampler2DShadow;\n";

/** Colours of the screen to light; the shaders end with a gamma of 2. */
export const linear = colour => new Vector3(...colour).multiply(new Vector3(...colour));

/** Fetches the programs from the folder `base`. */
export async function fetchShaders(base) {
    const names = ["lighting.glsl", "scene.vert", "scene.frag", "backdrop.vert", "backdrop.frag"];
    const texts = await Promise.all(
        names.map(async name => {
            const answer = await fetch(new URL(name, base));
            if (!answer.ok) throw new Error(`The picture's shader ${name} cannot be fetched.`);
            return answer.text();
        }),
    );
    return new Shaders(...texts);
}

class Shaders {
    #lighting;
    #scene;

    /** Uniforms of all materials. */
    shared = {
        dark: { value: 0 },
        backdrop: { value: new Vector3() },
        eye: { value: new Vector3() },
        viewProjection: { value: new Matrix4() },
        accent: { value: new Vector3() },
        ink: { value: new Vector3() },
        shadowMap: { value: null },
        shadowFrom: { value: new Matrix4() },
        shadowTexel: { value: 1 },
    };

    constructor(lighting, sceneVertex, sceneFragment, backdropVertex, backdropFragment) {
        this.#lighting = precision + lighting;
        this.#scene = { vertex: sceneVertex, fragment: sceneFragment };
        this.backdrop = this.#material(backdropVertex, backdropFragment, {
            rayMiddle: { value: new Vector3() },
            rayRight: { value: new Vector3() },
            rayUp: { value: new Vector3() },
            floorHeight: { value: 0 },
            middle: { value: new Vector3() },
            reach: { value: 1 },
            floorLight: { value: null },
            floorArea: { value: new Vector4(0, 0, 1, 1) },
            usesMap: { value: 1 },
        });
        this.backdrop.depthFunc = LessEqualDepth;
        this.backdrop.depthWrite = false;
    }

    /** `box` has `middle` and `half` in the part's coordinates; `seed` varies wood and stone. */
    ofPart({ look, form, box, isClosed, seed }) {
        const longest = Math.max(...box.half);
        const axis = box.half.toArray().indexOf(longest);
        const thinnest = Math.min(...box.half);
        const material = this.#material(this.#scene.vertex, this.#scene.fragment, {
            pose: { value: new Matrix4() },
            colour: { value: linear(look.colour) },
            boxMiddle: { value: box.middle },
            boxHalf: { value: box.half },
            bevel: { value: form === "box" ? Math.min(0.2 * thinnest, 0.003) : 0 },
            along: { value: new Vector3().setComponent(axis, 1) },
            turned: { value: form === "turned" ? 1 : 0 },
            seed: { value: (seed % 61) + 0.5 },
            glowPlace: { value: new Vector3() },
            glow: { value: 0 },
            glowRadius: { value: 1 },
            offsetScale: { value: 0 },
            nodes: { value: 0 },
        });
        material.defines = { FINISH: finishes.indexOf(look.finish) };
        material.side = isClosed ? FrontSide : DoubleSide;
        if (look.finish === "glass") {
            material.transparent = true; // the far walls, then the near ones
            material.depthWrite = false;
            material.side = DoubleSide;
            material.forceSinglePass = false;
        }
        return material;
    }

    #material(vertexShader, fragmentShader, uniforms) {
        return new RawShaderMaterial({
            glslVersion: GLSL3,
            vertexShader: this.#lighting + vertexShader,
            fragmentShader: this.#lighting + fragmentShader,
            uniforms: { ...uniforms, ...this.shared },
        });
    }
}
