// Tests the npm package in Chromium, beside the console:
//     test_package.mjs TOOLS CHROMIUM SITE CONSOLE SONG.mid
// SITE has the package in `idiophone`, and `song.js`, which reads MIDI files.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, beforeEach, test } from "node:test";

import { launchChromium, serve } from "./browser.mjs";

const [tools, program, site, console_, song] = process.argv.slice(2);
const PRESET = "Rosewood Xylophone";
const PRESETS_A_PAGE = 10;
let folder, server, browser, page;

/** Frees the memory of former instruments. */
async function openEmptyPage() {
    await page.goto(server.origin + "/empty");
}

before(async () => {
    folder = mkdtempSync(join(tmpdir(), "idiophone-browser-"));
    copyFileSync(song, join(folder, "song.mid"));
    execFileSync(console_, ["render", "--preset", PRESET, "--midi", song, "--sample-rate", "48000",
        "-o", join(folder, "song.wav")]);
    server = await serve({ "": site, test: folder });
    browser = await launchChromium(tools, program);
    page = await browser.newPage();
    page.on("pageerror", error => console.error(error));
});

beforeEach(openEmptyPage);

after(async () => {
    await browser?.close();
    await server?.close();
    rmSync(folder, { recursive: true });
});

test("The song in an OfflineAudioContext is the console's, to -90 dB", async () => {
    const { decibels, loudest } = await page.evaluate(async preset => {
        const { Idiophone } = await import("/idiophone/index.js");
        const { songEvents } = await import("/song.js");
        const bytes = async name => (await fetch("/test/" + name)).arrayBuffer();
        const wav = new DataView(await bytes("song.wav"));
        let data = 12; // the chunks of a RIFF file
        while (wav.getUint32(data) !== 0x64617461)
            data += 8 + wav.getUint32(data + 4, true);
        const frames = wav.getUint32(data + 4, true) / 8;
        const context = new OfflineAudioContext(2, frames, 48000);
        const idiophone = await Idiophone.start(context);
        await idiophone.loadPreset(preset);
        for (const event of songEvents(new Uint8Array(await bytes("song.mid"))))
            idiophone.send(event.bytes, event.seconds);
        await idiophone.settled();
        const rendered = await context.startRendering();
        let furthest = 0, loudest = 0;
        for (const [side, samples] of [0, 1].map(each => rendered.getChannelData(each)).entries())
            for (let k = 0; k < frames; ++k) {
                const expected = wav.getFloat32(data + 8 + 8 * k + 4 * side, true);
                furthest = Math.max(furthest, Math.abs(samples[k] - expected));
                loudest = Math.max(loudest, Math.abs(expected));
            }
        return { decibels: 20 * Math.log10(furthest / loudest), loudest };
    }, PRESET);
    console.log(`the difference is ${decibels.toFixed(1)} dB of the peak`);
    assert.ok(loudest > 0.01);
    assert.ok(decibels < -90);
});

test("Every factory preset plays", async () => {
    const presets = JSON.parse(execFileSync(console_, ["presets", "--json"], { encoding: "utf8" }))
        .map(({ name, keyMap }) => ({ name, seconds: keyMap.kind === "scene" ? 3 : 1 })); // bodies fall first
    assert.ok(presets.length > 60);
    for (let first = 0; first < presets.length; first += PRESETS_A_PAGE) {
        await openEmptyPage();
        const faults = await page.evaluate(async presets => {
            const { Idiophone } = await import("/idiophone/index.js");
            const faults = [];
            for (const { name, seconds } of presets)
                try {
                    const context = new OfflineAudioContext(2, 48000 * seconds, 48000);
                    const idiophone = await Idiophone.start(context);
                    const { notes } = await idiophone.loadPreset(name);
                    idiophone.noteOn(notes[notes.length >> 1].note, 100, 0.01);
                    await idiophone.settled();
                    const samples = (await context.startRendering()).getChannelData(0);
                    const loudest = samples.reduce((most, each) => Math.max(most, Math.abs(each)), 0);
                    if (!(loudest > 0.001 && loudest < 1.01))
                        faults.push(`${name}: its peak is ${loudest}`);
                } catch (error) {
                    faults.push(`${name}: ${error.message}`);
                }
            return faults;
        }, presets.slice(first, first + PRESETS_A_PAGE));
        assert.deepEqual(faults, []);
    }
});

test("A broken file gives a sentence, and the former sound goes on", async () => {
    const { sentence, name, loudest } = await page.evaluate(async () => {
        const { Idiophone } = await import("/idiophone/index.js");
        const context = new OfflineAudioContext(2, 24000, 48000);
        const idiophone = await Idiophone.start(context);
        await idiophone.loadPreset("Vibraphone");
        const object = new Uint8Array(await (await fetch("/idiophone/objects/plate.modal")).arrayBuffer());
        const refused = idiophone.loadObject(object.slice(0, -4), "broken.modal");
        const sentence = await refused.then(() => "", error => error.message);
        idiophone.noteOn(60);
        await idiophone.settled();
        const samples = (await context.startRendering()).getChannelData(0);
        return {
            sentence,
            name: idiophone.instrument.name,
            loudest: samples.reduce((most, each) => Math.max(most, Math.abs(each)), 0),
        };
    });
    assert.equal(sentence, "broken.modal: tensor 'shapes' lies outside the file");
    assert.equal(name, "Vibraphone");
    assert.ok(loudest > 0.01);
});

test("Objects, strikes, scrapes, parameters and meshes", async () => {
    const seen = await page.evaluate(async () => {
        const { Idiophone } = await import("/idiophone/index.js");
        const object = await (await fetch("/idiophone/objects/plate.modal")).blob();
        const render = async play => {
            const context = new OfflineAudioContext(2, 24000, 48000);
            const idiophone = await Idiophone.start(context);
            const info = await idiophone.loadObject(object, "plate.modal");
            const { vertices, faces } = idiophone.mesh(0);
            play(idiophone, Array.from(vertices.slice(0, 3)));
            await idiophone.settled();
            const samples = (await context.startRendering()).getChannelData(0);
            const [{ vertexCount }] = info.objects;
            return {
                loudest: samples.reduce((most, each) => Math.max(most, Math.abs(each)), 0),
                isMesh: vertices.length === 3 * vertexCount &&
                    faces.every(vertex => vertex < vertexCount),
            };
        };
        const strike = await render((idiophone, place) => idiophone.strike(0, place, 100));
        const soft = await render((idiophone, place) => idiophone.strike(0, place, 10));
        const quiet = await render((idiophone, place) => {
            idiophone.set("level", idiophone.get("level") - 20);
            idiophone.strike(0, place, 100);
        });
        const silent = await render(() => {});
        return { strike, soft, quiet, silent };
    });
    assert.ok(seen.strike.isMesh);
    assert.ok(seen.strike.loudest > 0.01 && seen.strike.loudest < 1);
    assert.ok(seen.soft.loudest < seen.strike.loudest / 4);
    assert.ok(Math.abs(seen.quiet.loudest / seen.strike.loudest - 0.1) < 0.001);
    assert.equal(seen.silent.loudest, 0);
});
