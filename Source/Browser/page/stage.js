// Draws the picture: shadows, solids, floor and backdrop, then glass. Draws a frame only when
// something has changed.
import {
    BufferAttribute,
    BufferGeometry,
    DataTexture,
    Mesh,
    Raycaster,
    Scene,
    Vector2,
    Vector3,
    WebGLRenderer,
} from "three";

import { OrbitCamera } from "./camera.js";
import { SceneLight, casterLayer, moverLayer } from "./light.js";
import { linear } from "./shaders.js";

const slowSeconds = 0.07; // of a frame
const minimumSharpness = 0.4;
const longestStepSeconds = 0.1;
const restMilliseconds = 300; // without motion, until a sharp picture

/** A floor without shadows. */
const fullLight = new DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
fullLight.needsUpdate = true;

export class Stage {
    #canvas;
    #renderer;
    #light;
    #shaders;
    #scene = new Scene();
    #raycaster = new Raycaster();
    #parts = [];
    #movers = [];
    #movesCasters = false;
    #areShadowsOld = true;
    #isRequested = false;
    #isPictureOld = true;
    #before = 0;
    #isMoving = false; // the last frame asked for this one
    #sharpness = 1; // share of the screen's resolution while something moves
    #slowFrames = 0;
    #isStill = false; // the next frame is sharp
    #rest = 0; // timer

    orbit = new OrbitCamera();
    /** Advances what moves by seconds, before a frame. Returns whether it goes on, and what moves. */
    onframe = () => ({ goesOn: false, movesMallets: false });

