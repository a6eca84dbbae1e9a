// Tests the manual and the gallery in Chromium: test_manual.mjs TOOLS CHROMIUM SITE PRESETS PICTURES
// PRESETS is the folder of the factory's presets. Leaves its screenshots in PICTURES.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";

import { BrowsedSite } from "./site.mjs";

const [tools, program, site, presets, pictures] = process.argv.slice(2);
const DESKTOP = { width: 1280, height: 800 }, PHONE = { width: 360, height: 780 };
const browsed = new BrowsedSite({ tools, program, site, pictures });
const newPage = () => browsed.newPage({ viewport: DESKTOP });

/**
 * Returns what the pages at `paths` have, by their paths: the `ids`, and the addresses of `links`,
 * `pictures`, and `resources`, which a browser fetches by itself.
 */
function readPages(page, paths) {
    return page.evaluate(async allPaths => Object.fromEntries(await Promise.all(allPaths.map(async path => {
        const text = await (await fetch(`/${path}`)).text();
        const read = new DOMParser().parseFromString(text, "text/html");
        const base = read.createElement("base");
        base.href = new URL(`/${path}`, location);
        read.head.prepend(base);
        const addresses = (selector, name) => [...read.querySelectorAll(selector)].map(each => each[name]);
        return [path, {
            ids: addresses("[id]", "id"),
            links: addresses("a[href]", "href"),
            pictures: addresses("img", "src"),
            resources: [...addresses("link", "href"), ...addresses("[src]", "src")],
        }];
    }))), paths);
}

/** Returns a sentence for each picture that does not load. */
function brokenPictures(page, addresses) {
    return page.evaluate(async all => {
        const broken = [];
        await Promise.all(all.map(async address => {
            const picture = new Image();
            picture.src = address;
            await picture.decode().catch(() => broken.push(`${address} does not load`));
        }));
        return broken;
    }, [...new Set(addresses)]);
}

test("No page has a broken link, anchor or picture, and links lead to each", async () => {
    const { page, faults, close } = await newPage();
    await page.goto(`${browsed.server.origin}/gallery.html`);
    const files = new Set(readdirSync(site, { recursive: true }));
    const pages = await readPages(page, [...files].filter(file => file.endsWith(".html")));
    const inSite = address => address.startsWith(`${browsed.server.origin}/`);
    const pathOf = address => decodeURIComponent(new URL(address).pathname.slice(1));
    const reached = new Set();
    for (const [path, { links, resources }] of Object.entries(pages)) {
        faults.push(...resources.filter(address => !inSite(address)).map(address => `${path} fetches ${address}`));
        for (const address of [...links, ...resources].filter(inSite)) {
            const target = pathOf(address), anchor = decodeURIComponent(new URL(address).hash.slice(1));
            if (!files.has(target) || anchor !== "" && !pages[target].ids.includes(anchor))
                faults.push(`${path}: the link to ${target}#${anchor} is broken`);
            reached.add(target);
        }
    }
    faults.push(...Object.keys(pages).filter(path => !reached.has(path)).map(path => `no link leads to ${path}`));
    faults.push(...await brokenPictures(page, Object.values(pages).flatMap(({ pictures }) => pictures)));
    assert.deepEqual(faults, []);
    console.log(`${Object.keys(pages).length} pages`);
    for (const [from, to] of [["index.html", "gallery.html"], ["index.html", "manual/index.html"],
        ["manual/index.html", "manual/midi.html"]])
        assert.ok(pages[from].links.map(pathOf).includes(to), `${from} leads to ${to}`);
    assert.ok(pages["index.html"].links.includes("https://idiophone.example/source"), "SOURCE_URL of CMakeLists.txt");
    await close();
});

test("The gallery shows every preset and plays its sound, as Ogg and MP3", async () => {
    const { page, faults, close } = await newPage();
    await page.goto(`${browsed.server.origin}/gallery.html`);
    const cards = await page.locator(".gallery li").evaluateAll(items => Promise.all(items.map(async item => {
        const player = item.querySelector("audio");
        const sources = [...player.querySelectorAll("source")];
        const decoded = sources.map(async ({ src }) => {
            const bytes = await (await fetch(src)).arrayBuffer();
            const sound = await new OfflineAudioContext(1, 1, 44100).decodeAudioData(bytes)
                .catch(() => { throw new Error(`${src} does not decode`); });
            const peak = sound.getChannelData(0).reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
            return { seconds: sound.duration, peak };
        });
        const sounds = await Promise.all(decoded);
        await new Promise((resolve, reject) => {
            player.addEventListener("canplaythrough", resolve);
            sources.at(-1).addEventListener("error", () => reject(new Error(`${sources[0].src} does not play`)));
            player.preload = "auto";
            player.load();
        });
        return {
            name: item.querySelector("h2").textContent,
            description: item.querySelector("p").textContent,
            preset: new URL(item.querySelector("a").href).searchParams.get("preset"),
            sounds,
        };
    })));
    const files = readdirSync(presets).sort();
    const expected = files.map(file => JSON.parse(readFileSync(join(presets, file), "utf8")))
        .map(({ name, description }) => ({ name, description, preset: name }));
    assert.deepEqual(cards.map(({ name, description, preset }) => ({ name, description, preset })), expected);
    for (const { name, sounds } of cards) {
        const [ogg, mp3] = sounds;
        assert.ok(sounds.length === 2 && Math.abs(ogg.seconds - mp3.seconds) < 0.1, name);
        assert.ok(ogg.seconds > 0.1 && ogg.peak > 0.1 && mp3.peak > 0.1, name);
    }
    await page.locator("audio").first().evaluate(player => player.play());
    await page.waitForFunction(() => document.querySelector("audio").currentTime > 0);
    assert.deepEqual(faults, []);
    await close();
});

test("A link of the gallery opens its preset, and an unknown one is named", async () => {
    const { page, faults, close } = await newPage();
    await page.setViewportSize(PHONE); // draws faster
    await page.goto(`${browsed.server.origin}/gallery.html`);
    await page.getByRole("link", { name: "Ship's Bell" }).click();
    await page.locator("#preset-name", { hasText: "Ship's Bell" }).waitFor();
    await page.goto(`${browsed.server.origin}/?preset=Nothing`);
    await page.locator("#alert", { hasText: "No preset is called Nothing." }).waitFor();
    assert.match(await page.locator("#preset-name").textContent(), /Rosewood Xylophone/);
    assert.deepEqual(faults, []);
    await close();
});

test("axe-core finds no serious fault in both looks, on desktop and phone", async () => {
    const { page, faults, close } = await newPage();
    for (const path of ["gallery.html", "manual/sounds.html"]) {
        await page.goto(`${browsed.server.origin}/${path}`);
        for (const [name, viewport] of [["desktop", DESKTOP], ["phone", PHONE]])
            for (const colorScheme of ["dark", "light"]) {
                const run = `${name}-${colorScheme}-${path.replace("/", "-")}`;
                await page.setViewportSize(viewport);
                await page.emulateMedia({ colorScheme });
                assert.deepEqual(await browsed.seriousFaults(page), [], run);
                assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), run);
                await page.screenshot({ path: join(pictures, `${run}.png`) });
            }
    }
    assert.deepEqual(faults, []);
    await close();
});
