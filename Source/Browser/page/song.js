// The notes and controllers of a Standard MIDI File, in seconds and in the order in which the
// console plays them (Console/MidiSong.cpp and TempoMap.cpp).
import { read } from "./midifile-ts/index.js";

/** Returns the bytes of a channel message, filled up to three, or null for other events. */
function bytesOf(event) {
  if (event.type !== "channel") return null;
  const { channel } = event;
  switch (event.subtype) {
    case "noteOff":
      return [0x80 | channel, event.noteNumber, event.velocity];
    case "noteOn":
      return [0x90 | channel, event.noteNumber, event.velocity];
    case "noteAftertouch":
      return [0xa0 | channel, event.noteNumber, event.amount];
    case "controller":
      return [0xb0 | channel, event.controllerType, event.value];
    case "programChange":
      return [0xc0 | channel, event.value, 0];
    case "channelAftertouch":
      return [0xd0 | channel, event.amount, 0];
    case "pitchBend":
      return [0xe0 | channel, event.value & 0x7f, event.value >> 7];
    default:
      return null;
  }
}

const kindOf = ({ bytes }) => bytes[0] >> 4;
const isNoteOff = (event) => kindOf(event) === 8;
const isNoteOn = (event) => kindOf(event) === 9;
const isPressure = (event) => kindOf(event) === 0xa || kindOf(event) === 0xd;

// Controllers precede the notes that start with them. Pressure follows, because it needs a key that
// is down.
function orderAtOneTime(event) {
  if (isNoteOff(event)) return 1;
  if (isNoteOn(event)) return 2;
  return isPressure(event) ? 3 : 0;
}

/** Returns a function from ticks to seconds. The sums are the console's, so that no bit differs. */
function tempoMap(tracks, ticksPerBeat) {
  const all = tracks.flat();
  const changes = ["setTempo", "timeSignature"]
    .flatMap((kind) => all.filter((event) => event.subtype === kind))
    .sort((a, b) => a.ticks - b.ticks);
  const stretches = [{ fromTicks: 0, fromSeconds: 0, secondsPerTick: 0.5 * (1 / ticksPerBeat) }];
  for (const change of changes) {
    const now = stretches.at(-1);
    const fromSeconds = now.fromSeconds + (change.ticks - now.fromTicks) * now.secondsPerTick;
    const secondsPerTick =
      change.subtype === "setTempo"
        ? (1 / ticksPerBeat) * (change.microsecondsPerBeat / 1e6)
        : now.secondsPerTick;
    stretches.push({ fromTicks: change.ticks, fromSeconds, secondsPerTick });
  }
  return (ticks) => {
    const next = stretches.findIndex((stretch, i) => i > 0 && stretch.fromTicks >= ticks);
    const here = stretches.at(next < 0 ? -1 : next - 1);
    return here.fromSeconds + (ticks - here.fromTicks) * here.secondsPerTick;
  };
}

/** Returns the events in runs of equal times. */
function atOneTime(events) {
  const runs = [];
  for (const event of events)
    if (runs.at(-1)?.[0].seconds === event.seconds) runs.at(-1).push(event);
    else runs.push([event]);
  return runs;
}

/**
 * Orders the notes of one key of a track. At equal times some files put note-ons before note-offs.
 * Here a note-off comes first if it ends a sounding note, or if a later note-off ends the new note.
 */
function orderKey(notes) {
  let down = 0;
  let endsBehind = 0; // surplus of note-offs over note-ons that follow
  for (const note of notes) endsBehind += isNoteOff(note) ? 1 : -1;
  for (const now of atOneTime(notes)) {
    const end = now.filter(isNoteOff).map(({ bytes }) => bytes);
    const begin = now.filter(isNoteOn).map(({ bytes }) => bytes);
    endsBehind -= end.length - begin.length;
    if (endsBehind > 0) down = Math.max(down, end.length);
    for (const note of now) {
      const isEnd = begin.length === 0 || (end.length > 0 && down > 0);
      note.bytes = (isEnd ? end : begin).shift();
      down = isEnd ? Math.max(down - 1, 0) : down + 1;
    }
  }
}

/** Returns a track's events in order of time, each with its rank among those at its time. */
function orderedTrack(events) {
  const isLater = (a, b) => a.seconds - b.seconds || isPressure(a) - isPressure(b);
  const ordered = events.toSorted(isLater);
  const notes = new Map(); // by channel and key
  for (const event of ordered) {
    if (!isNoteOn(event) && !isNoteOff(event)) continue;
    const key = 128 * (event.bytes[0] & 0x0f) + event.bytes[1];
    notes.set(key, [...(notes.get(key) ?? []), event]);
  }
  for (const ofKey of notes.values()) orderKey(ofKey);
  for (const run of atOneTime(ordered)) {
    let order = 0;
    for (const event of run) event.order = order = Math.max(order, orderAtOneTime(event));
  }
  return ordered;
}

/**
 * Returns the channel messages of a Standard MIDI File (Uint8Array) as `{ seconds, bytes }`, with
 * three bytes each. Throws if the file is damaged or its time format is SMPTE.
 */
export function songEvents(bytes) {
  const { header, tracks } = read(bytes);
  for (const track of tracks) {
    let ticks = 0;
    for (const event of track) event.ticks = ticks += event.deltaTime;
  }
  const secondsAt = tempoMap(tracks, header.ticksPerBeat);
  return tracks
    .flatMap((track) =>
      orderedTrack(
        track.flatMap((event) => {
          const message = bytesOf(event);
          return message ? [{ seconds: secondsAt(event.ticks), bytes: message }] : [];
        }),
      ),
    )
    .sort((a, b) => a.seconds - b.seconds || a.order - b.order)
    .map(({ seconds, bytes: message }) => ({ seconds, bytes: message }));
}
