export type PlaceMetres = readonly [number, number, number];

export interface PresetInfo {
    readonly name: string;
    readonly description: string;
    readonly tags: readonly string[];
    readonly kind: "bars" | "zones" | "scaled" | "scene" | "kit";
}

export interface ParameterInfo {
    readonly id: string;
    readonly name: string;
    readonly shortName: string;
    readonly group: string;
    /** Empty if the number has no unit. */
    readonly unit: string;
    readonly scale: "linear" | "logarithmic" | "steps" | "on-off" | "choice" | "cubic";
    readonly minimum: number;
    readonly maximum: number;
    readonly default: number;
    /** Digits after the point; significant digits if logarithmic or cubic. */
    readonly decimals: number;
    /** Presets do not change it. */
    readonly isSetup: boolean;
    readonly description: string;
    /** The names of a choice. */
    readonly choices?: readonly string[];
}

export interface NoteInfo {
    readonly note: number;
    /** An index into `objects`. */
    readonly object: number;
    /** Whether the preset has this key; other keys play resized objects. */
    readonly isOwn: boolean;
}

export interface MaterialInfo {
    readonly name: string;
    readonly youngs_modulus_pa: number;
    readonly density_kg_per_m3: number;
    /** Damping is the sum of three laws: fluid, viscoelastic and by the loss factor. */
    readonly fluid_damping_per_s: number;
    readonly viscoelastic_damping_s: number;
    readonly loss_factor: number;
    /** Whether it is wood, which is stiffer along its grain. */
    readonly hasGrain: boolean;
}

export interface ObjectInfo {
    readonly name: string;
    readonly title: string;
    /** Size at which it plays, divided by its own size. */
    readonly sizeRatio: number;
    readonly modes: number;
    readonly vertexCount: number;
    readonly faceCount: number;
    /** Its own material, with the keys of Idiophone's materials.json. */
    readonly material: MaterialInfo;
    /** The thickness of a shell, whose mesh is its middle surface; 0 for a solid. */
    readonly thicknessMetres: number;
    /** The vertices that are held still. */
    readonly clampedVertices: readonly number[];
    /** The frequency of the mode that a bar shares with its tube; 0 without one. */
    readonly tubeHz: number;
    /** The places where keys strike it, in metres. */
    readonly struckPlaces: readonly PlaceMetres[];
}

export interface InstrumentInfo {
    readonly name: string;
    readonly description: string;
    readonly kind: PresetInfo["kind"];
    readonly lowestNote: number;
    readonly highestNote: number;
    /** All notes that play. */
    readonly notes: readonly NoteInfo[];
    readonly objects: readonly ObjectInfo[];
    /** The object of each body, in the order of the poses of a scene. */
    readonly bodies: readonly number[];
    /** The preset's values, in the order of `Idiophone.parameters`. */
    readonly values: readonly number[];
}

/**
 * An instrument. It is connected to the destination from the start, and silent until it has loaded
 * something. Times are in seconds of the context; what lies in the past acts at once.
 */
export class Idiophone {
    /**
     * Fetches the module, and starts it on the context's audio thread.
     * @param options.base The folder of the package's files, if not the one of this script.
     * @param options.destination The node to connect to, if not the context's destination.
     */
    static start(context: BaseAudioContext,
        options?: { base?: string | URL; destination?: AudioNode }): Promise<Idiophone>;
    private constructor();

    readonly context: BaseAudioContext;
    readonly node: AudioWorkletNode;
    readonly presets: readonly PresetInfo[];
    readonly parameters: readonly ParameterInfo[];
    /** The instrument that plays, or null before the first load. */
    readonly instrument: InstrumentInfo | null;

    /** Plays a factory preset and fetches the objects that it lacks. */
    loadPreset(name: string): Promise<InstrumentInfo>;
    /** Plays a preset file of the plugin, with factory objects or objects of `loadObject`. */
    loadPresetText(json: string): Promise<InstrumentInfo>;
    /**
     * Plays a modal object (.modal, or .glb with a modal model) on all keys. If the file is broken,
     * it rejects with a sentence that begins with the name, and the former sound goes on.
     */
    loadObject(file: Blob | ArrayBuffer | Uint8Array, name: string): Promise<InstrumentInfo>;
    /** Returns copies of an object's vertices in metres, z up, and of its triangles. */
    mesh(object: number): { vertices: Float32Array; faces: Uint32Array };

    /** Velocity is 1 to 127. */
    noteOn(note: number, velocity?: number, time?: number): void;
    noteOff(note: number, time?: number): void;
    /** Sends a MIDI channel message. */
    send(bytes: ArrayLike<number>, time?: number): void;
    /**
     * Strikes an object at the place nearest to a point, in metres of its mesh. Velocity is 1 to
     * 127; 0 lifts the hand, which holds the object until then.
     */
    strike(object: number, point: PlaceMetres, velocity: number): void;
    /** Drags a hand over an object. Pressure is 0 to 1; 0 lifts the hand. */
    scrape(object: number, point: PlaceMetres, pressure: number): void;
    /** Sets a parameter in its unit; values outside its range are limited. */
    set(id: string, value: number): void;
    get(id: string): number;
    /** Silences everything, and drops what is scheduled. */
    silence(): void;

    /** Resolves when the audio thread has seen all calls so far. Wait for it before an
     * OfflineAudioContext renders. */
    settled(): Promise<void>;
    /** Resolves to the share of real time that the audio thread has spent since the last call. */
    cpuReport(): Promise<{ share: number; quanta: number }>;
    /** Disconnects the instrument for good. */
    stop(): void;

    /**
     * Called some 50 times a second while a scene plays. Each of its bodies has eight numbers: 1 if it
     * is there, else 0; its origin in metres; its turn as a quaternion x, y, z, w.
     */
    onposes: ((poses: Float32Array) => void) | null;
}
