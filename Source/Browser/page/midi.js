// MIDI keyboards, in browsers that have Web MIDI. The button asks for permission.
import { say, warn } from "./status.js";

function listen(access, performer) {
    for (const input of access.inputs.values())
        input.onmidimessage = ({ data }) => {
            if (data[0] < 0xf0) performer.send(data);
        };
}

function describe(access) {
    const names = [...access.inputs.values()].map(input => input.name);
    say(
        names.length > 0 ? `MIDI plays from ${names.join(", ")}.` : "No MIDI keyboard is connected yet.",
    );
}

export function offerMidi(button, performer) {
    button.hidden = typeof navigator.requestMIDIAccess !== "function";
    button.addEventListener("click", async () => {
        try {
            const access = await navigator.requestMIDIAccess();
            access.onstatechange = () => listen(access, performer);
            listen(access, performer);
            describe(access);
        } catch {
            warn("The browser gave no permission for MIDI; allow it in the settings of this page.");
        }
    });
}
