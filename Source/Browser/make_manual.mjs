// Makes the site's manual and gallery: node make_manual.mjs SOURCES SITE
// The manual has every page to which README.md leads, by links or over other pages. Run it in a folder
// whose node_modules has markdown-it.
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { join, posix } from "node:path";

import MarkdownIt from "markdown-it";
import anchor from "markdown-it-anchor";

const [sources, site] = process.argv.slice(2);
const INDEX = "README.md"; // its last table is the manual's list of pages
const MANUAL = "docs/manual/README.md";
const CARRIED = /\.(png|svg|flac|ogg|mid)$|^LICENSE/;
const SOUND = /\.(flac|ogg)$/;

const markdown = new MarkdownIt({ html: true });
const escape = markdown.utils.escapeHtml;

/** Returns the file of the site that a file of the sources becomes. */
function placeOf(file) {
    const place = file.startsWith("docs/manual/") ? file.slice("docs/".length)
        : posix.join("manual/reference", file.replace(/^docs\//, ""));
    return place.replace(/README\.md$/, "index.md").replace(/\.md$/, ".html").replace(/LICENSE.*$/, "$&.txt");
}

/** Returns a relative link from one file of the site to another. */
const link = (from, to) => encodeURI(posix.relative(posix.dirname(from), to));

function write(place, text) {
    mkdirSync(join(site, posix.dirname(place)), { recursive: true });
    writeFileSync(join(site, place), text);
}

/** Copies a file of the sources into the site. Returns its place. */
function carry(file, from) {
    if (!existsSync(join(sources, file)))
        throw new Error(`${from}: the link to ${file} leads nowhere.`);
    const place = placeOf(file);
    mkdirSync(join(site, posix.dirname(place)), { recursive: true });
    copyFileSync(join(sources, file), join(site, place));
    return place;
}

/** Returns a player of a sound; make_site.sh sets an MP3 beside each Ogg file. */
function player(address, name) {
    const types = address.endsWith(".ogg")
        ? { [address]: "audio/ogg; codecs=vorbis", [address.replace(/ogg$/, "mp3")]: "audio/mpeg" }
        : { [address]: "audio/flac" };
    const choices = Object.entries(types).map(([source, type]) => `<source src="${source}" type="${type}">`);
    return `<audio controls preload="none" aria-label="${escape(name)}">${choices.join("")}</audio>`;
}

// A rendered page's `env`: its `file`, the `headings` found, the `links` to other pages, and the
// `linkEnd` of the link that is open.
const { rules } = markdown.renderer;

rules.link_open = (tokens, index, options, env) => {
    const address = tokens[index].attrGet("href");
    const end = tokens.findIndex(({ type }, i) => i > index && type === "link_close");
    const text = tokens.slice(index + 1, end).map(({ content }) => content).join("");
    const [, path, heading] = /^([^#]*)(.*)$/.exec(address);
    const opened = target => `<a href="${escape(target)}">`;
    env.linkEnd = "</a>";
    if (path === "" || /^[a-z]+:/.test(path))
        return opened(address);
    const file = posix.join(posix.dirname(env.file), decodeURI(path));
    const place = placeOf(env.file);
    if (file.endsWith(".md")) {
        env.links.push(file);
        return opened(link(place, placeOf(file)) + heading);
    }
    if (SOUND.test(file)) {
        env.linkEnd = " " + player(link(place, carry(file, env.file)), text);
        return "";
    }
    if (CARRIED.test(file))
        return opened(link(place, carry(file, env.file)));
    const isCode = tokens[index + 1].type === "code_inline";
    env.linkEnd = isCode ? "" : "</code>";
    return isCode ? "" : "<code>";
};
rules.link_close = (tokens, index, options, env) => env.linkEnd;

const image = rules.image;
rules.image = (tokens, index, options, env, renderer) => {
    const file = posix.join(posix.dirname(env.file), decodeURI(tokens[index].attrGet("src")));
    tokens[index].attrSet("src", link(placeOf(env.file), carry(file, env.file)));
    return image(tokens, index, options, env, renderer);
};

// Wide tables and code scroll by themselves, also by keys.
rules.table_open = () => `<div class="wide" tabindex="0"><table>\n`;
rules.table_close = () => "</table></div>\n";
for (const name of ["fence", "code_block"]) {
    const rule = rules[name];
    rules[name] = (...all) => rule(...all).replace("<pre", `<pre tabindex="0"`);
}

let headings; // of the page that is being read
markdown.use(anchor, {
    tabIndex: false,
    slugify: text => text.toLowerCase().replace(/[^\p{L}\p{M}\p{N}\p{Pc}\- ]/gu, "").replaceAll(" ", "-"),
    callback: ({ tag }, { slug, title }) => headings.push({ tag, slug, title }),
});
/** Returns a page of the sources: `file`, `title`, `headings`, `links`, `tokens` and `body`. */
function convert(file) {
    if (!existsSync(join(sources, file)))
        throw new Error(`${file}: this page, to which others lead, is missing.`);
    headings = [];
    const page = { file, headings, links: [] };
    page.tokens = markdown.parse(readFileSync(join(sources, file), "utf8"), page);
    page.title = headings.find(({ tag }) => tag === "h1").title;
    page.body = markdown.renderer.render(page.tokens, markdown.options, page);
    return page;
}

function convertAll() {
    const pages = new Map();
    const pending = [INDEX];
    while (pending.length > 0) {
        const file = pending.pop();
        if (pages.has(file))
            continue;
        pages.set(file, convert(file));
        pending.push(...pages.get(file).links);
    }
    return pages;
}

/** Returns the rows of the index's last table as groups of pages: `name`, `links` of `text` and `file`. */
function groupsOf({ tokens }) {
    const start = tokens.findLastIndex(({ type }) => type === "tbody_open");
    const cells = tokens.slice(start).filter(({ type }) => type === "inline");
    const groups = [];
    for (let i = 0; i + 1 < cells.length; i += 2) {
        const { children } = cells[i + 1];
        const links = children.flatMap((token, at) => token.type !== "link_open" ? []
            : [{ text: children[at + 1].content, file: token.attrGet("href") }]);
        groups.push({ name: cells[i].content, links });
    }
    return groups;
}

/** Returns the text of a page at `place`. `contents` is what stands beside its text. */
function layOut({ place, title, body, contents = "" }) {
    const to = target => link(place, target);
    const entry = (target, name) =>
        `<a href="${to(target)}"${target === place ? ` aria-current="page"` : ""}>${name}</a>`;
    return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escape(title)}</title>
<link rel="icon" href="${to("icon.svg")}" type="image/svg+xml">
<link rel="stylesheet" href="${to("look.css")}">
<link rel="stylesheet" href="${to("light.css")}" media="(prefers-color-scheme: light)">
<link rel="stylesheet" href="${to("manual.css")}">
</head>
<body>
<header>
<a class="brand" href="${to("index.html")}">Idiophone</a>
<nav aria-label="Site">
${entry("index.html", "Play")}
${entry("gallery.html", "Gallery")}
${entry(placeOf(MANUAL), "Manual")}
${entry(placeOf(INDEX), "About")}
${contents && `<a class="to-contents" href="#contents">Contents</a>`}
</nav>
</header>
<main>
${body}</main>
${contents}</body>
</html>
`;
}

function contentsOf({ file, headings }, groups) {
    const place = placeOf(file);
    const list = (name, entries) =>
        entries.length === 0 ? "" : `<h2>${escape(name)}</h2>\n<ul>\n${entries.join("\n")}\n</ul>\n`;
    const here = headings.filter(({ tag }) => tag === "h2")
        .map(({ slug, title }) => `<li><a href="#${slug}">${escape(title)}</a></li>`);
    const entry = ({ text, file: target }) => `<li><a href="${link(place, placeOf(target))}"` +
        `${target === file ? ` aria-current="page"` : ""}>${escape(text)}</a></li>`;
    return `<nav id="contents" aria-label="Contents">
${list("On this page", here)}${groups.map(({ name, links }) => list(name, links.map(entry))).join("")}</nav>
`;
}

function writeManual() {
    const pages = convertAll();
    const groups = groupsOf(pages.get(INDEX));
    for (const page of pages.values()) {
        const { file, title, body } = page;
        const book = file.startsWith("docs/manual/") ? "Idiophone manual" : "Idiophone reference";
        write(placeOf(file), layOut({
            place: placeOf(file),
            title: title.startsWith("Idiophone") ? title : `${title} – ${book}`,
            body,
            contents: contentsOf(page, groups),
        }));
    }
    return pages.size;
}

function card({ name, description }) {
    const file = name.toLowerCase().replace(/[^a-z0-9]/g, "-"); // as docs/make_pages.py
    const picture = carry(`Resources/Pictures/${file}.png`, name);
    const sound = carry(`docs/manual/sounds/presets/${file}.ogg`, name);
    return `<li id="${file}">
<img src="${picture}" alt="" width="192" height="128" loading="lazy">
<h2>${escape(name)}</h2>
<p>${escape(description)}</p>
${player(sound, name)}
<a class="button" href="index.html?preset=${encodeURIComponent(name)}">Play it yourself<span class="unseen">: ${escape(name)}</span></a>
</li>
`;
}

function writeGallery() {
    const presets = readdirSync(join(sources, "Presets")).sort()
        .map(file => JSON.parse(readFileSync(join(sources, "Presets", file), "utf8")));
    const body = `<h1>Gallery</h1>
<p>All ${presets.length} factory presets, with a short sound of each. <em>Play it yourself</em> opens one here in
the browser. The <a href="${placeOf("docs/manual/presets.md")}">manual</a> lists their keys.</p>
<ul class="gallery">
${presets.map(card).join("")}</ul>
`;
    write("gallery.html", layOut({ place: "gallery.html", title: "Gallery of presets – Idiophone", body }));
}

try {
    writeGallery();
    console.log(`The manual has ${writeManual()} pages.`);
} catch (error) {
    console.error(error.message);
    process.exit(1);
}
