// The instrument as meshes of the stage: its objects at their places, the furniture around them,
// and the struck places. Points go between an object's own metres and the picture here.
import { BufferAttribute, Matrix4, Quaternion, Vector3 } from "three";

import { appearanceOf } from "./appearance.js";
import { furnish } from "./furnishing.js";
import { boxOf, drawnCorners, formOf, isClosed, thickened } from "./geometry.js";
import { layoutOf } from "./layout.js";
import { Mallets } from "./mallets.js";
import { bendOf, carried, meshOf, normalAt } from "./meshes.js";
import { StrikeMotion } from "./motion.js";

const maximumFineFaces = 24000; // of all objects together
const plain = { finish: "plastic", colour: [0.62, 0.64, 0.67] };

export class Picture {
  #stage;
  #shaders;
  #library;
  #mayMove;
  #motion = new StrikeMotion();
  #mallets = new Mallets((part) => this.#partMesh(part, 0));
  #objects = [];
  #followers = []; // furniture that follows a body
  #framed = []; // corners of bodies
  #reach = 1; // radius of the scene in metres
  #kind = "single";

  /** `library`: the materials of materials.json. `mayMove`: returns whether strikes may move. */
  constructor(stage, shaders, library, mayMove) {
    this.#stage = stage;
    this.#shaders = shaders;
    this.#library = library;
    this.#mayMove = mayMove;
    stage.onframe = (seconds) => {
      const glows = this.#motion.advance(seconds);
      const movesMallets = this.#mallets.advance(seconds);
      return { goesOn: glows || movesMallets, movesMallets };
    };
  }

