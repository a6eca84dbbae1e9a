// Loads the WebAssembly module and speaks to its C interface (Source/C/idiophone.h).
import { readFileSync } from "node:fs";

const BLOCK = 128;

export function readModule(path) {
    return new WebAssembly.Module(readFileSync(path));
}

export class Engine {
    constructor(module) {
        this.c = new WebAssembly.Instance(module, {}).exports;
        this.c._initialize();
    }

    view() {
        return new DataView(this.c.memory.buffer);
    }

    /** Copies bytes into the module's memory and passes their address to `use`. */
    lend(bytes, use) {
        const address = this.c.malloc(Math.max(bytes.length, 1));
        if (address === 0)
            throw new Error("out of memory");
        new Uint8Array(this.c.memory.buffer, address, bytes.length).set(bytes);
        try {
            return use(address);
        } finally {
            this.c.free(address);
        }
    }

    text(address) {
        const bytes = new Uint8Array(this.c.memory.buffer);
        return new TextDecoder().decode(bytes.subarray(address, bytes.indexOf(0, address)));
    }

    error() {
        return this.text(this.c.idiophone_error());
    }

    /** Returns the object's address. Throws the module's sentence. */
    readObject(bytes, name) {
        const object = this.lend(bytes, data => this.lend(new TextEncoder().encode(name + "\0"),
            text => this.c.idiophone_object_read(data, bytes.length, text)));
        if (object === 0)
            throw new Error(this.error());
        return object;
    }

    /** Returns the corners of the object's box. */
    box(object) {
        return this.lend(new Uint8Array(24), corners => {
            this.c.idiophone_object_box(object, corners, corners + 12);
            const view = this.view();
            const corner = from => [0, 4, 8].map(at => view.getFloat32(from + at, true));
            return { low: corner(corners), high: corner(corners + 12) };
        });
    }

    /** Returns the address of a world in which object k is body k. Throws the module's sentence. */
    makeWorld(objects) {
        const bodies = new DataView(new ArrayBuffer(16 * objects.length));
        objects.forEach((object, k) => {
            bodies.setUint32(16 * k, 16, true);
            bodies.setUint32(16 * k + 4, object, true);
            bodies.setFloat64(16 * k + 8, 1, true);
        });
        const world = this.lend(new Uint8Array(bodies.buffer),
            data => this.c.idiophone_world_create(data, objects.length, 0));
        if (world === 0)
            throw new Error(this.error());
        return world;
    }

    place(world, body, position) {
        const data = new Uint8Array(new Float32Array(position).buffer);
        return this.lend(data, address => this.c.idiophone_world_place(world, body, address, 0));
    }

    strike(world, { body, point, impulse, contactTime }) {
        const hit = new DataView(new ArrayBuffer(48));
        hit.setUint32(0, 48, true);
        hit.setUint32(4, body, true);
        point.forEach((value, axis) => hit.setFloat32(16 + 4 * axis, value, true));
        impulse.forEach((value, axis) => hit.setFloat32(28 + 4 * axis, value, true));
        hit.setFloat64(40, contactTime, true);
        return this.lend(new Uint8Array(hit.buffer),
            address => this.c.idiophone_world_strike(world, address));
    }
}

/**
 * Strikes bodies in turn as strikes.c does. `objects` are the bytes of .modal files. Returns both
 * ears of each frame and the processor seconds.
 */
export function renderStrikes(engine, objects, seconds, strikesPerSecond) {
    const { c } = engine;
    const rate = 48000;
    const handles = objects.map((bytes, k) => engine.readObject(bytes, `object ${k}`));
    const boxes = handles.map(object => engine.box(object));
    const world = engine.makeWorld(handles);
    const places = handles.map((_, k) => Math.fround(0.05 * k));
    places.forEach((x, k) => engine.place(world, k, [x, 0, 0]));
    const block = c.malloc(8 * BLOCK);
    const samples = new Float32Array(2 * BLOCK * Math.ceil(seconds * rate / BLOCK));
    let strikes = 0;
    let microseconds = 0;
    for (let done = 0; done < seconds * rate; done += BLOCK) {
        const begin = process.cpuUsage();
        for (; strikes < done / rate * strikesPerSecond + 1; ++strikes) {
            const body = strikes % handles.length;
            const { low, high } = boxes[body];
            const share = [7, 5].map(step => strikes * step % 11 / 10).concat(1);
            const refused = engine.strike(world, {
                body,
                point: low.map((from, axis) => from + share[axis] * Math.fround(high[axis] - from) +
                    (axis === 0 ? places[body] : 0)),
                impulse: [0, 0, -0.001 * (1 + strikes % 5)],
                contactTime: 0.0005,
            });
            if (refused)
                throw new Error(`strike ${strikes} is refused`);
        }
        c.idiophone_world_render(world, block, block + 4, BLOCK, 2);
        const spent = process.cpuUsage(begin);
        microseconds += spent.user + spent.system;
        samples.set(new Float32Array(c.memory.buffer, block, 2 * BLOCK), 2 * done);
    }
    c.free(block);
    c.idiophone_world_free(world);
    handles.forEach(object => c.idiophone_object_free(object));
    return { samples, processorSeconds: microseconds / 1e6 };
}
