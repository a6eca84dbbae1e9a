// The site in Chromium, for the tests of its pages.
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before } from "node:test";

import { launchChromium, serve } from "./browser.mjs";

/**
 * A server of the folder `site` and a browser, for all tests of a file. They may leave screenshots in the
 * folder `pictures`. `tools` and `program`: see launchChromium.
 */
export class BrowsedSite {
    #tools;

    constructor({ tools, program, site, pictures }) {
        this.#tools = tools;
        before(async () => {
            mkdirSync(pictures, { recursive: true });
            this.server = await serve({ "": site });
            this.browser = await launchChromium(tools, program);
        });
        after(async () => {
            await this.browser?.close();
            await this.server?.close();
        });
    }

    /** Opens an empty page. Returns it with the list of faults that it collects. */
    async newPage(options) {
        const context = await this.browser.newContext(options);
        const page = await context.newPage();
        const faults = [];
        const add = fault => faults.push(`${page.url()}: ${fault}`);
        page.on("pageerror", error => add(error.message));
        page.on("console", message => {
            if (message.type() === "error")
                add(message.text());
        });
        page.on("request", request => {
            if (!request.url().startsWith(this.server.origin) && !/^(data|blob):/.test(request.url()))
                add(`it asks for ${request.url()}`);
        });
        return { page, faults, close: () => context.close() };
    }

    /** Returns the serious faults that axe-core finds in a page. */
    async seriousFaults(page) {
        const { resolve } = createRequire(join(this.#tools, "package.json"));
        await page.evaluate(readFileSync(resolve("axe-core/axe.min.js"), "utf8"));
        const { violations } = await page.evaluate(() => window.axe.run({ resultTypes: ["violations"] }));
        return violations.filter(({ impact }) => ["serious", "critical"].includes(impact))
            .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html.slice(0, 100))}`);
    }
}
