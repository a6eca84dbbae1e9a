// Tests the page in Chromium: test_page.mjs TOOLS CHROMIUM SITE PICTURES
// Leaves its screenshots in PICTURES.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

import { BrowsedSite } from "./site.mjs";

const [tools, program, site, pictures] = process.argv.slice(2);
const DESKTOP = { width: 1280, height: 800 }, PHONE = { width: 390, height: 844 };
const MEGABYTE = 2 ** 20;
const browsed = new BrowsedSite({ tools, program, site, pictures });

/** Opens the page and waits for its first preset. Returns the page and what went wrong in it. */
async function open(viewport = DESKTOP, colorScheme = "dark") {
    const opened = await browsed.newPage({ viewport, colorScheme, reducedMotion: "reduce" });
    await opened.page.goto(browsed.server.origin);
    await nameIs(opened.page, "Rosewood Xylophone");
    return opened;
}

function nameIs(page, name) {
    return page.waitForFunction(
        expected => document.getElementById("preset-name").textContent.includes(expected) &&
            document.getElementById("status").textContent === "", name);
}

/**
 * Begins to record what the instrument plays. The recorder's `heard` is the time of the context's
 * first loud sample since `from`, in seconds, or null.
 */
async function record(page) {
    await page.evaluate(async () => {
        const { context, node } = window.idiophone;
        await context.resume();
        const code = `registerProcessor("recorder", class extends AudioWorkletProcessor {
            process([[left]]) {
                const loud = left?.findIndex(sample => Math.abs(sample) > 1e-3) ?? -1;
                if (loud >= 0)
                    this.port.postMessage((currentFrame + loud) / sampleRate);
                return true;
            }
        });`;
        await context.audioWorklet.addModule(URL.createObjectURL(new Blob([code], { type: "text/javascript" })));
        const recorder = new AudioWorkletNode(context, "recorder", { numberOfOutputs: 0 });
        node.connect(recorder);
        window.heard = [];
        recorder.port.onmessage = ({ data }) => window.heard.push(data);
    });
}

/** Returns the place of the middle of a bar in the window. */
async function placeOfBar(page) {
    const box = await page.locator("#canvas").boundingBox();
    for (let share = 0.35; share < 0.7; share += 0.02) {
        const place = { x: box.x + box.width / 2, y: box.y + share * box.height };
        await page.mouse.move(place.x, place.y);
        await page.waitForTimeout(50);
        if (await page.locator("#canvas").evaluate(canvas => canvas.style.cursor) === "pointer")
            return place;
    }
    throw new Error("no bar is in the middle of the picture");
}

test("The page loads without an error or a foreign request, in at most 3 MB", async () => {
    browsed.server.requests.length = 0;
    const { page, faults, close } = await open();
    assert.deepEqual(faults, []);
    assert.deepEqual(browsed.server.requests.filter(({ status }) => status !== 200), []);
    const paths = [...new Set(browsed.server.requests.map(({ path }) => path))];
    const bytes = paths.reduce((sum, path) => sum +
        gzipSync(readFileSync(join(site, path === "/" ? "index.html" : decodeURIComponent(path)))).length, 0);
    console.log(`${paths.length} files, ${(bytes / MEGABYTE).toFixed(2)} MB with gzip`);
    assert.ok(bytes < 3 * MEGABYTE);
    await page.screenshot({ path: join(pictures, "desktop-dark.png") });
    await close();
});

test("A click on a bar is heard within 60 ms of audio time", async () => {
    const { page, faults, close } = await open();
    await record(page);
    const { x, y } = await placeOfBar(page);
    await page.evaluate(() => document.getElementById("canvas").addEventListener("pointerdown",
        () => window.pressed = window.idiophone.context.currentTime, { capture: true }));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.waitForFunction(() => window.heard.some(time => time > window.pressed));
    await page.mouse.up();
    const seconds = await page.evaluate(
        () => window.heard.find(time => time > window.pressed) - window.pressed);
    console.log(`heard after ${(1000 * seconds).toFixed(1)} ms of audio time`);
    assert.ok(seconds < 0.06);
    assert.deepEqual(faults, []);
    await close();
});

test("A broken file shows one sentence, and the former sound goes on", async () => {
    const { page, faults, close } = await open();
    const object = readFileSync(join(site, "idiophone/objects/plate.modal"));
    const choose = (name, buffer) =>
        page.locator("#file").setInputFiles({ name, mimeType: "application/octet-stream", buffer });
    await choose("broken.modal", object.subarray(0, -4));
    const alert = page.locator("#alert");
    await alert.filter({ hasText: "outside the file" }).waitFor();
    assert.match(await alert.textContent(), /^broken\.modal: tensor 'shapes' lies outside the file\.?$/);
    assert.equal(await page.evaluate(() => window.idiophone.instrument.name), "Rosewood Xylophone");
    await record(page);
    await page.evaluate(() => window.idiophone.noteOn(72));
    await page.waitForFunction(() => window.heard.length > 0);
    await choose("plate.modal", object);
    await nameIs(page, "plate");
    assert.deepEqual(faults, []);
    await close();
});

test("The song plays at a button, and keys play notes", async () => {
    const { page, faults, close } = await open();
    await record(page);
    await page.getByRole("button", { name: "Play the song" }).click();
    await page.waitForFunction(() => window.heard.length > 0);
    await page.getByRole("button", { name: "Stop the song" }).click();
    await page.waitForFunction(() => { // it has died away
        const before = window.lastCount;
        window.lastCount = window.heard.length;
        return before === window.lastCount;
    }, null, { polling: 1000 });
    const before = await page.evaluate(() => window.heard.length);
    await page.locator("body").press("d");
    await page.waitForFunction(count => window.heard.length > count, before);
    assert.deepEqual(faults, []);
    await close();
});

for (const [name, viewport] of [["desktop", DESKTOP], ["phone", PHONE]])
    for (const look of ["dark", "light"])
        test(`axe-core finds no serious fault: ${name}, ${look}`, async () => {
            const { page, close } = await open(viewport, look);
            assert.deepEqual(await browsed.seriousFaults(page), []);
            assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
            await page.screenshot({ path: join(pictures, `${name}-${look}.png`) });
            await close();
        });
