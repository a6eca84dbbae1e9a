// The sliders of the Play page, the rack of mallets and the choice of the material.
import { placeInRange, textOf, valueAt } from "./parameterText.js";

const places = 1000; // of a slider

function slider(info, idiophone) {
    const row = document.createElement("div");
    row.className = "slider";
    const id = `parameter-${info.id}`;
    row.innerHTML = `<label></label><output></output><input type="range" min="0" max="${places}" />`;
    const [label, output, input] = row.children;
    label.textContent = info.name;
    label.htmlFor = input.id = id;
    output.htmlFor = id;
    input.title = info.description;
    const show = () => {
        const value = idiophone.get(info.id);
        input.value = Math.round(places * placeInRange(info, value));
        output.value = textOf(info, value);
        input.setAttribute("aria-valuetext", output.value);
        input.style.setProperty("--share", input.value / places);
    };
    const set = value => {
        idiophone.set(info.id, value);
        show();
    };
    input.addEventListener("input", () => {
        const value = valueAt(info, input.value / places);
        const middle = placeInRange(info, info.default);
        const isNearDefault = Math.abs(input.value / places - middle) < 0.004;
        set(isNearDefault ? info.default : value);
    });
    input.addEventListener("keydown", event => {
        const steps = {
            ArrowLeft: -1,
            ArrowDown: -1,
            ArrowRight: 1,
            ArrowUp: 1,
            PageDown: -10,
            PageUp: 10,
        };
        if (!(event.key in steps)) return;
        event.preventDefault();
        const place = Number(input.value) / places + 0.01 * steps[event.key];
        set(valueAt(info, Math.min(Math.max(place, 0), 1)));
    });
    input.addEventListener("dblclick", () => set(info.default));
    return { row, show };
}

const largestRadiusMetres = 0.025;

/** Three sliders. */
const customPicture = [
    [9, 30],
    [18, 18],
    [27, 28],
]
    .map(
        ([y, x]) =>
            `<path class="stick" d="M10 ${y}H38" /><circle class="knob" cx="${x}" cy="${y}" r="3.5" />`,
    )
    .join("");

function malletPicture({ head_radius_m: headMetres, colour }) {
    const radius = (14 * Math.min(headMetres, largestRadiusMetres)) / largestRadiusMetres;
    const aside = radius / 3;
    return `<path class="stick" d="M29 15 8 35" />
        <circle cx="29" cy="15" r="${radius}" fill="${colour}" />
        <circle cx="${29 - aside}" cy="${15 - aside}" r="${aside}" fill="#fff" opacity="0.35" />`;
}

function malletButton(name, mallet, index) {
    const label = document.createElement("label");
    label.className = "mallet";
    label.innerHTML = `<input type="radio" name="mallet" class="unseen" />
        <svg viewBox="0 0 48 36" aria-hidden="true"></svg><span></span>`;
    const [input, picture, text] = label.children;
    input.value = index;
    text.textContent = name;
    picture.innerHTML = mallet ? malletPicture(mallet) : customPicture;
    return label;
}

export class Controls {
    #idiophone;
    #sliders;
    #mallets;
    #material;
    #rack;
    #names; // of the mallets to choose from

    /**
     * `rack`: mallets of mallets.json. `onmallet` and `onmaterial` are called when the visitor has
     * chosen another one.
     */
    constructor({ macros, mallets, material }, idiophone, rack, { onmallet, onmaterial }) {
        this.#idiophone = idiophone;
        this.#mallets = mallets;
        this.#material = material;
        const table = new Map(idiophone.parameters.map(info => [info.id, info]));
        this.#sliders = idiophone.parameters
            .filter(info => info.group === "Play")
            .map(info => slider(info, idiophone));
        macros.replaceChildren(...this.#sliders.map(({ row }) => row));
        this.#rack = rack;
        this.#names = table.get("mallet").choices;
        const malletOf = name => rack.find(mallet => mallet.name === name);
        mallets.replaceChildren(...this.#names.map((name, i) => malletButton(name, malletOf(name), i)));
        mallets.addEventListener("change", ({ target }) => {
            idiophone.set("mallet", Number(target.value));
            onmallet();
        });
        material.replaceChildren(...table.get("material").choices.map((name, i) => new Option(name, i)));
        material.addEventListener("change", () => {
            idiophone.set("material", Number(material.value));
            onmaterial();
        });
    }

    /** The mallet in effect: the chosen one, or the one that is nearest to the custom hardness. */
    get mallet() {
        const choice = this.#idiophone.get("mallet");
        const name = this.#names[choice];
        const named = this.#rack.find(mallet => mallet.name === name);
        if (named) return { mallet: named, headMetres: named.head_radius_m };
        const modulus = this.#idiophone.get("mallet_hardness") * 1e6;
        const away = ({ effective_modulus_pa: other }) => Math.abs(Math.log(other / modulus));
        const mallet = this.#rack.reduce((a, b) => (away(b) < away(a) ? b : a));
        return { mallet, headMetres: this.#idiophone.get("mallet_radius") * 1e-3 };
    }

    /** Shows the values in effect. */
    show() {
        for (const each of this.#sliders) each.show();
        const chosen = this.#mallets.querySelector(`[value="${this.#idiophone.get("mallet")}"]`);
        if (chosen) chosen.checked = true;
        this.showMaterial();
    }

    showMaterial() {
        this.#material.value = this.#idiophone.get("material");
    }

    /** Names the object's own material in the choice. */
    nameOwnMaterial(name) {
        this.#material.options[0].textContent = name ? `Own (${name})` : "Own";
    }
}
