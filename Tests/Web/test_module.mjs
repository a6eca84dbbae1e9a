// Tests the WebAssembly module:
// test_module.mjs idiophone.wasm strikes write_glb idiophone.h plate.modal
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { gzipSync } from "node:zlib";

import { Engine, readModule, renderStrikes } from "./engine.mjs";

const [modulePath, nativeProgram, writeGlb, header, objectPath] = process.argv.slice(2);
const module = readModule(modulePath);
const plate = readFileSync(objectPath);
const folder = mkdtempSync(join(tmpdir(), "idiophone-web-"));
after(() => rmSync(folder, { recursive: true }));

/** Returns the bytes of the plate as a .glb file. */
function plateInGltf() {
    const file = join(folder, "plate.glb");
    execFileSync(writeGlb, [objectPath, file]);
    return readFileSync(file);
}

/** Returns the bytes of a .glb file without a binary chunk. */
function glb(document) {
    const text = JSON.stringify(document);
    const json = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
    const header = new Uint32Array([0x46546c67, 2, 20 + json.length, json.length, 0x4e4f534a]);
    return Buffer.concat([Buffer.from(header.buffer), json]);
}

/** Strikes the object of a file in the module and in the library, and compares their samples. */
function playsLikeTheLibrary(path) {
    const file = join(folder, "strikes.raw");
    execFileSync(nativeProgram, [file, "1", "10", path]);
    const bytes = readFileSync(file);
    const expected = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
    const { samples } = renderStrikes(new Engine(module), [readFileSync(path)], 1, 10);
    assert.equal(samples.length, expected.length);
    const loudest = expected.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
    const furthest = expected.reduce(
        (most, value, k) => Math.max(most, Math.abs(value - samples[k])), 0);
    assert.ok(loudest > 0.001);
    assert.ok(samples.every(Number.isFinite));
    const decibels = 20 * Math.log10(furthest / loudest);
    console.log(`the difference is ${decibels.toFixed(1)} dB of the peak`);
    assert.ok(decibels < -90);
}

test("The module imports nothing", () => {
    assert.deepEqual(WebAssembly.Module.imports(module), []);
    const size = readFileSync(modulePath);
    console.log(`${size.length} bytes, ${gzipSync(size, { level: 9 }).length} with gzip`);
});

test("The module exports the C interface without files", () => {
    const declared = [...readFileSync(header, "utf8")
        .matchAll(/^IDIOPHONE_API[^;(]*?\b(idiophone_\w+)\s*\(/gm)].map(found => found[1]);
    const expected = new Set([...declared, "memory", "_initialize", "malloc", "free"]);
    assert.ok(expected.delete("idiophone_object_load"));
    const exported = WebAssembly.Module.exports(module).map(each => each.name);
    assert.deepEqual(exported.sort(), [...expected].sort());
});

test("The module plays what the library plays, to -90 dB", () => playsLikeTheLibrary(objectPath));

test("A .glb file sounds as the .modal file it was written from", () => {
    const [modal, gltf] = [plate, plateInGltf()].map(
        bytes => renderStrikes(new Engine(module), [bytes], 0.2, 10).samples);
    assert.ok(modal.some(value => value !== 0));
    assert.deepEqual(gltf, modal);
});

test("A .glb file of another program plays what it plays in the library, to -90 dB", () => {
    const path = join(folder, "other.glb");
    writeFileSync(path, // without what only Idiophone writes
        plateInGltf().toString("latin1").replaceAll("IDIOPHONE_modal", "ELSEWHERE_modal"), "latin1");
    playsLikeTheLibrary(path);
});

test("A broken object gives a sentence, and the module goes on", () => {
    const engine = new Engine(module);
    const refuse = (bytes, sentence) =>
        assert.throws(() => engine.readObject(bytes, "plate.modal"), { message: sentence });
    refuse(new Uint8Array(3), "plate.modal: it is too short to be a modal object");
    const broken = Uint8Array.from(plate);
    broken[9] = "!".charCodeAt(0);
    refuse(broken, "plate.modal: its header is not a JSON object");
    refuse(plate.subarray(0, plate.length - 4),
        "plate.modal: tensor 'shapes' lies outside the file");
    assert.throws(() => engine.makeWorld([]), /\w/);
    const object = engine.readObject(plate, "plate.modal");
    assert.equal(engine.text(engine.c.idiophone_object_name(object)), "plate");
    engine.c.idiophone_object_free(object);
});

test("A broken .glb file gives a sentence, and the module goes on", () => {
    const engine = new Engine(module);
    const refuse = (bytes, sentence) =>
        assert.throws(() => engine.readObject(bytes, "plate.glb"), { message: sentence });
    const whole = plateInGltf();
    refuse(whole.subarray(0, whole.length - 4), "plate.glb: it is truncated");
    const asset = { version: "2.0" };
    refuse(glb({ asset }), "plate.glb: it has no modal model (KHR_audio_rigid_bodies)");
    refuse(glb({ asset, buffers: [{ uri: "plate.bin", byteLength: 4 }] }),
        "plate.glb: its buffer 'plate.bin' cannot be read: " +
        "it is in another file, and only the bytes of this one are given");
    refuse(glb({ asset, accessors: [{ componentType: 5126, type: "SCALAR" }] }),
        /^plate\.glb: it is malformed: 'count' property is missing/);
    refuse(glb({ asset, extensions: { KHR_audio_rigid_bodies: { modalModels: [{}] } } }),
        /^plate\.glb: .*frequencies/);
    engine.c.idiophone_object_free(engine.readObject(whole, "plate.glb"));
});

test("Reading broken objects again and again takes no more memory", () => {
    const engine = new Engine(module);
    const read = () => assert.throws(
        () => engine.readObject(plate.subarray(0, plate.length - 4), "plate.modal"));
    read();
    read();
    const before = engine.c.memory.buffer.byteLength;
    for (let k = 0; k < 100; ++k)
        read();
    assert.equal(engine.c.memory.buffer.byteLength, before);
});

test("Rendering takes no more memory", () => {
    const engine = new Engine(module);
    const object = engine.readObject(plate, "plate.modal");
    const world = engine.makeWorld([object]);
    const block = engine.c.malloc(1024);
    const { high } = engine.box(object);
    const before = engine.c.memory.buffer.byteLength;
    for (let k = 0; k < 200; ++k) {
        assert.equal(engine.strike(world,
            { body: 0, point: high, impulse: [0, 0, -0.01], contactTime: 0.001 }), 0);
        engine.c.idiophone_world_render(world, block, block + 4, 128, 2);
    }
    assert.equal(engine.c.memory.buffer.byteLength, before);
    assert.ok(new Float32Array(engine.c.memory.buffer, block, 256).some(value => value !== 0));
});

test("Without memory an object gives a sentence, and the module goes on", () => {
    for (const bytes of [plate, plateInGltf()]) {
        const engine = new Engine(module);
        const data = engine.c.malloc(bytes.length);
        new Uint8Array(engine.c.memory.buffer, data, bytes.length).set(bytes);
        const taken = [];
        for (let size = 2 ** 30; size >= 2 ** 16; size /= 2)
            for (let address = engine.c.malloc(size); address !== 0; address = engine.c.malloc(size))
                taken.push(address);
        assert.equal(engine.c.idiophone_object_read(data, bytes.length, 0), 0);
        assert.equal(engine.error(), "object: it is too large for this machine's memory");
        taken.forEach(address => engine.c.free(address));
        assert.notEqual(engine.c.idiophone_object_read(data, bytes.length, 0), 0);
    }
});
