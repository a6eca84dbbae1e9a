// Idiophone for web pages: an instrument as a node of the Web Audio API.
//
//     const idiophone = await Idiophone.start(new AudioContext());
//     await idiophone.loadPreset("Marimba");
//     idiophone.noteOn(60);
import { InstrumentModule } from "./module.js";

const WORK_MILLISECONDS = 20;
const FADE_MILLISECONDS = 200; // at most; a context that does not run never fades

const encode = text => new TextEncoder().encode(text);
const decode = bytes => new TextDecoder().decode(bytes);

async function fetched(url) {
    let response;
    try {
        response = await fetch(url);
    } catch {
        throw new Error(`${url} cannot be fetched.`);
    }
    if (!response.ok)
        throw new Error(`${url} cannot be fetched: the server answers ${response.status}.`);
    return response;
}

const fetchedBytes = async url => new Uint8Array(await (await fetched(url)).arrayBuffer());

/** Returns the module's bytes: with SIMD, or without where the browser lacks it. */
async function fetchCode(base) {
    let code = await fetchedBytes(new URL("instrument.wasm", base));
    if (!WebAssembly.validate(code))
        code = await fetchedBytes(new URL("instrument-scalar.wasm", base)).catch(() => null);
    if (code === null || !WebAssembly.validate(code))
        throw new Error("This browser is too old for Idiophone: its WebAssembly lacks what it needs.");
    return code;
}

export class Idiophone {
    /** The last instrument's description, or null before the first load. */
    instrument = null;
    /** Called with the poses of a scene's bodies, some 50 times a second. */
    onposes = null;

    #base;
    #module;
    #objectNames;
    #replies = new Map();
    #replyCount = 0;
    #indices;
    #loading = Promise.resolve();
    #timer;

    static async start(context, { base = new URL(".", import.meta.url), destination } = {}) {
        if (!context.audioWorklet)
            throw new Error("This page needs a browser with AudioWorklet and a secure address.");
        const root = new URL(base, globalThis.location?.href);
        const [code, names] = await Promise.all([
            fetchCode(root),
            fetched(new URL("objects.json", root)).then(response => response.json()),
            context.audioWorklet.addModule(new URL("worklet.js", root)),
        ]);
        const started = new Idiophone(context, root, await WebAssembly.compile(code), code, names);
        started.node.connect(destination ?? context.destination);
        return started;
    }

    /** Use `start`. */
    constructor(context, base, module, code, objectNames) {
        const isOffline = typeof OfflineAudioContext !== "undefined" &&
            context instanceof OfflineAudioContext;
        this.context = context;
        this.#base = base;
        this.#objectNames = new Set(objectNames);
        this.#module = new InstrumentModule(module, context.sampleRate, isOffline);
        this.presets = this.#ask("presets");
        this.parameters = this.#ask("parameters");
        this.#indices = new Map(this.parameters.map(({ id }, index) => [id, index]));
        this.node = new AudioWorkletNode(context, "idiophone", {
            numberOfInputs: 0,
            outputChannelCount: [2],
            processorOptions: { code, isOffline },
        });
        this.node.port.onmessage = ({ data }) => this.#receive(data);
        if (!isOffline)
            this.#timer = setInterval(() => this.#tell("work"), WORK_MILLISECONDS);
    }

    loadPreset(name) {
        return this.#inTurn(() => this.#loadPreset(["load_factory", encode(name)]));
    }

    loadPresetText(text) {
        return this.#inTurn(() => this.#loadPreset(["load_text", encode(text)]));
    }

