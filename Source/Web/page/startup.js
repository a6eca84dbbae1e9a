// What the browser must have, and the gesture that lets sound begin.

// A module with one function that returns a vector: SIMD.
const simd = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];
// A module with a function that throws and catches: exceptions.
const exceptions = [0, 97, 115, 109, 1, 0, 0, 0, 1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11];

/** Returns a sentence about what this browser lacks, or null. */
export function missingPart() {
  if (typeof WebAssembly !== "object") return "This browser has no WebAssembly, which computes the sound.";
  if (!WebAssembly.validate(Uint8Array.from(simd)))
    return "This browser has no SIMD of WebAssembly; Chrome 95, Firefox 100 and Safari 16.4 have it.";
  if (!WebAssembly.validate(Uint8Array.from(exceptions)))
    return "This browser has no exceptions of WebAssembly; Chrome 95, Firefox 100 and Safari 16.4 have them.";
  if (!isSecureContext) return "Browsers play this page only from https addresses and from this computer.";
  if (typeof AudioWorkletNode !== "function") return "This browser has no AudioWorklet, which plays the sound.";
  return null;
}

/** Starts the sound at the first press or key; until then the button `start` is shown. */
export function startAtGesture(context, start) {
  const gestures = ["pointerdown", "pointerup", "keydown", "click"]; // a touch counts when it ends
  const resume = () => context.resume().catch(() => {}); // not yet a gesture
  const follow = () => {
    start.hidden = context.state === "running";
    if (start.hidden) for (const gesture of gestures) removeEventListener(gesture, resume, true);
  };
  for (const gesture of gestures) addEventListener(gesture, resume, true);
  context.addEventListener("statechange", follow);
  follow();
}
