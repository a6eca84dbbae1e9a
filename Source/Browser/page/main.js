// Starts the instrument and the page around it.
import { ComputerKeys } from "./computerKeys.js";
import { Controls } from "./controls.js";
import { takeFiles } from "./files.js";
import { Hand } from "./hand.js";
import { Keyboard } from "./keyboard.js";
import { MaterialPad } from "./materialPad.js";
import { offerMidi } from "./midi.js";
import { Performer } from "./performer.js";
import { Picture } from "./picture.js";
import { PresetList } from "./presetList.js";
import { fetchShaders } from "./shaders.js";
import { songEvents } from "./song.js";
import { SongPlayer } from "./songPlayer.js";
import { Stage } from "./stage.js";
import { startAtGesture } from "./startup.js";
import { say, warn } from "./status.js";
import { followTheme } from "./theme.js";

const part = id => document.getElementById(id);
const page = new URL("./", import.meta.url);
const firstPreset = "Rosewood Xylophone";
const mayMove = () => !matchMedia("(prefers-reduced-motion: reduce)").matches;

async function fetchJson(name) {
    const answer = await fetch(new URL(name, page));
    if (!answer.ok) throw new Error(`The page's file ${name} cannot be fetched.`);
    return answer.json();
}

/** The package is imported here, so that a page without it can say so. */
async function startInstrument(context) {
    const base = new URL("idiophone/", page);
    const { Idiophone } = await import(new URL("index.js", base)).catch(() => {
        throw new Error("The instrument's module cannot be fetched.");
    });
    return Idiophone.start(context, { base });
}

/** Returns an InstrumentInfo with the ranges of its own keys, which objects have too. */
function withRanges(info) {
    const rangeOf = notes => {
        const own = notes.filter(({ isOwn }) => isOwn);
        const keys = (own.length > 0 ? own : notes).map(({ note }) => note);
        return { lowestNote: Math.min(...keys), highestNote: Math.max(...keys) };
    };
    const objects = info.objects.map((object, index) => ({
        ...object,
        ...rangeOf(info.notes.filter(note => note.object === index)),
    }));
    return { ...info, ...rangeOf(info.notes), objects };
}

/** Returns null, with a sentence on the page, if the browser draws no pictures in 3D. */
function stageOf(shaders) {
    try {
        return new Stage(part("canvas"), shaders);
    } catch {
        part("picture").classList.add("plain");
        warn("This browser shows no picture, because it has no WebGL 2; the keys play.");
        return null;
    }
}

function offerSong(context, performer) {
    const button = part("song");
    const player = new SongPlayer(context, performer, () => (button.textContent = "Play the song"));
    let events = null;
    button.addEventListener("click", async () => {
        if (player.isPlaying) return player.stop();
        try {
            events ??= fetch(new URL("songs/TheEntertainer.mid", page))
                .then(answer => answer.arrayBuffer())
                .then(bytes => songEvents(new Uint8Array(bytes)));
            player.play(await events);
            button.textContent = "Stop the song";
            say("Plays The Entertainer by Scott Joplin.");
        } catch {
            events = null;
            warn("The song cannot be fetched.");
        }
    });
    button.disabled = false;
}

async function main() {
    const context = new AudioContext({ latencyHint: "interactive" });
    startAtGesture(context, part("start"));
    const [shaders, { materials }, { mallets }, idiophone] = await Promise.all([
        fetchShaders(new URL("shaders/", page)),
        fetchJson("materials.json"),
        fetchJson("mallets.json"),
        startInstrument(context),
    ]);
    window.idiophone = idiophone;

    const performer = new Performer(idiophone);
    const stage = stageOf(shaders);
    const picture = stage && new Picture(stage, shaders, materials, mayMove);
    followTheme(part("theme"), look => stage?.setLook(look));
    const scrape = part("scrape");
    const hand =
        stage &&
        new Hand({
            canvas: part("canvas"),
            picture,
            stage,
            idiophone,
            performer,
            scrapes: event => event.shiftKey || scrape.getAttribute("aria-pressed") === "true",
        });
    scrape.addEventListener("click", () =>
        scrape.setAttribute("aria-pressed", String(scrape.getAttribute("aria-pressed") !== "true")),
    );
    part("reset-view").addEventListener("click", () => hand?.resetView());
    const keyboard = new Keyboard(part("keyboard"), part("keys-down"), part("keys-up"), performer);
    const computerKeys = new ComputerKeys(performer, keyboard);
    performer.listen((note, velocity, object) => {
        if (velocity > 0 && object !== undefined)
            picture?.showKey(object, velocity / 127, note, idiophone.get("strike_along"));
    });

    const followMaterial = () => {
        controls.showMaterial();
        pad.show();
        picture?.setMaterial(pad.chosen);
    };
    const controls = new Controls(
        { macros: part("macros"), mallets: part("mallets"), material: part("material") },
        idiophone,
        mallets,
        { onmaterial: followMaterial, onmallet: () => picture?.setMallet(controls.mallet) },
    );
    const pad = new MaterialPad(part("pad"), part("pad-text"), idiophone, materials, followMaterial);

    /** Shows an instrument that begins to play. */
    const show = info => {
        hand?.release();
        const meshes = info.objects.map((_, index) => idiophone.mesh(index));
        performer.show(info);
        keyboard.show(info);
        computerKeys.show(info);
        const [{ material }] = info.objects;
        controls.nameOwnMaterial(material.name);
        controls.show();
        pad.show(material);
        presets.show(info.name);
        part("description").textContent = info.description;
        picture?.show(info, meshes, pad.chosen, controls.mallet);
    };

    let loads = 0;
    let turn = Promise.resolve();
    /** Loads a sound after the one before, or not at all if another one is asked for meanwhile. */
    const load = (name, loading) => {
        const own = ++loads;
        turn = turn.then(async () => {
            if (own !== loads) return;
            say(`Loading ${name}.`);
            try {
                show(withRanges(await loading()));
                say("");
            } catch (error) {
                warn(error);
            }
        });
        return turn;
    };
    const loadPreset = name => load(name, () => idiophone.loadPreset(name));
    const presets = new PresetList(
        {
            section: part("presets"),
            list: part("preset-list"),
            search: part("search"),
            none: part("no-preset"),
            name: part("preset-name"),
            previous: part("previous-preset"),
            next: part("next-preset"),
        },
        idiophone.presets,
        loadPreset,
    );
    idiophone.onposes = poses => picture?.setPoses(poses);
    takeFiles({ button: part("open-file"), input: part("file"), veil: part("drop") }, file =>
        load(file.name, () => idiophone.loadObject(file, file.name)),
    );
    part("open-file").disabled = false;
    offerMidi(part("midi"), performer);
    offerSong(context, performer);
    const wanted = new URLSearchParams(location.search).get("preset") ?? firstPreset;
    const isKnown = idiophone.presets.some(({ name }) => name === wanted);
    await loadPreset(isKnown ? wanted : firstPreset);
    if (!isKnown) warn(`No preset is called ${wanted}.`);
}

main().catch(warn);