    loadObject(file, name) {
        return this.#inTurn(async () => {
            const bytes = file instanceof Uint8Array ? file :
                new Uint8Array(file instanceof Blob ? await file.arrayBuffer() : file);
            await this.#addObject(encode(name), bytes);
            return this.#load(["load_object", encode(name)]);
        });
    }

    mesh(object) {
        const info = this.instrument?.objects[object];
        if (!info)
            throw new RangeError(`There is no object ${object}.`);
        const { exports } = this.#module;
        const copy = (View, address, count) => new View(exports.memory.buffer, address, count).slice();
        return {
            vertices: copy(Float32Array, exports.instrument_vertices(object), 3 * info.vertexCount),
            faces: copy(Uint32Array, exports.instrument_faces(object), 3 * info.faceCount),
        };
    }

    noteOn(note, velocity = 100, time) {
        this.send([0x90, note, velocity], time);
    }

    noteOff(note, time) {
        this.send([0x80, note, 64], time);
    }

    send(bytes, time = this.context.currentTime) {
        this.#tell("send", Math.round(time * this.context.sampleRate), Uint8Array.from(bytes));
    }

    strike(object, [x, y, z], velocity) {
        this.#tell("control", "strike", object, x, y, z, velocity);
    }

    scrape(object, [x, y, z], pressure) {
        this.#tell("control", "scrape", object, x, y, z, pressure);
    }

    set(id, value) {
        const index = this.#index(id);
        this.#module.exports.instrument_set(index, value);
        this.#tell("control", "set", index, value);
    }

    get(id) {
        return this.#module.exports.instrument_get(this.#index(id));
    }

    silence() {
        this.#tell("silence");
    }

    settled() {
        return this.#request("settled");
    }

    cpuReport() {
        return this.#request("takeReport");
    }

    stop() {
        clearInterval(this.#timer);
        this.node.disconnect();
        this.node.port.close();
    }

    /** Runs one load at a time. */
    #inTurn(work) {
        const done = this.#loading.then(work);
        this.#loading = done.catch(() => {});
        return done;
    }

    async #loadPreset(call) {
        if (this.#module.call("needs", call[1]) === 0)
            throw this.#fault();
        const names = this.#answer().filter(
            name => this.#objectNames.has(name) && !this.#module.call("has_object", encode(name)));
        await Promise.all(names.map(async name => this.#addObject(encode(name),
            await fetchedBytes(new URL(`objects/${encodeURIComponent(name)}.modal`, this.#base)))));
        return this.#load(call);
    }

    /** Adds an object here first, so that a broken one never reaches the audio thread. */
    async #addObject(name, bytes) {
        if (this.#module.call("add_object", name, bytes) === 0)
            throw this.#fault();
        await this.#callThere("add_object", name, bytes);
    }

    async #load(call) {
        if (this.#module.call(...call) === 0)
            throw this.#fault();
        if (this.context.state === "running" && this.instrument !== null)
            await Promise.race([
                this.#request("fadeOut"),
                new Promise(resolve => setTimeout(resolve, FADE_MILLISECONDS)),
            ]);
        try {
            await this.#callThere(...call);
        } finally {
            this.#tell("fadeIn");
        }
        return this.instrument = this.#ask("describe");
    }

    /** Calls a function of the audio thread's module. */
    async #callThere(...call) {
        const fault = await this.#request("call", ...call);
        if (fault)
            throw new Error(decode(fault));
    }

    #index(id) {
        const index = this.#indices.get(id);
        if (index === undefined)
            throw new RangeError(`There is no parameter "${id}".`);
        return index;
    }

    #ask(name) {
        this.#module.exports["instrument_" + name]();
        return this.#answer();
    }

    #answer() {
        return JSON.parse(decode(this.#module.answer()));
    }

    #fault() {
        return new Error(decode(this.#module.answer()));
    }

    #tell(name, ...values) {
        this.node.port.postMessage({ name, values });
    }

    #request(name, ...values) {
        return new Promise((resolve, reject) => {
            const id = ++this.#replyCount;
            this.#replies.set(id, { resolve, reject });
            this.node.port.postMessage({ id, name, values });
        });
    }

    #receive({ id, result, error, poses }) {
        if (poses)
            return this.onposes?.(poses);
        const reply = this.#replies.get(id);
        this.#replies.delete(id);
        if (error === undefined)
            reply?.resolve(result);
        else
            reply?.reject(new Error(error));
    }
}
