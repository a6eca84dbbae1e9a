// The dark and the light look: the system's, until the button is used.
import { channelsOf } from "./appearance.js";

const dark = matchMedia("(prefers-color-scheme: dark)");

/** Calls `onchange` now and at each change with the look: `isDark` and the colours of the picture. */
export function followTheme(button, onchange) {
    let isDark = dark.matches;
    const show = () => {
        document.getElementById("light").media = isDark ? "not all" : "all";
        button.setAttribute("aria-pressed", String(isDark));
        const style = getComputedStyle(document.documentElement);
        const colour = name => channelsOf(style.getPropertyValue(name).trim());
        onchange({ isDark, panel: colour("--panel"), accent: colour("--accent") });
    };
    const follow = () => {
        isDark = dark.matches;
        show();
    };
    dark.addEventListener("change", follow);
    button.addEventListener("click", () => {
        dark.removeEventListener("change", follow);
        isDark = !isDark;
        show();
    });
    show();
}
