// A file that is dropped anywhere or opened with the button.

/** Calls `play(file)` for each. `veil` is shown while a file hovers over the page. */
export function takeFiles({ button, input, veil }, play) {
    button.addEventListener("click", () => input.click());
    input.addEventListener("change", () => {
        if (input.files[0]) play(input.files[0]);
        input.value = ""; // so that the same file can be chosen again
    });
    const hasFiles = event => event.dataTransfer?.types.includes("Files");
    addEventListener("dragover", event => {
        if (!hasFiles(event)) return;
        event.preventDefault();
        veil.hidden = false;
    });
    addEventListener("dragleave", event => {
        if (!event.relatedTarget) veil.hidden = true;
    });
    addEventListener("drop", event => {
        veil.hidden = true;
        if (!hasFiles(event)) return;
        event.preventDefault();
        if (event.dataTransfer.files[0]) play(event.dataTransfer.files[0]);
    });
}
