// Measures what the WebAssembly module costs in Node, beside the native library (docs/web.md).
//
//     node web_speed.mjs idiophone.wasm strikes
//
// 37 vibraphone bars ring under 40 strikes a second for 10 s, in blocks of 128 frames. `strikes` is
// the program of Tests/Web. Prints the share of real time that one core spends, the minimum of five
// rounds; native and module take turns.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { devNull } from "node:os";
import { fileURLToPath } from "node:url";

import { Engine, readModule, renderStrikes } from "../Web/engine.mjs";

const [modulePath, nativeProgram] = process.argv.slice(2);
const ROUNDS = 5, SECONDS = 10, STRIKES_PER_SECOND = 40;
const paths = Array.from({ length: 37 }, (_, k) => fileURLToPath(
    new URL(`../../Resources/Objects/vibraphone-${53 + k}.modal`, import.meta.url)));
const objects = paths.map(path => readFileSync(path));
const engine = new Engine(readModule(modulePath));
renderStrikes(engine, objects, 2, STRIKES_PER_SECOND); // V8 compiles the module while it runs
const spent = { native: [], module: [] };
for (let round = 0; round < ROUNDS; ++round) {
    spent.native.push(Number(execFileSync(nativeProgram,
        [devNull, SECONDS, STRIKES_PER_SECOND, ...paths], { encoding: "utf8" })));
    spent.module.push(renderStrikes(engine, objects, SECONDS, STRIKES_PER_SECOND).processorSeconds);
}
const minimum = name => Math.min(...spent[name]) / SECONDS;
for (const name of ["native", "module"])
    console.log(`${name}: ${(100 * minimum(name)).toFixed(2)} % of one core`);
console.log(`ratio ${(minimum("module") / minimum("native")).toFixed(2)}`);
