// The presets as a list with a search by name, tag and description.

const small = text => text.toLowerCase();

/** Whether each word is part of a preset's name, tags or description. */
function hasWords({ name, tags, description }, words) {
    const text = small([name, ...tags, description].join("\n"));
    return small(words)
        .split(/\s+/)
        .every(word => text.includes(word));
}

export class PresetList {
    #parts;
    #presets;
    #options;
    #load;
    #playing = -1;

    /**
     * `parts`: elements `section`, `list`, `search`, `none`, `name`, `previous`, `next`. `load(name)` is
     * called for a chosen preset.
     */
    constructor(parts, presets, load) {
        this.#parts = parts;
        this.#presets = presets;
        this.#load = load;
        this.#options = presets.map((preset, index) => this.#option(preset, index));
        parts.list.replaceChildren(...this.#options);
        parts.list.addEventListener("keydown", event => this.#keyDown(event));
        parts.search.addEventListener("input", () => this.#filter());
        parts.search.addEventListener("keydown", event => this.#leaveSearch(event));
        parts.name.addEventListener("click", () =>
            this.#setOpen(!parts.section.classList.contains("open")),
        );
        parts.section.addEventListener("keydown", event => {
            if (event.key === "Escape") this.#close();
        });
        parts.previous.addEventListener("click", () => this.#choose(this.#playing - 1));
        parts.next.addEventListener("click", () => this.#choose(this.#playing + 1));
        this.#focus(0, false);
    }

    /** Marks the preset of that name as the one that plays. */
    show(name) {
        this.#parts.name.textContent = name;
        this.#playing = this.#presets.findIndex(preset => preset.name === name);
        this.#options.forEach((option, index) =>
            option.setAttribute("aria-selected", String(index === this.#playing)),
        );
        if (this.#playing < 0) return;
        this.#focus(this.#playing, false);
        this.#options[this.#playing].scrollIntoView({ block: "nearest" });
    }

    #option(preset, index) {
        const option = document.createElement("div");
        option.id = `preset-${index}`;
        option.setAttribute("role", "option");
        option.setAttribute("aria-selected", "false");
        option.title = preset.description;
        const name = document.createElement("span");
        name.className = "preset-title";
        name.textContent = preset.name;
        const tags = document.createElement("span");
        tags.className = "tags";
        tags.textContent = preset.tags.join(", ");
        option.append(name, tags);
        option.addEventListener("click", () => {
            this.#choose(index);
            this.#close();
        });
        return option;
    }

    #choose(index) {
        const count = this.#presets.length;
        this.#load(this.#presets[(index + count) % count].name);
    }

    #visible() {
        return this.#options.filter(option => !option.hidden);
    }

    #focus(index, takesFocus) {
        this.#options.forEach((option, i) => (option.tabIndex = i === index ? 0 : -1));
        if (takesFocus) this.#options[index].focus();
    }

    #keyDown(event) {
        const visible = this.#visible();
        const at = visible.indexOf(event.target);
        const steps = { ArrowUp: at - 1, ArrowDown: at + 1, Home: 0, End: visible.length - 1 };
        const index = this.#options.indexOf(event.target);
        if (event.key in steps) {
            const to = visible[Math.min(Math.max(steps[event.key], 0), visible.length - 1)];
            this.#focus(this.#options.indexOf(to), true);
        } else if (event.key === "Enter" || event.key === " ") this.#choose(index);
        else return;
        event.preventDefault();
    }

    #filter() {
        const words = this.#parts.search.value.trim();
        this.#presets.forEach((preset, i) => (this.#options[i].hidden = !hasWords(preset, words)));
        const visible = this.#visible();
        this.#parts.none.hidden = visible.length > 0;
        if (visible.length > 0) this.#focus(this.#options.indexOf(visible[0]), false);
    }

    #leaveSearch(event) {
        const [first] = this.#visible();
        if (!first || (event.key !== "ArrowDown" && event.key !== "Enter")) return;
        event.preventDefault();
        this.#focus(this.#options.indexOf(first), true);
        if (event.key === "Enter") this.#choose(this.#options.indexOf(first));
    }

    #setOpen(isOpen) {
        this.#parts.section.classList.toggle("open", isOpen);
        this.#parts.name.setAttribute("aria-expanded", String(isOpen));
        if (isOpen) this.#parts.search.focus();
    }

    #close() {
        if (!this.#parts.section.classList.contains("open")) return;
        this.#setOpen(false);
        this.#parts.name.focus();
    }
}
