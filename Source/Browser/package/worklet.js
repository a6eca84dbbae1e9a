// Renders the instrument on the audio thread. Messages arrive between callbacks, in the order in
// which the page has sent them; `process` neither allocates nor reads them.
import { InstrumentModule } from "./module.js";

const FRAMES = 128;
const FADE_QUANTA = 8; // some 20 ms
const milliseconds = globalThis.performance ? () => performance.now() : () => Date.now();

class IdiophoneProcessor extends AudioWorkletProcessor {
    constructor({ processorOptions: { code, isOffline } }) {
        super();
        this.module = new InstrumentModule(code, sampleRate, isOffline);
        this.events = []; // MIDI messages in order of time
        this.next = 0; // the first one that is not played yet
        this.fade = null; // { left: quanta, id }: the sound goes down before another one is loaded
        this.isSilent = false; // after that fade
        this.clearReport();
        this.findOutput();
        this.port.onmessage = ({ data }) => this.receive(data);
    }

    clearReport() {
        this.report = { spent: 0, quanta: 0 };
    }

    /** Finds the output anew, because memory that grows moves. */
    findOutput() {
        const { memory, instrument_render: render } = this.module.exports;
        if (this.left?.buffer === memory.buffer)
            return;
        const address = render(0);
        this.left = new Float32Array(memory.buffer, address, FRAMES);
        this.right = new Float32Array(memory.buffer, address + 4 * FRAMES, FRAMES);
    }

    receive({ id, name, values }) {
        try {
            const result = name === "fadeOut" ? this.fadeOut(id) : this[name](...values);
            if (id !== undefined && name !== "fadeOut")
                this.port.postMessage({ id, result });
        } catch (error) {
            this.port.postMessage({ id, error: String(error.message ?? error) });
        }
        this.findOutput();
    }

    /** Calls a function with byte arrays. Returns the bytes of its sentence if it fails, or null. */
    call(name, ...arrays) {
        return this.module.call(name, ...arrays) === 0 ? this.module.answer() : null;
    }

    fadeIn() {
        this.fade = null;
        this.isSilent = false;
    }

    /** Answers when the sound is down. */
    fadeOut(id) {
        this.fade = { left: FADE_QUANTA, id };
    }

    control(name, ...numbers) {
        this.module.exports["instrument_" + name](...numbers);
    }

    silence() {
        this.events.length = this.next = 0;
        this.module.exports.instrument_silence();
    }

    send(frame, bytes) {
        if (this.next > 1000) {
            this.events.splice(0, this.next);
            this.next = 0;
        }
        let place = this.events.length;
        while (place > this.next && this.events[place - 1].frame > frame)
            --place;
        this.events.splice(place, 0, { frame, bytes });
    }

    takeReport() {
        const { spent, quanta } = this.report;
        this.clearReport();
        return { share: quanta > 0 ? spent / (1000 * quanta * FRAMES / sampleRate) : 0, quanta };
    }

    work() {
        const { memory, instrument_work, instrument_poses, instrument_poses_size } = this.module.exports;
        instrument_work();
        const address = instrument_poses();
        const size = instrument_poses_size();
        if (size > 0)
            this.port.postMessage({ poses: new Float32Array(memory.buffer, address, size).slice() });
    }

    settled() {}

    process(_, [[left, right]]) {
        const begin = milliseconds();
        const { instrument_render: render, instrument_send: send } = this.module.exports;
        for (; this.next < this.events.length; ++this.next) {
            const { frame, bytes } = this.events[this.next];
            if (frame >= currentFrame + FRAMES)
                break;
            send(Math.max(frame - currentFrame, 0), bytes[0], bytes[1] ?? 0, bytes[2] ?? 0);
        }
        render(FRAMES);
        this.findOutput(); // offline, the bodies of a scene are simulated meanwhile
        if (this.isSilent)
            return true;
        left.set(this.left);
        right.set(this.right);
        if (this.fade !== null)
            this.fadeQuantum(left, right);
        this.report.spent += milliseconds() - begin;
        ++this.report.quanta;
        return true;
    }

    fadeQuantum(left, right) {
        for (let k = 0; k < FRAMES; ++k) {
            const gain = (this.fade.left - (k + 1) / FRAMES) / FADE_QUANTA;
            left[k] *= gain;
            right[k] *= gain;
        }
        if (--this.fade.left > 0)
            return;
        this.port.postMessage({ id: this.fade.id });
        this.fade = null;
        this.isSilent = true;
    }
}

registerProcessor("idiophone", IdiophoneProcessor);
