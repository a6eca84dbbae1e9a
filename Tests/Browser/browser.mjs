// A browser without a window, and a server of static files on the loopback address.
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { createRequire } from "node:module";

const TYPES = {
    ".css": "text/css",
    ".flac": "audio/flac",
    ".html": "text/html",
    ".js": "text/javascript",
    ".json": "application/json",
    ".mp3": "audio/mpeg",
    ".ogg": "audio/ogg",
    ".png": "image/png",
    ".svg": "image/svg+xml",
    ".txt": "text/plain",
    ".wasm": "application/wasm",
};

/**
 * Serves files of `folders`, by the first part of their paths: { "": folder, other: folder2 }. There is
 * an empty page at /empty.
 * Returns the address, the paths that were asked for with the status, and a function that ends it.
 */
export async function serve(folders) {
    const requests = [];
    const server = createServer(async (request, response) => {
        const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
        const [, first, rest] = /^\/([^/]*)\/?(.*)$/.exec(path);
        const file = first && folders[first] ? join(folders[first], normalize("/" + rest))
            : join(folders[""], normalize(path.endsWith("/") ? path + "index.html" : path));
        try {
            const bytes = path === "/empty" ? "" : await readFile(file);
            response.writeHead(200, { "Content-Type": TYPES[extname(file)] ?? "text/html" });
            response.end(bytes);
        } catch {
            response.writeHead(404);
            response.end();
        }
        requests.push({ path, status: response.statusCode });
    });
    await new Promise(resolve => server.listen(0, "127.0.0.1", resolve));
    return {
        origin: `http://127.0.0.1:${server.address().port}`,
        requests,
        close: () => new Promise(resolve => server.close(resolve)),
    };
}

/** `tools` is the folder whose node_modules has playwright-core. */
export async function launchChromium(tools, program) {
    const { chromium } = createRequire(join(tools, "package.json"))("playwright-core");
    return chromium.launch({
        executablePath: program,
        args: ["--no-sandbox", "--autoplay-policy=no-user-gesture-required",
            "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    });
}
