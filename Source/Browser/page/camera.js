// The camera: it orbits the middle of the scene and zooms, and frames all of it at any aspect
// ratio. As Editor/OrbitCamera.cpp does.
import { Box3, Matrix4, PerspectiveCamera, Vector3 } from "three";

const halfFieldRadians = (14 * Math.PI) / 180; // half, vertical
const margin = 1.06;
const [minimumZoom, maximumZoom] = [0.2, 20];
const [lowestElevation, highestElevation] = [0.03, 1.5];
const initial = { around: -0.2, elevation: 0.62, zoom: 1 };

const clamp = (value, minimum, maximum) => Math.min(Math.max(value, minimum), maximum);

export class OrbitCamera {
    #points = [new Vector3()];
    #middle = new Vector3();
    #reach = 1;
    #view = { ...initial };

    /** For three.js; `update` sets it. */
    camera = new PerspectiveCamera((2 * halfFieldRadians * 180) / Math.PI);
    viewProjection = new Matrix4();

    constructor() {
        this.camera.matrixAutoUpdate = false;
    }

    /** Frames points, which are not empty. Keeps turn and zoom. */
    lookAt(points) {
        this.#points = points;
        const box = new Box3().setFromPoints(points);
        box.getCenter(this.#middle);
        this.#reach = Math.max(box.max.distanceTo(box.min) / 2, 1e-4);
    }

    turnBy(aroundRadians, upRadians) {
        this.#view.around += aroundRadians;
        this.#view.elevation = clamp(
            this.#view.elevation + upRadians,
            lowestElevation,
            highestElevation,
        );
    }

    /** A factor above 1 moves nearer. */
    zoomBy(factor) {
        this.#view.zoom = clamp(this.#view.zoom * factor, minimumZoom, maximumZoom);
    }

    reset() {
        this.#view = { ...initial };
    }

    /**
     * Moves each of the four planes of the frustum until it touches a point. Two opposite planes meet
     * in an edge: the eye cannot be nearer than this edge.
     */
    update(aspect) {
        const { around, elevation, zoom } = this.#view;
        const forward = new Vector3(
            Math.cos(elevation) * Math.sin(-around),
            Math.cos(elevation) * Math.cos(around),
            -Math.sin(elevation),
        );
        const right = new Vector3(Math.cos(around), Math.sin(around), 0);
        const up = right.clone().cross(forward);
        const slopeY = Math.tan(halfFieldRadians) / margin;
        const slopeX = slopeY * aspect;
        let [fromLeft, fromRight, fromBelow, fromAbove] = [Infinity, -Infinity, Infinity, -Infinity];
        for (const point of this.#points) {
            const [x, y, z] = [point.dot(right), point.dot(up), point.dot(forward)];
            fromLeft = Math.min(fromLeft, x + slopeX * z);
            fromRight = Math.max(fromRight, x - slopeX * z);
            fromBelow = Math.min(fromBelow, y + slopeY * z);
            fromAbove = Math.max(fromAbove, y - slopeY * z);
        }
        const z = Math.min((fromLeft - fromRight) / slopeX, (fromBelow - fromAbove) / slopeY) / 2;
        const middleDepth = this.#middle.dot(forward);
        const depth = Math.max(middleDepth - z, 1e-4) / zoom;
        const eye = right
            .clone()
            .multiplyScalar((fromLeft + fromRight) / 2)
            .addScaledVector(up, (fromBelow + fromAbove) / 2)
            .addScaledVector(forward, middleDepth - depth);
        const { camera } = this;
        camera.aspect = aspect;
        camera.far = depth + 1.1 * this.#reach;
        camera.near = Math.max(depth - 1.1 * this.#reach, camera.far / 2000);
        camera.updateProjectionMatrix();
        camera.matrix.makeBasis(right, up, forward.negate()).setPosition(eye);
        camera.position.copy(eye);
        camera.updateMatrixWorld(true);
        this.viewProjection.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    }
}
