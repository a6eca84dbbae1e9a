// The gesture that lets sound begin.

/**
 * Starts the sound at a press or key, and again if the system has interrupted it. Shows the button
 * `start` while it waits for that.
 */
export function startAtGesture(context, start) {
    const resume = () => {
        if (context.state !== "running") context.resume().catch(() => {}); // not yet a gesture
    };
    // A touch counts as a gesture when it ends.
    for (const gesture of ["pointerdown", "pointerup", "keydown", "click"])
        addEventListener(gesture, resume, true);
    const show = () => (start.hidden = context.state === "running");
    context.addEventListener("statechange", show);
    show();
}
