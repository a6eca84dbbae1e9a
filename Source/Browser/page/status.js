// The lines under the picture: a sentence of the state and a sentence of an error. Screen readers
// speak both.

/** Shows a sentence, in place of an error. */
export function say(sentence) {
    document.getElementById("alert").textContent = "";
    document.getElementById("status").textContent = sentence;
}

/** Shows the sentence of an error. */
export function warn(error) {
    document.getElementById("status").textContent = "";
    document.getElementById("alert").textContent = error?.message ?? String(error);
}
