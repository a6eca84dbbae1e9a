// Speaks to `instrument.wasm` by addresses and lengths. The page and the AudioWorklet have an
// instance each. An AudioWorklet has no TextEncoder, so texts are bytes here.

/** Throws if the bytes are no module that this browser knows. */
export class InstrumentModule {
    /** @param {BufferSource | WebAssembly.Module} code */
    constructor(code, sampleRateHz, isOffline) {
        const module = code instanceof WebAssembly.Module ? code : new WebAssembly.Module(code);
        this.exports = new WebAssembly.Instance(module, {}).exports;
        this.exports._initialize();
        this.exports.instrument_start(sampleRateHz, isOffline ? 1 : 0);
    }

    /** Calls a function with the address and length of each of the byte arrays. */
    call(name, ...arrays) {
        const { malloc, free, memory } = this.exports;
        const addresses = arrays.map(bytes => malloc(Math.max(bytes.length, 1)));
        try {
            if (addresses.includes(0))
                throw new Error("The browser has no more memory for the instrument.");
            arrays.forEach((bytes, k) =>
                new Uint8Array(memory.buffer, addresses[k], bytes.length).set(bytes));
            return this.exports["instrument_" + name](
                ...arrays.flatMap((bytes, k) => [addresses[k], bytes.length]));
        } finally {
            addresses.forEach(free);
        }
    }

    /** Returns a copy of the last answer, or of the sentence of the last error. */
    answer() {
        const { memory, instrument_answer_text: text, instrument_answer_size: size } = this.exports;
        return new Uint8Array(memory.buffer, text(), size()).slice();
    }
}
