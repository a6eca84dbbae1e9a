// Sends notes and messages to the instrument, and tells the keyboard and the picture about them at
// the time they sound.

export class Performer {
    #idiophone;
    #objectOfNote = new Map();
    #listeners = [];

    constructor(idiophone) {
        this.#idiophone = idiophone;
    }

    /** Takes the notes of an InstrumentInfo. */
    show(info) {
        this.#objectOfNote = new Map(info.notes.map(({ note, object }) => [note, object]));
    }

    /** `listener` gets (note, velocity, object) for each note; a velocity of 0 ends it. */
    listen(listener) {
        this.#listeners.push(listener);
    }

    noteOn(note, velocity) {
        this.#idiophone.noteOn(note, velocity);
        this.#tell(note, velocity);
    }

    noteOff(note) {
        this.#idiophone.noteOff(note);
        this.#tell(note, 0);
    }

    /** Sends a MIDI message at a time in context seconds; without one, now. */
    send(bytes, time) {
        this.#idiophone.send(bytes, time);
        const [status, note, velocity] = bytes;
        const kind = status >> 4;
        if (kind !== 8 && kind !== 9) return;
        const wait = time === undefined ? 0 : time - this.#idiophone.context.currentTime;
        const tell = () => this.#tell(note, kind === 9 ? velocity : 0);
        if (wait > 0) setTimeout(tell, 1000 * wait);
        else tell();
    }

    #tell(note, velocity) {
        for (const listener of this.#listeners) listener(note, velocity, this.#objectOfNote.get(note));
    }
}
