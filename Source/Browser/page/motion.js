// The light of struck objects, which spreads from the struck place and fades, and the swing of
// struck bars.
const [spreadSeconds, flashSeconds, glowSeconds] = [0.3, 0.12, 0.7];
const settledSeconds = 2;
const [swingHz, swingSeconds] = [7, 0.28];
const stillMilliseconds = 300; // of the light where nothing may move

export class StrikeMotion {
    #strikes = new Map(); // object to its last strike
    #objects = [];

    /**
     * Starts with objects at rest: each has `meshes`, `radius` in metres, `isWhole` (its light is even)
     * and `swingMetres` (0: it does not swing).
     */
    reset(objects) {
        this.#objects = objects;
        this.#strikes.clear();
    }

    /** `place` is in the picture's metres; `strength` from 0 to 1. */
    strike(index, place, strength) {
        this.#strikes.set(index, { place, strength, age: 0 });
    }

    /** Lights an object evenly for a moment, without motion. Calls `onchange` when it ends. */
    light(index, strength, onchange) {
        const object = this.#objects[index];
        clearTimeout(object.timer);
        const show = glow => {
            for (const { material } of object.meshes) {
                material.uniforms.glow.value = glow;
                material.uniforms.glowRadius.value = 1e6;
            }
            onchange();
        };
        show(0.3 + 0.5 * strength);
        object.timer = setTimeout(() => show(0), stillMilliseconds);
    }

    /** Returns whether something still moves or glows. */
    advance(seconds) {
        for (const [index, strike] of this.#strikes) {
            strike.age += seconds;
            const { meshes, radius, isWhole, swingMetres } = this.#objects[index];
            const { age, strength, place } = strike;
            const spread = 1 - Math.exp(-age / spreadSeconds);
            const flash = Math.exp(-age / flashSeconds);
            const lasting = strength * (1 - 0.5 * spread) * Math.exp(-age / glowSeconds);
            const isOver = age > settledSeconds;
            const swing = Math.sin(2 * Math.PI * swingHz * age) * Math.exp(-age / swingSeconds);
            for (const { material } of meshes) {
                const { uniforms } = material;
                uniforms.glow.value = isOver ? 0 : Math.max(lasting, flash * (0.4 + 0.6 * strength));
                uniforms.glowPlace.value.copy(place);
                uniforms.glowRadius.value = isWhole ? 1e6 : radius * (0.14 + 2.06 * spread);
                uniforms.offsetScale.value = isOver ? 0 : -swingMetres * strength * swing;
            }
            if (isOver) this.#strikes.delete(index);
        }
        return this.#strikes.size > 0;
    }
}
