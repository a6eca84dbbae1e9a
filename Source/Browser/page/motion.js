// The light of struck objects, which spreads from the struck place and fades, and the swing of
// struck bars.
const [spreadSeconds, flashSeconds, glowSeconds] = [0.3, 0.12, 0.7];
const settledSeconds = 2;
const [swingHz, swingSeconds] = [7, 0.28];

export class StrikeMotion {
  #strikes = new Map(); // object to its last strike
  #objects = [];

  /**
   * Starts with objects at rest: each has `meshes`, `radius` in metres, `isWhole` (its light is
   * even) and `swingMetres` (0: it does not swing).
   */
  reset(objects) {
    this.#objects = objects;
    this.#strikes.clear();
  }

  /** `place` is in the picture's metres; `strength` from 0 to 1. */
  strike(object, place, strength) {
    if (this.#objects[object]) this.#strikes.set(object, { place, strength, age: 0 });
  }

  /** Returns whether something still moves or glows. */
  advance(seconds, swings) {
    for (const [index, strike] of this.#strikes) {
      strike.age += seconds;
      const object = this.#objects[index];
      const { age, strength, place } = strike;
      const spread = 1 - Math.exp(-age / spreadSeconds);
      const flash = Math.exp(-age / flashSeconds);
      const lasting = strength * (1 - 0.5 * spread) * Math.exp(-age / glowSeconds);
      const isOver = age > settledSeconds;
      const swing = Math.sin(2 * Math.PI * swingHz * age) * Math.exp(-age / swingSeconds);
      for (const { material } of object.meshes) {
        const { uniforms } = material;
        uniforms.glow.value = isOver ? 0 : Math.max(lasting, flash * (0.4 + 0.6 * strength));
        uniforms.glowPlace.value.copy(place);
        uniforms.glowRadius.value = object.isWhole ? 1e6 : object.radius * (0.14 + 2.06 * spread);
        uniforms.offsetScale.value = swings && !isOver ? -object.swingMetres * strength * swing : 0;
      }
      if (isOver) this.#strikes.delete(index);
    }
    return this.#strikes.size > 0;
  }
}
