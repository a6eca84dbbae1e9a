// The instrument as meshes of the stage: its objects at their places, the furniture around them,
// and their strikes. Points go between an object's own metres and the picture here.
import { Box3, Vector3 } from "three";

import { appearanceOf } from "./appearance.js";
import { Bodies } from "./bodies.js";
import { frameOfBars, furnish } from "./furnishing.js";
import { boxOf } from "./geometry.js";
import { layoutOf } from "./layout.js";
import { Mallets } from "./mallets.js";
import { meshOf, normalAt } from "./meshes.js";
import { StrikeMotion } from "./motion.js";
import { cornersOf, shownObject } from "./shownObject.js";

const maximumFineFaces = 24000; // of all objects together
const fewestBars = 5; // of an instrument on a stage

export class Picture {
    #stage;
    #shaders;
    #library;
    #mayMove;
    #motion = new StrikeMotion();
    #mallets = new Mallets(part => this.#furniture(part, 0));
    #objects = [];
    #bodies = null; // of a scene
    #isFramed = false; // the camera looks at the bodies
    #kind = "single";
    #reach = 1; // radius of the scene in metres

    /** `library`: the materials of materials.json. `mayMove`: returns whether strikes may move. */
    constructor(stage, shaders, library, mayMove) {
        this.#stage = stage;
        this.#shaders = shaders;
        this.#library = library;
        this.#mayMove = mayMove;
        stage.onframe = seconds => {
            const glows = this.#motion.advance(seconds);
            const movesMallets = this.#mallets.advance(seconds);
            return { goesOn: glows || movesMallets, movesMallets };
        };
    }

