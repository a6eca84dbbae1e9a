// The computer's keys as notes, in two rows as in the standalone; Z and X shift them by an octave.

/** From a C upwards. The letters are those of a US keyboard; the places count on others. */
export const computerKeyLetters = [..."awsedftgyhujkolp;"];

const codes = computerKeyLetters.map(letter =>
    letter === ";" ? "Semicolon" : `Key${letter.toUpperCase()}`,
);
const velocity = 90;

/** The C from which the computer's keys, an octave and a half, cover most of the range. */
function baseOf({ lowestNote, highestNote }) {
    const reached = base => Math.min(highestNote, base + codes.length - 1) - Math.max(lowestNote, base);
    const below = lowestNote - (lowestNote % 12);
    return reached(below + 12) > reached(below) ? below + 12 : below;
}

const isTyping = target => target.closest?.("input:not([type=range]):not([type=radio]), select");

export class ComputerKeys {
    #performer;
    #keyboard;
    #held = new Map(); // code to note
    #base = 60;

    constructor(performer, keyboard) {
        this.#performer = performer;
        this.#keyboard = keyboard;
        addEventListener("keydown", event => this.#press(event));
        addEventListener("keyup", event => this.#lift(event.code));
        addEventListener("blur", () => this.#liftAll());
    }

    /** Takes the range of an InstrumentInfo. */
    show(info) {
        this.#liftAll();
        this.#base = baseOf(info);
        this.#keyboard.showLetters(this.#base);
    }

    #press(event) {
        if (event.repeat || event.ctrlKey || event.metaKey || event.altKey || isTyping(event.target))
            return;
        if (event.code === "KeyZ" || event.code === "KeyX")
            this.#shift(event.code === "KeyZ" ? -12 : 12);
        const step = codes.indexOf(event.code);
        if (step < 0 || this.#base + step > 127) return;
        event.preventDefault();
        this.#held.set(event.code, this.#base + step);
        this.#performer.noteOn(this.#base + step, velocity);
    }

    #lift(code) {
        if (!this.#held.has(code)) return;
        this.#performer.noteOff(this.#held.get(code));
        this.#held.delete(code);
    }

    #liftAll() {
        for (const code of [...this.#held.keys()]) this.#lift(code);
    }

    #shift(semitones) {
        const { lowest, highest } = this.#keyboard.range;
        const base = this.#base + semitones;
        if (base < lowest || base > highest) return;
        this.#liftAll();
        this.#base = base;
        this.#keyboard.showLetters(base);
        this.#keyboard.reveal(base);
    }
}
