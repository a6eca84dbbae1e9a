// The lamp's shadow map, and the light on the floor, which is summed over directions of lamp and
// sky a few at a time. As Editor/SceneLight.cpp and FloorLight.cpp do on the processor.
import {
    AdditiveBlending,
    BufferAttribute,
    BufferGeometry,
    Camera,
    DepthTexture,
    DoubleSide,
    GLSL3,
    HalfFloatType,
    LessEqualCompare,
    LinearFilter,
    Matrix4,
    Mesh,
    MeshBasicMaterial,
    NearestFilter,
    RawShaderMaterial,
    Scene,
    UnsignedIntType,
    Vector2,
    Vector3,
    Vector4,
    WebGLRenderTarget,
} from "three";

/** Meshes on these layers cast shadows: those at rest, and those that move. */
export const [casterLayer, moverLayer] = [1, 2];

const lamp = new Vector3(-0.449, 0.323, 0.833).normalize(); // as in lighting.glsl
const lampRadius = 0.13; // tangent of half the lamp's angle
const [lampDirections, skyDirections, directionsAtOnce] = [20, 40, 4];
const longestSide = 288; // texels of the floor

const vertexShader = `
in vec3 position;
void main() { gl_Position = vec4(position, 1.0); }`;

const sumShader = `precision highp float;
precision highp sampler2DShadow;
uniform sampler2DShadow depths;
uniform mat4 from;
uniform vec4 area; // left, front, width, depth
uniform float height;
uniform vec2 texels;
uniform vec2 share; // of the lamp, of the sky
out vec4 sum;
void main()
{
    vec2 at = area.xy + area.zw * gl_FragCoord.xy / texels;
    vec3 onMap = (from * vec4(at, height, 1.0)).xyz * 0.5 + 0.5;
    bool beside = any(lessThan(onMap.xy, vec2(0.0))) || any(greaterThan(onMap.xy, vec2(1.0)));
    sum = vec4(share * (beside ? 1.0 : texture(depths, onMap)), 0.0, 0.0);
}`;

// Averages each texel with its neighbours, which hides the steps between directions.
const blurShader = `precision highp float;
uniform sampler2D sums;
out vec4 light;
void main()
{
    ivec2 most = textureSize(sums, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
            sum += texelFetch(sums, clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), most), 0);
    light = sum / 25.0;
}`;

/** Points of a unit disc, evenly spread (Vogel's spiral). */
function discPoint(index, count) {
    const radius = Math.sqrt((index + 0.5) / count);
    const angle = index * Math.PI * (3 - Math.sqrt(5));
    return new Vector2(radius * Math.cos(angle), radius * Math.sin(angle));
}

/** Two unit vectors across a unit vector and each other. */
function axesAcross(along) {
    const aside = Math.abs(along.z) > 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 0, 1);
    const right = aside.cross(along).normalize();
    return { right, up: along.clone().cross(right) };
}

function depthTarget(size) {
    const depthTexture = new DepthTexture(size, size, UnsignedIntType);
    depthTexture.compareFunction = LessEqualCompare;
    depthTexture.minFilter = depthTexture.magFilter = LinearFilter;
    return new WebGLRenderTarget(size, size, { depthTexture });
}

function screenTriangle(material) {
    const geometry = new BufferGeometry();
    const corners = new Float32Array([-1, -1, 0, 3, -1, 0, -1, 3, 0]);
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    const mesh = new Mesh(geometry, material);
    mesh.frustumCulled = false;
    return mesh;
}