    /** Throws if there is no WebGL 2. */
    constructor(canvas, shaders) {
        this.#canvas = canvas;
        this.#shaders = shaders;
        this.#renderer = new WebGLRenderer({ canvas, antialias: true });
        this.#renderer.autoClear = false;
        this.#light = new SceneLight(this.#renderer);
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new BufferAttribute(new Float32Array(9), 3));
        const backdrop = new Mesh(geometry, shaders.backdrop);
        backdrop.frustumCulled = false;
        backdrop.renderOrder = 1; // behind the solids, whose pixels it need not compute
        this.#scene.add(backdrop);
        new ResizeObserver(() => this.requestFrame()).observe(canvas);
    }

    /**
     * Shows meshes instead of the former ones. `extent` is a Box3 in metres, and `movesCasters` says
     * whether bodies move, so that shadows are drawn anew for each frame.
     */
    show(meshes, extent, floorHeight, movesCasters) {
        this.#parts = this.#exchange(this.#parts, meshes, casterLayer);
        this.#movesCasters = movesCasters;
        this.setExtent(extent, floorHeight);
    }

    /** Shows a further mesh. */
    add(mesh) {
        this.#parts = [...this.#parts, ...this.#exchange([], [mesh], casterLayer)];
        this.requestFrame();
    }

    /** Shows meshes that move, as mallets do, instead of the former ones. */
    showMovers(meshes) {
        this.#movers = this.#exchange(this.#movers, meshes, moverLayer);
        this.requestFrame();
    }

    /** Lights another extent and height of the floor, in metres. */
    setExtent(extent, floorHeight) {
        this.#light.begin(extent, floorHeight);
        this.#shaders.backdrop.uniforms.floorHeight.value = floorHeight;
        this.#areShadowsOld = true;
        this.requestFrame();
    }

    /** Exchanges the material of a shown mesh. */
    setMaterial(mesh, material) {
        mesh.material.dispose();
        mesh.material = material;
        mesh.layers.set(0);
        if (!material.transparent) mesh.layers.enable(casterLayer);
        this.#areShadowsOld = true;
        this.requestFrame();
    }

    /** Colours are as on the screen, three channels from 0 to 1. */
    setLook({ isDark, panel, accent }) {
        const { shared } = this.#shaders;
        shared.dark.value = isDark ? 1 : 0;
        shared.backdrop.value.copy(linear(panel));
        shared.accent.value.copy(linear(accent));
        shared.ink.value.set(...panel);
        this.requestFrame();
    }

    requestFrame() {
        this.#isPictureOld = true;
        this.#request();
    }

    #request() {
        if (this.#isRequested) return;
        this.#isRequested = true;
        requestAnimationFrame(now => this.#frame(now));
    }

    /** Returns the nearest hit of three.js under a point of the window, or undefined. */
    pick(clientX, clientY, meshes) {
        const area = this.#canvas.getBoundingClientRect();
        const x = (2 * (clientX - area.left)) / area.width - 1;
        const y = 1 - (2 * (clientY - area.top)) / area.height;
        this.#raycaster.setFromCamera(new Vector2(x, y), this.orbit.camera);
        return this.#raycaster.intersectObjects(meshes, false)[0];
    }

    #frame(now) {
        this.#isRequested = false;
        const { clientWidth: width, clientHeight: height } = this.#canvas;
        if (width === 0 || height === 0) return;
        const seconds = (now - this.#before) / 1000;
        this.#before = now;
        this.#adaptSharpness(seconds);
        const { goesOn, movesMallets } = this.onframe(Math.min(seconds, longestStepSeconds));
        if (this.#isPictureOld) this.#draw(width, height, movesMallets);
        this.#isPictureOld = this.#isMoving = goesOn;
        const isLightOld = this.#parts.length > 0 && !this.#movesCasters && !this.#light.isComplete;
        if (isLightOld && !goesOn) {
            this.#light.addLight(this.#scene);
            this.#isPictureOld = this.#light.isComplete;
        }
        if (goesOn || isLightOld) this.#request();
    }

    #draw(width, height, movesMallets) {
        const ratio = this.#fullRatio() * (this.#isStill ? 1 : this.#sharpness);
        this.#isStill = false;
        this.#resize(width, height, ratio);
        this.orbit.update(width / height);
        this.#drawShadows(movesMallets);
        this.#setUniforms();
        this.#renderer.clear();
        this.#renderer.render(this.#scene, this.orbit.camera);
        clearTimeout(this.#rest);
        if (ratio < this.#fullRatio()) this.#drawStillLater();
    }

    #exchange(former, meshes, layer) {
        for (const mesh of former) {
            this.#scene.remove(mesh);
            mesh.geometry.dispose();
            mesh.material.dispose();
        }
        for (const mesh of meshes) {
            if (!mesh.material.transparent) mesh.layers.enable(layer);
            this.#scene.add(mesh);
        }
        return meshes;
    }

    /** A slow processor draws fewer points, and no shadows of mallets, while something moves. */
    #adaptSharpness(seconds) {
        this.#slowFrames = this.#isMoving && seconds > slowSeconds ? this.#slowFrames + 1 : 0;
        if (this.#slowFrames < 3) return;
        this.#slowFrames = 0;
        this.#sharpness = Math.max(0.7 * this.#sharpness, minimumSharpness);
    }

    #drawStillLater() {
        this.#rest = setTimeout(() => {
            this.#isStill = true;
            this.requestFrame();
        }, restMilliseconds);
    }

    #fullRatio() {
        return Math.min(devicePixelRatio, 2);
    }

    #resize(width, height, ratio) {
        const size = this.#renderer.getSize(new Vector2());
        if (size.x === width && size.y === height && this.#renderer.getPixelRatio() === ratio) return;
        this.#renderer.setPixelRatio(ratio);
        this.#renderer.setSize(width, height, false);
    }

    #drawShadows(movesMallets) {
        const showsMallets = movesMallets && this.#sharpness === 1;
        if (this.#areShadowsOld || this.#movesCasters || showsMallets)
            this.#light.drawShadows(this.#scene);
        this.#areShadowsOld = showsMallets;
    }

    #setUniforms() {
        const { shared, backdrop } = this.#shaders;
        const { camera, viewProjection } = this.orbit;
        shared.eye.value.copy(camera.position);
        shared.viewProjection.value.copy(viewProjection);
        shared.shadowMap.value = this.#light.shadowMap;
        shared.shadowFrom.value.copy(this.#light.shadowFrom);
        shared.shadowTexel.value = this.#light.shadowTexel;
        const { uniforms } = backdrop;
        const rayThrough = (x, y) => new Vector3(x, y, 1).unproject(camera).sub(camera.position);
        const straight = rayThrough(0, 0);
        uniforms.rayMiddle.value.copy(straight);
        uniforms.rayRight.value.copy(rayThrough(1, 0).sub(straight));
        uniforms.rayUp.value.copy(rayThrough(0, 1).sub(straight));
        uniforms.middle.value.copy(this.#light.middle);
        uniforms.reach.value = this.#light.reach;
        const isLit = this.#light.floorLight && this.#light.isComplete && !this.#movesCasters;
        uniforms.floorLight.value = isLit ? this.#light.floorLight : fullLight;
        uniforms.floorArea.value.copy(this.#light.area);
        uniforms.usesMap.value = isLit ? 0 : 1;
    }
}
