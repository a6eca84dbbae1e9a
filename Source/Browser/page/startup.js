// The gesture that lets sound begin.

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
