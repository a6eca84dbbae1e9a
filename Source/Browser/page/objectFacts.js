// What the picture needs of an object beside its mesh: its own material, the thickness of a shell,
// what is held, and the tube under a bar. Read from its .modal file (docs/modal-format.md).
import { boxOf } from "./geometry.js";

const none = { material: null, thicknessMetres: 0, clamp: null, tubeHz: 0 };

function tensorsOf(bytes) {
  const headerSize = Number(new DataView(bytes).getBigUint64(0, true));
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 8, headerSize)));
  const types = { F64: Float64Array, F32: Float32Array, I32: Int32Array };
  const tensor = (name) => {
    if (!header[name]) return null;
    const [begin, end] = header[name].data_offsets;
    return new types[header[name].dtype](bytes.slice(8 + headerSize + begin, 8 + headerSize + end));
  };
  return { metadata: header.__metadata__, tensor };
}

/** Returns the frequency of the mode that a bar shares with its tube, or 0. */
function tubeHzOf(eigenvalues, gains) {
  const shared = gains ? eigenvalues.findIndex((_, i) => gains[2 * i] !== 1 || gains[2 * i + 1] !== 0) : -1;
  return shared < 0 ? 0 : Math.sqrt(eigenvalues[shared]) / (2 * Math.PI);
}

/** `bytes` is an ArrayBuffer of a .modal file that the instrument has accepted. */
function factsOf(bytes) {
  const { metadata, tensor } = tensorsOf(bytes);
  const vertices = tensor("vertices");
  const clamped = tensor("clamped_vertices");
  const held = clamped && [...clamped].flatMap((at) => [...vertices.subarray(3 * at, 3 * at + 3)]);
  return {
    material: JSON.parse(metadata.material),
    thicknessMetres: metadata.body === "shell" ? JSON.parse(metadata.geometry).thickness_m : 0,
    clamp: held?.length ? boxOf(held) : null,
    tubeHz: tubeHzOf(tensor("eigenvalues"), tensor("gains")),
  };
}

export class ObjectFacts {
  #base;
  #known = new Map(); // name to a promise of its facts

  /** `base`: the folder of factory objects. */
  constructor(base) {
    this.#base = base;
  }

  /** Takes the bytes of a file that the visitor gave. A .glb has no facts. */
  remember(name, bytes) {
    const isModal = new Uint8Array(bytes, 0, 4).join() !== "103,108,84,70"; // "glTF"
    this.#known.set(name, Promise.resolve(isModal ? factsOf(bytes) : none));
  }

  /** The package has fetched a factory object's file just before, so it comes from the cache. */
  of(name) {
    if (!this.#known.has(name)) {
      const url = new URL(`${encodeURIComponent(name)}.modal`, this.#base);
      const facts = fetch(url, { cache: "force-cache" })
        .then((answer) => (answer.ok ? answer.arrayBuffer().then(factsOf) : none))
        .catch(() => none);
      this.#known.set(name, facts);
    }
    return this.#known.get(name);
  }
}
