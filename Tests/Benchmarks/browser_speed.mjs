// Measures what a dense song costs in Chromium, beside the native engine (docs/web.md).
//
//     browser_speed.mjs TOOLS CHROMIUM SITE CONSOLE
//
// TOOLS is the folder whose node_modules has playwright-core, SITE the page. 37 vibraphone bars ring under
// 40 notes a second for 20 s, in blocks of 128 frames. Prints the share of real time that one core
// spends: in the console, in an OfflineAudioContext, and as the AudioWorklet of a running context
// reports it. Then the time from a cold start of the page to its first sound.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

import { launchChromium, serve } from "../Browser/browser.mjs";

const [tools, program, site, console_] = process.argv.slice(2);
const PRESET = "Vibraphone", SECONDS = 20, NOTES_PER_SECOND = 40;
const notes = Array.from({ length: SECONDS * NOTES_PER_SECOND }, (_, k) => ({
    seconds: k / NOTES_PER_SECOND,
    bytes: [0x90, 53 + k * 7 % 37, 60 + k * 11 % 60],
}));

/** Returns a Standard MIDI File of one track, in which a beat of 480 ticks takes half a second. */
function midiFile() {
    const ticks = 960 / NOTES_PER_SECOND;
    const track = Buffer.concat([
        ...notes.map(({ bytes }, k) => Buffer.from([k === 0 ? 0 : ticks, ...bytes])),
        Buffer.from([0, 0xff, 0x2f, 0]),
    ]);
    const head = Buffer.from([..."MThd"].map(each => each.charCodeAt(0))
        .concat(0, 0, 0, 6, 0, 0, 0, 1, 480 >> 8, 480 & 255));
    const size = Buffer.alloc(4);
    size.writeUInt32BE(track.length);
    return Buffer.concat([head, Buffer.from("MTrk"), size, track]);
}

function nativeShare() {
    const folder = mkdtempSync(join(tmpdir(), "idiophone-speed-"));
    try {
        writeFileSync(join(folder, "dense.mid"), midiFile());
        return JSON.parse(execFileSync(console_, ["render", "--preset", PRESET, "--midi",
            join(folder, "dense.mid"), "--block-size", "128", "--seconds", String(SECONDS),
            "-o", join(folder, "dense.wav"), "--json"], { encoding: "utf8" })).cpu_share;
    } finally {
        rmSync(folder, { recursive: true });
    }
}

/** Runs in the page. Returns both shares. */
async function shares({ preset, seconds, notes }) {
    const { Idiophone } = await import("/idiophone/index.js");
    const play = async context => {
        const idiophone = await Idiophone.start(context);
        await idiophone.loadPreset(preset);
        const start = context.currentTime + (context.state === "running" ? 0.1 : 0);
        for (const { bytes, seconds } of notes)
            idiophone.send(bytes, start + seconds);
        await idiophone.settled();
        return idiophone;
    };
    const offline = new OfflineAudioContext(2, 48000 * seconds, 48000);
    await play(offline);
    const begin = performance.now();
    await offline.startRendering();
    const spent = (performance.now() - begin) / 1000;
    const context = new AudioContext({ sampleRate: 48000 });
    await context.resume();
    const idiophone = await play(context);
    await idiophone.cpuReport();
    await new Promise(resolve => setTimeout(resolve, 1000 * seconds));
    return { offline: spent / seconds, worklet: (await idiophone.cpuReport()).share };
}

/** Opens the page in a new browser, strikes a key, and returns the seconds until its sound. */
async function secondsToFirstSound(origin) {
    const browser = await launchChromium(tools, program);
    try {
        const page = await browser.newPage();
        const begin = performance.now();
        await page.goto(origin);
        await page.evaluate(async () => {
            while (!window.idiophone?.instrument)
                await new Promise(resolve => setTimeout(resolve, 5));
            const { context, node } = window.idiophone;
            await context.resume();
            const analyser = new AnalyserNode(context);
            node.connect(analyser);
            window.idiophone.noteOn(72);
            const samples = new Float32Array(analyser.fftSize);
            do {
                await new Promise(resolve => setTimeout(resolve, 5));
                analyser.getFloatTimeDomainData(samples);
            } while (samples.every(sample => Math.abs(sample) < 1e-3));
        });
        return (performance.now() - begin) / 1000;
    } finally {
        await browser.close();
    }
}

const server = await serve({ "": site });
const browser = await launchChromium(tools, program);
try {
    const page = await browser.newPage();
    await page.goto(server.origin + "/empty");
    const native = Math.min(...[1, 2, 3].map(nativeShare));
    const measured = { native, ...await page.evaluate(shares, { preset: PRESET, seconds: SECONDS, notes }) };
    for (const [name, share] of Object.entries(measured))
        console.log(`${name}: ${(100 * share).toFixed(2)} % of one core, ` +
            `${(share / native).toFixed(2)} of native`);
    await browser.close();
    console.log(`first sound after ${(await secondsToFirstSound(server.origin)).toFixed(2)} s`);
} finally {
    await browser.close();
    await server.close();
}
