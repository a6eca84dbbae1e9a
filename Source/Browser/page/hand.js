// Pointers on the picture: a press on an object strikes it, dragging on strikes each new object or
// scrapes, and dragging the background turns the camera. Two fingers on the background zoom.

const fastestPixelsPerSecond = 3000;
const [softest, middle, hardest] = [50, 84, 127]; // velocities
const restSeconds = 0.06; // after which a pointer has stood still
const scrapePressure = 0.7; // as of the plugin for a mouse
const radiansPerHeight = 3;

/** Speeds of a pointer just before a press. */
class PointerSpeed {
    #last = null;

    /** Takes a move and returns its speed in pixels a second. */
    follow(event) {
        const seconds = this.#last ? (event.timeStamp - this.#last.time) / 1000 : 0;
        const distance = this.#last
            ? Math.hypot(event.clientX - this.#last.x, event.clientY - this.#last.y)
            : 0;
        const speed = seconds > 0 ? distance / seconds : (this.#last?.speed ?? 0);
        this.#last = { x: event.clientX, y: event.clientY, time: event.timeStamp, speed };
        return speed;
    }

    /** The speed at a press; 0 if the pointer stood still. */
    at(event) {
        if (!this.#last || event.timeStamp - this.#last.time > 1000 * restSeconds) return 0;
        return this.#last.speed;
    }
}

const velocityOfSpeed = speed =>
    Math.round(softest + (hardest - softest) * Math.min(speed / fastestPixelsPerSecond, 1));

/** Browsers without a sensor report a pressure of 0, 0.5 or 1. */
function velocityOfPress(event, speed) {
    if (event.pointerType === "mouse") return velocityOfSpeed(speed);
    const hasSensor = ![0, 0.5, 1].includes(event.pressure);
    return hasSensor ? Math.round(softest + (hardest - softest) * event.pressure) : middle;
}

export class Hand {
    #canvas;
    #picture;
    #stage;
    #idiophone;
    #performer;
    #scrapes;
    #speed = new PointerSpeed();
    #struck = new Map(); // pointer to its last pick on an object
    #turning = new Map(); // pointer to its last place

    /** `scrapes(event)`: whether a drag scrapes. */
    constructor({ canvas, picture, stage, idiophone, performer, scrapes }) {
        this.#canvas = canvas;
        this.#picture = picture;
        this.#stage = stage;
        this.#idiophone = idiophone;
        this.#performer = performer;
        this.#scrapes = scrapes;
        canvas.addEventListener("pointerdown", event => this.#press(event));
        canvas.addEventListener("pointermove", event => this.#move(event));
        for (const end of ["pointerup", "pointercancel"])
            canvas.addEventListener(end, event => this.#lift(event));
        canvas.addEventListener("wheel", event => this.#zoom(event), { passive: false });
        canvas.addEventListener("keydown", event => this.#turnByKey(event));
        canvas.addEventListener("contextmenu", event => event.preventDefault());
    }

    /** Forgets what is held, before another instrument. */
    release() {
        for (const pick of this.#struck.values()) this.#end(pick);
        this.#struck.clear();
    }

    resetView() {
        this.#stage.orbit.reset();
        this.#stage.requestFrame();
    }

    #press(event) {
        if (event.button !== 0) return;
        this.#canvas.setPointerCapture(event.pointerId);
        const pick = this.#picture.pick(event.clientX, event.clientY);
        if (!pick) {
            this.#turning.set(event.pointerId, { x: event.clientX, y: event.clientY });
            return;
        }
        this.#strike(event.pointerId, pick, velocityOfPress(event, this.#speed.at(event)));
    }

    #strike(pointer, pick, velocity) {
        pick.note = pick.isStage ? this.#picture.noteOf(pick.object) : undefined;
        if (pick.note === undefined) {
            this.#idiophone.strike(pick.object, pick.point, velocity);
            this.#picture.showStrike(pick.object, velocity / 127, pick.place);
        } else this.#performer.noteOn(pick.note, velocity);
        this.#struck.set(pointer, pick);
    }

    #end(pick) {
        if (pick.isScraping) this.#idiophone.scrape(pick.object, pick.point, 0);
        if (pick.note === undefined) this.#idiophone.strike(pick.object, pick.point, 0);
        else this.#performer.noteOff(pick.note);
    }

    #move(event) {
        const speed = this.#speed.follow(event);
        const former = this.#struck.get(event.pointerId);
        if (former) this.#drag(event, former, speed);
        else if (this.#turning.has(event.pointerId)) this.#turn(event);
        else if (event.pointerType === "mouse")
            this.#canvas.style.cursor = this.#picture.pick(event.clientX, event.clientY)
                ? "pointer"
                : "grab";
    }

    #drag(event, former, speed) {
        if (former.note !== undefined) return; // a scene's bodies are thrown, not dragged over
        const pick = this.#picture.pick(event.clientX, event.clientY);
        if (!pick) return;
        if (pick.object !== former.object) {
            this.#end(former);
            this.#strike(event.pointerId, pick, velocityOfSpeed(speed));
            return;
        }
        pick.isScraping = former.isScraping || this.#scrapes(event);
        if (!pick.isScraping) return;
        if (!former.isScraping) this.#idiophone.scrape(former.object, former.point, scrapePressure);
        this.#idiophone.scrape(pick.object, pick.point, scrapePressure);
        this.#picture.showContact(pick.object, 0.4, pick.place);
        this.#struck.set(event.pointerId, pick);
    }

    #lift(event) {
        const pick = this.#struck.get(event.pointerId);
        if (pick) this.#end(pick);
        this.#struck.delete(event.pointerId);
        this.#turning.delete(event.pointerId);
    }

    /** One pointer turns; two turn by their middle and zoom by their distance. */
    #turn(event) {
        const before = this.#spread();
        this.#turning.set(event.pointerId, { x: event.clientX, y: event.clientY });
        const after = this.#spread();
        const scale = radiansPerHeight / this.#canvas.clientHeight;
        this.#stage.orbit.turnBy(-scale * (after.x - before.x), scale * (after.y - before.y));
        if (before.distance > 0) this.#stage.orbit.zoomBy(after.distance / before.distance);
        this.#stage.requestFrame();
    }

    #spread() {
        const places = [...this.#turning.values()];
        const mean = axis => places.reduce((sum, place) => sum + place[axis], 0) / places.length;
        const [first, second] = places;
        const distance = second ? Math.hypot(first.x - second.x, first.y - second.y) : 0;
        return { x: mean("x"), y: mean("y"), distance };
    }

    #zoom(event) {
        event.preventDefault();
        const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 30 * event.deltaY : event.deltaY;
        this.#stage.orbit.zoomBy(Math.exp(-0.0015 * pixels));
        this.#stage.requestFrame();
    }

    #turnByKey(event) {
        const turns = {
            ArrowLeft: [0.1, 0],
            ArrowRight: [-0.1, 0],
            ArrowUp: [0, 0.1],
            ArrowDown: [0, -0.1],
        };
        const { orbit } = this.#stage;
        if (turns[event.key]) orbit.turnBy(...turns[event.key]);
        else if (event.key === "+" || event.key === "=") orbit.zoomBy(1.15);
        else if (event.key === "-") orbit.zoomBy(1 / 1.15);
        else if (event.key === "Home") orbit.reset();
        else return;
        event.preventDefault();
        this.#stage.requestFrame();
    }
}
