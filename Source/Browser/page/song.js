// The channel messages of a Standard MIDI File, in seconds and in order of time.
import { read } from "./midifile-ts/index.js";

/** Returns the three bytes of a note, a controller or a bend, or null for other events. */
function bytesOf({ type, subtype, channel, noteNumber, velocity, controllerType, value }) {
    if (type !== "channel") return null;
    switch (subtype) {
        case "noteOff":
            return [0x80 | channel, noteNumber, velocity];
        case "noteOn":
            return [0x90 | channel, noteNumber, velocity];
        case "controller":
            return [0xb0 | channel, controllerType, value];
        case "pitchBend":
            return [0xe0 | channel, value & 0x7f, value >> 7];
        default:
            return null;
    }
}

/** At one time, controllers precede the ends of notes, and these precede notes that begin. */
const orderAtOneTime = ({ bytes: [status] }) => (status < 0x90 ? 1 : status < 0xa0 ? 2 : 0);

/** Returns a function from ticks to seconds. */
function tempoMap(events, ticksPerBeat) {
    const stretches = [{ ticks: 0, seconds: 0, secondsPerTick: 0.5 / ticksPerBeat }];
    const secondsAt = ticks => {
        const here = stretches.findLast(stretch => stretch.ticks <= ticks);
        return here.seconds + (ticks - here.ticks) * here.secondsPerTick;
    };
    for (const { subtype, ticks, microsecondsPerBeat } of events)
        if (subtype === "setTempo")
            stretches.push({
                ticks,
                seconds: secondsAt(ticks),
                secondsPerTick: microsecondsPerBeat / 1e6 / ticksPerBeat,
            });
    return secondsAt;
}

/** Returns `{ seconds, bytes }` of each message. Throws if the file (Uint8Array) is damaged. */
export function songEvents(file) {
    const { header, tracks } = read(file);
    for (const track of tracks) {
        let ticks = 0;
        for (const event of track) event.ticks = ticks += event.deltaTime;
    }
    const events = tracks.flat().sort((a, b) => a.ticks - b.ticks);
    const secondsAt = tempoMap(events, header.ticksPerBeat);
    return events
        .map(event => ({ seconds: secondsAt(event.ticks), bytes: bytesOf(event) }))
        .filter(({ bytes }) => bytes !== null)
        .sort((a, b) => a.seconds - b.seconds || orderAtOneTime(a) - orderAtOneTime(b));
}
