// The on-screen keyboard with the instrument's notes: buttons, of which one is in the tab order.

import { computerKeyLetters } from "./computerKeys.js";
import { isAccidental } from "./layout.js";

const noteNames = [
    "C",
    "C sharp ",
    "D",
    "D sharp ",
    "E",
    "F",
    "F sharp ",
    "G",
    "G sharp ",
    "A",
    "A sharp ",
    "B",
];
const octaveOf = note => Math.floor(note / 12) - 1;
const [softest, hardest] = [40, 120]; // velocities at a key's upper and lower end
const keyVelocity = 90; // of Enter

/** Returns "C4" for 60, and "C sharp 4" for 61. */
const spokenName = note => noteNames[note % 12] + octaveOf(note);

export class Keyboard {
    #area;
    #performer;
    #keys = new Map(); // note to its button
    #held = new Map(); // pointer, or the key of a button, to its note
    #focused = 60;
    #buttons;

    /** `area` holds the keys; `lower` and `higher` are buttons that scroll it where it is narrow. */
    constructor(area, lower, higher, performer) {
        this.#area = area;
        this.#performer = performer;
        this.#buttons = [lower, higher];
        area.addEventListener("pointerdown", event => this.#press(event));
        area.addEventListener("pointermove", event => this.#glide(event));
        for (const end of ["pointerup", "pointercancel"])
            area.addEventListener(end, event => this.#end(event.pointerId));
        area.addEventListener("keydown", event => this.#keyDown(event));
        area.addEventListener("keyup", event => this.#end(event.key));
        area.addEventListener("focusout", () => ["Enter", " "].forEach(key => this.#end(key)));
        lower.addEventListener("click", () => this.#scroll(-1));
        higher.addEventListener("click", () => this.#scroll(1));
        new ResizeObserver(() => this.#showButtons()).observe(area);
        area.addEventListener("scroll", () => this.#showButtons());
        performer.listen((note, velocity) =>
            this.#keys.get(note)?.classList.toggle("down", velocity > 0),
        );
    }

    /** Shows the own keys of an InstrumentInfo, at least two octaves. */
    show(info) {
        this.#held.clear();
        const sounds = new Map(info.notes.map(({ note, isOwn }) => [note, isOwn ? "own" : "resized"]));
        const lowest = info.lowestNote - (info.lowestNote % 12);
        let highest = Math.min(Math.max(info.highestNote, lowest + 24), 127);
        if (isAccidental(highest)) ++highest;
        let naturals = 0;
        this.#keys.clear();
        for (let note = lowest; note <= highest; ++note) {
            this.#keys.set(note, this.#key(note, sounds.get(note) ?? "silent", naturals));
            if (!isAccidental(note)) ++naturals;
        }
        this.#area.style.setProperty("--naturals", naturals);
        const strip = document.createElement("div");
        strip.className = "strip";
        strip.append(...this.#keys.values());
        this.#area.replaceChildren(strip);
        this.#focus(info.lowestNote, false);
        this.reveal(info.lowestNote);
        this.#showButtons();
    }

    /** Shows which keys the computer's keys play, from the note `base` on. */
    showLetters(base) {
        for (const [note, key] of this.#keys)
            key.querySelector(".letter").dataset.letter =
                computerKeyLetters[note - base]?.toUpperCase() ?? "";
    }

    /** Scrolls to a note. */
    reveal(note) {
        const key = this.#keys.get(note);
        if (key) this.#area.scrollLeft = key.offsetLeft - 0.1 * this.#area.clientWidth;
    }

    get range() {
        const notes = [...this.#keys.keys()];
        return { lowest: notes[0], highest: notes.at(-1) };
    }

    #key(note, sound, naturals) {
        const key = document.createElement("button");
        key.type = "button";
        key.dataset.note = note;
        key.id = `key-${note}`;
        key.className = `key ${isAccidental(note) ? "accidental" : "natural"} ${sound}`;
        key.tabIndex = -1;
        key.style.setProperty("--place", naturals);
        key.setAttribute("aria-label", spokenName(note));
        if (sound === "silent") key.setAttribute("aria-disabled", "true");
        const letter = document.createElement("span");
        letter.className = "letter";
        const name = document.createElement("span");
        name.className = "name";
        name.textContent = isAccidental(note) ? "" : spokenName(note);
        key.append(letter, name);
        return key;
    }

    #keyAt(event) {
        return document.elementFromPoint(event.clientX, event.clientY)?.closest(".key");
    }

    #velocityAt(key, event) {
        const area = key.getBoundingClientRect();
        const share = Math.min(Math.max((event.clientY - area.top) / area.height, 0), 1);
        return Math.round(softest + (hardest - softest) * share);
    }

    #press(event) {
        const key = event.target.closest(".key");
        if (!key || event.button !== 0) return;
        if (key.hasPointerCapture(event.pointerId)) key.releasePointerCapture(event.pointerId);
        this.#begin(event.pointerId, Number(key.dataset.note), this.#velocityAt(key, event));
    }

    #glide(event) {
        if (!this.#held.has(event.pointerId)) return;
        if (event.buttons === 0) return this.#end(event.pointerId);
        const key = this.#keyAt(event);
        if (!key || Number(key.dataset.note) === this.#held.get(event.pointerId)) return;
        this.#end(event.pointerId);
        this.#begin(event.pointerId, Number(key.dataset.note), this.#velocityAt(key, event));
    }

    #begin(holder, note, velocity) {
        this.#held.set(holder, note);
        this.#performer.noteOn(note, velocity);
    }

    #end(holder) {
        if (!this.#held.has(holder)) return;
        this.#performer.noteOff(this.#held.get(holder));
        this.#held.delete(holder);
    }

    #keyDown(event) {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const { lowest, highest } = this.range;
        const steps = { ArrowLeft: -1, ArrowRight: 1, ArrowDown: -12, ArrowUp: 12 };
        const targets = { Home: lowest, End: highest };
        const to = targets[event.key] ?? this.#focused + (steps[event.key] ?? 0);
        if (event.key in steps || event.key in targets)
            this.#focus(Math.min(Math.max(to, lowest), highest), true);
        else if (event.key === "Enter" || event.key === " ") {
            if (!event.repeat) this.#begin(event.key, this.#focused, keyVelocity);
        } else return;
        event.preventDefault();
    }

    #focus(note, takesFocus) {
        const former = this.#keys.get(this.#focused);
        if (former) former.tabIndex = -1;
        this.#focused = note;
        const key = this.#keys.get(note);
        key.tabIndex = 0;
        if (takesFocus) key.focus();
    }

    #scroll(direction) {
        const octave =
            (7 * this.#area.scrollWidth) / Number(this.#area.style.getPropertyValue("--naturals"));
        this.#area.scrollBy({ left: direction * octave });
    }

    #showButtons() {
        const { scrollLeft, scrollWidth, clientWidth } = this.#area;
        const isNarrow = scrollWidth > clientWidth + 1;
        const [lower, higher] = this.#buttons;
        lower.hidden = higher.hidden = !isNarrow;
        lower.disabled = scrollLeft < 1;
        higher.disabled = scrollLeft + clientWidth > scrollWidth - 1;
    }
}