    /**
     * Shows an instrument (InstrumentInfo, with `lowestNote` and `highestNote` of each object) and the
     * meshes of its objects. `chosen` is the material in effect, or null: each object has its own.
     * `mallet` is the one in effect, `{ mallet, headMetres }`.
     */
    show(info, meshes, chosen, mallet) {
        const sized = info.objects.map((object, i) => ({
            ...object,
            box: boxOf(meshes[i].vertices),
            isClamped: object.clampedVertices.length > 0,
        }));
        const isScene = info.kind === "scene";
        const { kind, placements } = layoutOf(sized, isScene);
        this.#kind = kind;
        this.#objects = info.objects.map((object, i) =>
            shownObject({
                info: object,
                own: meshes[i],
                placement: placements[i],
                look: this.#lookOf(object, chosen),
                maximumFaces: maximumFineFaces / meshes.length,
                swings: kind === "keyboard",
                material: shown => this.#material(shown, i),
            }),
        );
        const { parts, floorHeight } = furnish(kind, this.#objects);
        const build = (part, i = 0) => this.#furniture(part, this.#objects.length + i);
        const materialOf = index => this.#material(this.#objects[index], index);
        this.#bodies = isScene
            ? new Bodies(info.bodies, this.#objects, parts, { build, materialOf })
            : null;
        this.#isFramed = false;
        const shown = isScene
            ? this.#bodies.meshes
            : [...this.#objects.flatMap(object => object.meshes), ...parts.map(build)];
        if (isScene) for (const mesh of shown) mesh.visible = false; // until it has a pose
        this.#stage.orbit.reset();
        this.#stage.orbit.lookAt(this.#objects.flatMap(object => object.corners));
        const boxes = shown.map(({ geometry }) => boxOf(geometry.attributes.position.array));
        const extent = new Box3().setFromPoints(boxes.flatMap(cornersOf));
        this.#reach = extent.max.distanceTo(extent.min) / 2;
        this.#stage.show(shown, extent, floorHeight, isScene);
        this.setMallet(mallet);
        this.#motion.reset(
            this.#objects.map(({ meshes: ofObject, shape, swingMetres }) => ({
                meshes: ofObject,
                radius: shape.half.length(),
                isWhole: isScene,
                swingMetres,
            })),
        );
    }

    /** Recolours the objects for another material in effect. */
    setMaterial(chosen) {
        this.#objects.forEach((object, i) => {
            const look = this.#lookOf(object.info, chosen);
            if (JSON.stringify(look) === JSON.stringify(object.look)) return;
            object.look = look;
            for (const mesh of object.meshes) {
                const material = this.#material(object, i);
                material.uniforms.pose.value = mesh.matrixWorld;
                this.#stage.setMaterial(mesh, material);
            }
        });
    }

    /** Takes the mallet in effect, `{ mallet, headMetres }`. */
    setMallet(mallet) {
        this.#stage.showMovers(this.#mallets.reset(mallet, this.#reach));
    }

    /** Returns the object and the point in its own metres under a place of the window, or null. */
    pick(clientX, clientY) {
        const meshes = this.#objects.flatMap(object => object.meshes.filter(mesh => mesh.visible));
        const hit = this.#stage.pick(clientX, clientY, meshes);
        if (!hit) return null;
        const index = this.#objects.findIndex(object => object.meshes.includes(hit.object));
        const toOwn = hit.object.matrixWorld.clone().multiply(this.#objects[index].placement.matrix);
        const point = hit.point.clone().applyMatrix4(toOwn.invert()).toArray();
        return { object: index, point, place: hit.point, isStage: this.#kind === "stage" };
    }

    /** The note that sets a body in motion: its own key, or else one in the middle. */
    noteOf(index) {
        const { lowestNote, highestNote } = this.#objects[index].info;
        return Math.round((lowestNote + highestNote) / 2);
    }

    /** Shows a strike at a place of the picture; `strength` is 0 to 1. */
    showStrike(index, strength, place) {
        this.showContact(index, strength, place);
        if (this.#kind === "stage" || !this.#mayMove()) return;
        const [mesh] = this.#objects[index].meshes;
        const isBar = this.#kind === "keyboard";
        this.#mallets.strike(place, isBar ? new Vector3(0, 0, 1) : normalAt(mesh, place), strength);
    }

    /** Shows the strike of a key. `along` is the parameter of the position, in percent. */
    showKey(index, strength, note, along) {
        const { info, placement, shape } = this.#objects[index];
        const range = info.highestNote - info.lowestNote;
        const key = range > 0 ? (note - info.lowestNote) / range : 0.5;
        const share = Math.min(Math.max(key + along / 200, 0), 1);
        const place = info.struckPlaces[Math.round(share * (info.struckPlaces.length - 1))];
        const inPicture = place && new Vector3(...place).applyMatrix4(placement.matrix);
        this.showStrike(index, strength, inPicture ?? shape.middle);
    }

    /** Shows that an object sounds from a place, without a mallet. */
    showContact(index, strength, place) {
        if (!this.#mayMove())
            return this.#motion.light(index, strength, () => this.#stage.requestFrame());
        this.#motion.strike(index, place, strength);
        this.#stage.requestFrame();
    }

    /** Takes the poses of a scene's bodies (Idiophone.onposes). */
    setPoses(poses) {
        if (!this.#bodies) return;
        this.#bodies.setPoses(poses);
        if (!this.#isFramed) this.#frameBodies();
        this.#stage.requestFrame();
    }

    /** Frames the first bodies that are there, so that those that fall later do not move the view. */
    #frameBodies() {
        const { corners, bars } = this.#bodies;
        if (corners.length === 0) return;
        this.#isFramed = true;
        const extent = new Box3().setFromPoints(corners);
        let floorHeight = extent.min.z;
        if (bars.length >= fewestBars) {
            const frame = frameOfBars(bars);
            floorHeight = Math.min(floorHeight, frame.floorHeight);
            for (const part of frame.parts) this.#stage.add(this.#furniture(part, 0));
        }
        this.#stage.orbit.lookAt(corners);
        this.#stage.setExtent(extent, floorHeight);
    }

    #lookOf({ material }, chosen) {
        return appearanceOf(chosen ?? material, this.#library);
    }

    #material({ look, shape, isClosed }, seed) {
        return this.#shaders.ofPart({ look, form: shape.form, box: shape, isClosed, seed });
    }

    #furniture(part, seed) {
        const box = boxOf(part.places);
        return meshOf(part, this.#shaders.ofPart({ ...part, box, isClosed: true, seed }));
    }
}