export class SceneLight {
    #renderer;
    #shadows = depthTarget(2048);
    #depths = depthTarget(512);
    #sums = null;
    #floor = null;
    #camera = new Camera();
    #caster = new MeshBasicMaterial({ side: DoubleSide, colorWrite: false, polygonOffset: true });
    #next = 0; // direction
    #sum = new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader: sumShader,
        blending: AdditiveBlending,
        premultipliedAlpha: true,
        depthTest: false,
        uniforms: {
            depths: { value: null },
            from: { value: new Matrix4() },
            area: { value: new Vector4() },
            height: { value: 0 },
            texels: { value: new Vector2() },
            share: { value: new Vector2() },
        },
    });
    #blur = new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader: blurShader,
        depthTest: false,
        uniforms: { sums: { value: null } },
    });
    #screen = new Scene();
    #triangle = screenTriangle(this.#sum);

    /** Left, front, width and depth of the lit floor in metres. */
    area = new Vector4(0, 0, 1, 1);
    middle = new Vector3();
    reach = 1; // radius of the scene in metres
    shadowFrom = new Matrix4();

    constructor(renderer) {
        this.#renderer = renderer;
        this.#camera.layers.set(casterLayer);
        this.#triangle.layers.set(casterLayer);
        this.#screen.add(this.#triangle);
    }

    get shadowMap() {
        return this.#shadows.depthTexture;
    }
    get shadowTexel() {
        return (2 * this.reach) / this.#shadows.width;
    }
    /** Whether `floorLight` has the scene's light. */
    get isComplete() {
        return this.#next >= lampDirections + skyDirections;
    }
    get floorLight() {
        return this.#floor?.texture ?? null;
    }

    /** Begins with a scene's extent (Box3) and the height of its floor, in metres. */
    begin(extent, floorHeight) {
        const { min: minimum, max: maximum } = extent;
        extent.getCenter(this.middle);
        this.reach = Math.max(maximum.distanceTo(minimum) / 2, 1e-4);
        const size = extent.getSize(new Vector3());
        const margin = 0.2 * this.reach + 1.5 * size.z;
        const [width, depth] = [size.x + 2 * margin, size.y + 2 * margin];
        this.area.set(minimum.x - margin, minimum.y - margin, width, depth);
        const texel = Math.max(width, depth) / longestSide;
        const [columns, rows] = [Math.ceil(width / texel), Math.ceil(depth / texel)];
        this.#sums?.dispose();
        this.#floor?.dispose();
        const options = { type: HalfFloatType, depthBuffer: false };
        this.#sums = new WebGLRenderTarget(columns, rows, { ...options, minFilter: NearestFilter });
        this.#floor = new WebGLRenderTarget(columns, rows, options);
        this.#next = 0;
        const { uniforms } = this.#sum;
        uniforms.area.value.copy(this.area);
        uniforms.height.value = floorHeight;
        uniforms.texels.value.set(columns, rows);
    }

    /** Draws the depths seen from the lamp. */
    drawShadows(scene) {
        this.#camera.layers.enable(moverLayer);
        this.#drawDepths(scene, lamp, this.#shadows);
        this.#camera.layers.disable(moverLayer);
        this.shadowFrom.copy(this.#camera.projectionMatrix);
    }

    /** Adds the light from the next few directions; `scene` must be the one of `begin`. */
    addLight(scene) {
        const { right, up } = axesAcross(lamp);
        const { uniforms } = this.#sum;
        for (let i = 0; i < directionsAtOnce && !this.isComplete; ++i) {
            const isFirst = this.#next === 0;
            const fromLamp = this.#next < lampDirections;
            const index = fromLamp ? this.#next : this.#next - lampDirections;
            const direction = new Vector3();
            if (fromLamp) {
                const at = discPoint(index, lampDirections).multiplyScalar(lampRadius);
                direction.copy(lamp).addScaledVector(right, at.x).addScaledVector(up, at.y).normalize();
            } else {
                // Denser towards the zenith, as light from an even sky on the floor is.
                const at = discPoint(index, skyDirections);
                direction.set(at.x, at.y, Math.sqrt(1 - at.lengthSq()));
            }
            this.#drawDepths(scene, direction, this.#depths);
            uniforms.depths.value = this.#depths.depthTexture;
            uniforms.from.value.copy(this.#camera.projectionMatrix);
            uniforms.share.value.set(
                fromLamp ? 1 / lampDirections : 0,
                fromLamp ? 0 : 1 / skyDirections,
            );
            this.#drawScreen(this.#sum, this.#sums, isFirst);
            ++this.#next;
        }
        if (!this.isComplete) return;
        this.#blur.uniforms.sums.value = this.#sums.texture;
        this.#drawScreen(this.#blur, this.#floor, true);
    }

    #drawDepths(scene, towards, target) {
        const { right, up } = axesAcross(towards);
        const rows = [right, up, towards.clone().negate()].flatMap(axis => [
            ...axis.clone().divideScalar(this.reach),
            -axis.dot(this.middle) / this.reach,
        ]);
        this.#camera.projectionMatrix.set(...rows, 0, 0, 0, 1);
        this.#camera.projectionMatrixInverse.copy(this.#camera.projectionMatrix).invert();
        this.#caster.polygonOffsetFactor = 2;
        this.#caster.polygonOffsetUnits = 4;
        scene.overrideMaterial = this.#caster;
        this.#renderer.setRenderTarget(target);
        this.#renderer.clear();
        this.#renderer.render(scene, this.#camera);
        this.#renderer.setRenderTarget(null);
        scene.overrideMaterial = null;
    }

    #drawScreen(material, target, clears) {
        this.#triangle.material = material;
        this.#renderer.setRenderTarget(target);
        if (clears) this.#renderer.clear();
        this.#renderer.render(this.#screen, this.#camera);
        this.#renderer.setRenderTarget(null);
    }
}
