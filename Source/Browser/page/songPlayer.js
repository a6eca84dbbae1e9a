// Plays a song a little ahead of the sound, so that its times are exact.

const aheadSeconds = 0.2;
const pollMilliseconds = 40;
const startSeconds = 0.1;
const tailSeconds = 1; // after the last event, until the song counts as over

export class SongPlayer {
    #context;
    #performer;
    #onend;
    #timer = null;
    #sounding = new Map(); // "channel key" to its note-off

    /** `onend` is called when the song is over or stopped. */
    constructor(context, performer, onend) {
        this.#context = context;
        this.#performer = performer;
        this.#onend = onend;
    }

    get isPlaying() {
        return this.#timer !== null;
    }

    /** Plays events of songEvents() from now on. */
    play(events) {
        const start = this.#context.currentTime + startSeconds;
        const end = events.at(-1).seconds + tailSeconds;
        let next = 0;
        const poll = () => {
            const now = this.#context.currentTime - start;
            for (; next < events.length && events[next].seconds < now + aheadSeconds; ++next)
                this.#send(events[next].bytes, start + events[next].seconds);
            if (now > end) this.stop();
        };
        this.#timer = setInterval(poll, pollMilliseconds);
        poll();
    }

    /** Ends the notes that sound and lifts the pedal. */
    stop() {
        if (!this.isPlaying) return;
        clearInterval(this.#timer);
        this.#timer = null;
        const after = this.#context.currentTime + aheadSeconds; // of what is sent already
        for (const bytes of this.#sounding.values()) this.#performer.send(bytes, after);
        this.#sounding.clear();
        this.#performer.send([0xb0, 64, 0], after);
        this.#onend();
    }

    #send(bytes, time) {
        const [status, key] = bytes;
        const channel = status & 0x0f;
        if (status >> 4 === 9) this.#sounding.set(`${channel} ${key}`, [0x80 | channel, key, 0]);
        if (status >> 4 === 8) this.#sounding.delete(`${channel} ${key}`);
        this.#performer.send(bytes, time);
    }
}
