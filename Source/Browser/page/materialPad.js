// The map of materials as a pad: a dot for each named one, a ring at the current sound. As
// Editor/MaterialPad.h.
import { decaySecondsAt, materialAt, placeOf, soundMetresPerSecond } from "./materialPlane.js";

const [width, height] = [300, 150]; // of the picture, in its own units
const [edge, reach, dotRadius] = [14, 9, 4.5];
const [ownMaterial, customMaterial, firstLibraryMaterial] = [0, 1, 2];
const step = 0.02; // of an arrow key

const clamp = value => Math.min(Math.max(value, 0), 1);
const xOf = ({ fast }) => edge + fast * (width - 2 * edge);
const yOf = ({ ringing }) => height - edge - ringing * (height - 2 * edge);

/** Names at their dots, where they hide no other dot or name. */
function labelsOf(library) {
    const taken = library.map(material => {
        const place = placeOf(material);
        return {
            x: xOf(place) - dotRadius,
            y: yOf(place) - dotRadius,
            w: 2 * dotRadius,
            h: 2 * dotRadius,
        };
    });
    const dots = [...taken];
    const hits = (a, b) => a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
    return library.flatMap(({ name }, i) => {
        const label = { x: dots[i].x + 12, y: dots[i].y - 2, w: 6 * name.length + 2, h: 12 };
        if (label.x + label.w > width - 3) label.x = dots[i].x - 3 - label.w;
        if (taken.some(other => other !== dots[i] && hits(other, label))) return [];
        taken.push(label);
        return [`<text x="${label.x}" y="${label.y + 10}">${name}</text>`];
    });
}

function dotOf(material) {
    const place = placeOf(material);
    const at = `cx="${xOf(place)}" cy="${yOf(place)}" r="${dotRadius}"`;
    return `<circle class="dot" ${at} fill="${material.colour}"><title>${material.name}</title></circle>`;
}

export class MaterialPad {
    #area;
    #text;
    #idiophone;
    #library;
    #onmaterial;
    #own; // material of the objects
    #place = { fast: 0.5, ringing: 0.5 };

    /** `library`: the materials of materials.json, in the order of the parameter's choices. */
    constructor(area, text, idiophone, library, onmaterial) {
        this.#area = area;
        this.#text = text;
        this.#idiophone = idiophone;
        this.#library = library;
        this.#onmaterial = onmaterial;
        area.innerHTML = `<svg viewBox="0 0 ${width} ${height}" aria-hidden="true">
            ${library.map(dotOf).join("")}
            ${labelsOf(library).join("")}
            <circle class="ring" r="8" /></svg>`;
        area.tabIndex = 0;
        area.setAttribute("role", "slider");
        area.setAttribute(
            "aria-label",
            "Material pad, from slow to fast sound and from dull to ringing",
        );
        area.setAttribute("aria-valuemin", 0);
        area.setAttribute("aria-valuemax", 100);
        area.addEventListener("pointerdown", event => this.#press(event));
        area.addEventListener("pointermove", event => {
            if (area.hasPointerCapture(event.pointerId)) this.#mix(this.#placeAt(event));
        });
        area.addEventListener("keydown", event => this.#keyDown(event));
    }

    /** The material in effect of those that the parameters choose; null: each object's own. */
    get chosen() {
        const choice = this.#idiophone.get("material");
        if (choice === ownMaterial) return null;
        if (choice >= firstLibraryMaterial) return this.#library[choice - firstLibraryMaterial];
        return {
            youngs_modulus_pa: this.#idiophone.get("young") * 1e9,
            density_kg_per_m3: this.#idiophone.get("density"),
            fluid_damping_per_s: this.#idiophone.get("gamma"),
            viscoelastic_damping_s: this.#idiophone.get("eta") * 1e-6,
            loss_factor: this.#idiophone.get("loss_factor"),
        };
    }

    /** Moves the ring to the material in effect. `own` is the objects' own material. */
    show(own = this.#own) {
        this.#own = own;
        const material = this.chosen ?? own;
        const ring = this.#area.querySelector(".ring");
        this.#place = placeOf(material);
        ring.setAttribute("cx", xOf(this.#place));
        ring.setAttribute("cy", yOf(this.#place));
        const seconds = decaySecondsAt(this.#place);
        const speed = Math.round(soundMetresPerSecond(this.#place));
        const text = `${speed} m/s, rings ${seconds.toFixed(seconds < 1 ? 2 : 1)} s at 1 kHz`;
        this.#text.textContent = text;
        this.#area.setAttribute("aria-valuenow", Math.round(100 * this.#place.fast));
        this.#area.setAttribute("aria-valuetext", text);
    }

    #inPicture(event) {
        const area = this.#area.firstElementChild.getBoundingClientRect();
        return {
            x: ((event.clientX - area.left) * width) / area.width,
            y: ((event.clientY - area.top) * height) / area.height,
        };
    }

    #placeAt(event) {
        const { x, y } = this.#inPicture(event);
        return {
            fast: clamp((x - edge) / (width - 2 * edge)),
            ringing: clamp((height - edge - y) / (height - 2 * edge)),
        };
    }

    #press(event) {
        if (event.button !== 0) return;
        const { x, y } = this.#inPicture(event);
        const distances = this.#library.map(material => {
            const place = placeOf(material);
            return Math.hypot(xOf(place) - x, yOf(place) - y);
        });
        const nearest = distances.indexOf(Math.min(...distances));
        if (distances[nearest] < reach) {
            this.#idiophone.set("material", firstLibraryMaterial + nearest);
            this.#onmaterial();
            return;
        }
        this.#area.setPointerCapture(event.pointerId);
        this.#mix(this.#placeAt(event));
    }

    #keyDown(event) {
        const steps = {
            ArrowLeft: [-step, 0],
            ArrowRight: [step, 0],
            ArrowDown: [0, -step],
            ArrowUp: [0, step],
        };
        if (!steps[event.key]) return;
        event.preventDefault();
        const [fast, ringing] = steps[event.key];
        this.#mix({
            fast: clamp(this.#place.fast + fast),
            ringing: clamp(this.#place.ringing + ringing),
        });
    }

    #mix(place) {
        const material = materialAt(place, this.#library);
        const figures = {
            young: material.youngs_modulus_pa * 1e-9,
            density: material.density_kg_per_m3,
            gamma: material.fluid_damping_per_s,
            eta: material.viscoelastic_damping_s * 1e6,
            loss_factor: material.loss_factor,
            material: customMaterial, // after its figures
        };
        for (const [id, value] of Object.entries(figures)) this.#idiophone.set(id, value);
        this.#onmaterial();
    }
}