  /**
   * Shows an instrument (InstrumentInfo). `meshes` and `facts` (objectFacts.js) are of its objects,
   * in order. `chosen` is the material in effect, or null: each object has its own. `mallet` is the
   * one in effect, `{ mallet, headMetres }`.
   */
  show(info, meshes, facts, chosen, mallet) {
    const boxes = meshes.map((mesh) => boxOf(mesh.vertices));
    const { kind, placements } = layoutOf(
      info.objects.map((object, i) => ({ ...object, box: boxes[i], isClamped: facts[i].clamp !== null })),
      info.kind === "scene",
    );
    this.#kind = kind;
    this.#objects = info.objects.map((object, i) => {
      const look = this.#lookOf(facts[i], chosen);
      return this.#object(object, meshes[i], facts[i], placements[i], look, info.objects.length, i);
    });
    const { parts, floorHeight } = furnish(kind, this.#objects);
    this.#followers = [];
    this.#framed = [];
    const furniture = parts.map((part, i) => this.#furniture(part, this.#objects.length + i));
    const shown = [...this.#objects.map(({ mesh }) => mesh), ...furniture];
    const isStage = kind === "stage";
    for (const mesh of shown) mesh.visible = !isStage;
    const corners = this.#objects.flatMap((object) => object.corners);
    this.#stage.orbit.lookAt(corners);
    this.#stage.orbit.reset();
    const extent = this.#extent(shown);
    this.#reach = extent.maximum.distanceTo(extent.minimum) / 2;
    this.#stage.show(shown, extent, floorHeight, isStage);
    this.setMallet(mallet);
    this.#motion.reset(
      this.#objects.map((object) => ({
        mesh: object.mesh,
        radius: object.shape.half.length(),
        isWhole: isStage,
        swingMetres: object.swings ? 0.05 * Math.max(...object.shape.half) : 0,
      })),
    );
  }

  /** Recolours the objects for another material in effect. */
  setMaterial(chosen) {
    this.#objects.forEach((object, i) => {
      const look = this.#lookOf(object.facts, chosen);
      if (JSON.stringify(look) === JSON.stringify(object.look)) return;
      object.look = look;
      const material = this.#material(object, i);
      material.uniforms.pose.value = object.mesh.matrixWorld;
      this.#stage.setMaterial(object.mesh, material);
    });
  }

  /** Takes the mallet in effect, `{ mallet, headMetres }`. */
  setMallet(mallet) {
    this.#stage.showMovers(this.#mallets.reset(mallet, this.#reach));
  }

  /** Returns the object and the point in its own metres under a place of the window, or null. */
  pick(clientX, clientY) {
    const meshes = this.#objects.map(({ mesh }) => mesh).filter((mesh) => mesh.visible);
    const hit = this.#stage.pick(clientX, clientY, meshes);
    if (!hit) return null;
    const index = this.#objects.findIndex(({ mesh }) => mesh === hit.object);
    const object = this.#objects[index];
    const inBody = hit.point.clone().applyMatrix4(object.mesh.matrixWorld.clone().invert());
    const own = inBody.applyMatrix4(object.placement.matrix.clone().invert());
    return { object: index, point: own.toArray(), place: hit.point, isStage: this.#kind === "stage" };
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
    const { mesh } = this.#objects[index];
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

  /** Places the bodies of a scene: eight numbers each, isThere, origin, quaternion xyzw. */
  setPoses(poses) {
    if (this.#kind !== "stage") return;
    const pose = new Matrix4();
    this.#objects.forEach(({ mesh }, i) => {
      const [isThere, x, y, z, ...turn] = poses.subarray(8 * i, 8 * i + 8);
      mesh.visible = Boolean(isThere);
      if (!isThere) return;
      pose.makeRotationFromQuaternion(new Quaternion(...turn)).setPosition(x, y, z);
      mesh.matrix.copy(pose);
      mesh.matrixWorldNeedsUpdate = true;
    });
    for (const { mesh, object } of this.#followers) {
      mesh.visible = this.#objects[object].mesh.visible;
      mesh.matrix.copy(this.#objects[object].mesh.matrix);
      mesh.matrixWorldNeedsUpdate = true;
    }
    this.#frameBodies();
    this.#stage.requestFrame();
  }

  #lookOf(facts, chosen) {
    const material = chosen ?? facts.material;
    return material ? appearanceOf(material, this.#library) : plain;
  }

  #object(info, mesh, facts, placement, look, count, seed) {
    const isOpen = !isClosed(mesh);
    const drawn = isOpen && facts.thicknessMetres > 0 ? thickened(mesh, facts.thicknessMetres) : mesh;
    const form = formOf(drawn.vertices);
    const corners = drawnCorners(drawn, form, maximumFineFaces / count);
    carried(corners, placement.matrix);
    const box = boxOf(corners.places);
    const object = {
      info,
      facts,
      placement,
      look,
      shape: { form, ...box, places: corners.places },
      isClosed: drawn !== mesh || !isOpen,
      swings: count > 1 && this.#kind === "keyboard",
    };
    object.mesh = meshOf(corners, this.#material(object, seed));
    if (object.swings) {
      const bend = bendOf(corners.places, box, facts.clamp !== null);
      object.mesh.geometry.setAttribute("offset", new BufferAttribute(bend, 3));
    }
    object.corners = [-1, 1].flatMap((x) =>
      [-1, 1].flatMap((y) =>
        [-1, 1].map((z) => new Vector3(x, y, z).multiply(box.half).add(box.middle)),
      ),
    );
    return object;
  }

  #material({ look, shape, isClosed }, seed) {
    return this.#shaders.ofPart({ look, form: shape.form, box: shape, isClosed, seed });
  }

  #furniture(part, seed) {
    const mesh = this.#partMesh(part, seed);
    if (part.object !== undefined) this.#followers.push({ mesh, object: part.object });
    return mesh;
  }

  #partMesh(part, seed) {
    const box = boxOf(part.places);
    return meshOf(part, this.#shaders.ofPart({ ...part, box, isClosed: true, seed }));
  }

  /** Frames all bodies of a scene that have been there. */
  #frameBodies() {
    const fresh = this.#objects.filter(({ mesh, isFramed }) => mesh.visible && !isFramed);
    if (fresh.length === 0) return;
    for (const object of fresh) {
      object.isFramed = true;
      const { mesh, corners } = object;
      this.#framed.push(...corners.map((corner) => corner.clone().applyMatrix4(mesh.matrix)));
    }
    const [first, ...rest] = this.#framed;
    const extent = { minimum: first.clone(), maximum: first.clone() };
    for (const point of rest) {
      extent.minimum.min(point);
      extent.maximum.max(point);
    }
    this.#stage.orbit.lookAt(this.#framed);
    this.#stage.setExtent(extent, extent.minimum.z);
  }

  #extent(meshes) {
    const minimum = new Vector3().setScalar(Infinity);
    const maximum = new Vector3().setScalar(-Infinity);
    for (const { geometry } of meshes) {
      geometry.computeBoundingBox();
      minimum.min(geometry.boundingBox.min);
      maximum.max(geometry.boundingBox.max);
    }
    return { minimum, maximum };
  }
}
