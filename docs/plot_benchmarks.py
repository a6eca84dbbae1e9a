#!/usr/bin/env python3
"""Figures and tables of docs/benchmarks.md from what `idiophone-bench` measured.

    idiophone-bench --song Resources/Songs/TheEntertainer.mid --json -o build/bench.json
    python3 docs/plot_benchmarks.py build/bench.json [MACHINE]

Needs matplotlib. Draws docs/images/benchmarks/*.svg and replaces the tables between the markers of
docs/benchmarks.md; MACHINE ("AMD EPYC, 2 cores") is said beside them.
"""
import json
import pathlib
import re
import sys

import matplotlib

matplotlib.use("svg")
# The same figures give the same files.
matplotlib.rcParams.update({"svg.hashsalt": "idiophone", "font.size": 9, "axes.grid": True,
                            "grid.alpha": 0.3, "axes.spines.top": False,
                            "axes.spines.right": False, "figure.figsize": (7, 3.6)})
import matplotlib.pyplot as plt

DOCS = pathlib.Path(__file__).resolve().parent
IMAGES = DOCS / "images" / "benchmarks"


def save(figure, name):
    figure.tight_layout()
    figure.savefig(IMAGES / f"{name}.svg", metadata={"Date": None})
    plt.close(figure)


def digits(value, count=3):
    if value == 0 or abs(value) >= 1e6:
        return f"{value:.{count}g}"
    whole = len(str(int(abs(value)))) if abs(value) >= 1 else 0
    return f"{value:.{max(count - whole, 0)}f}" if whole else f"{value:.{count}g}"


def table(header, rows):
    lines = ["| " + " | ".join(map(str, row)) + " |" for row in [header, *rows]]
    return "\n".join([lines[0], "|" + "---|" * len(header), *lines[1:]])


def kernel(figures):
    sizes = figures["sizes"]
    figure, axes = plt.subplots()
    places = range(len(sizes))
    axes.bar([p - 0.2 for p in places], [100 * s["share_of_peak"] for s in sizes], 0.4,
             label="modal bank")
    axes.bar([p + 0.2 for p in places], [100 * s["naive_share_of_peak"] for s in sizes], 0.4,
             label="the paper's loop")
    axes.set_xticks(list(places), [s["modes"] for s in sizes])
    axes.set_xlabel("modes")
    axes.set_ylabel("% of the FMA peak")
    axes.set_ylim(0, 100)
    axes.legend()
    save(figure, "kernel")
    rows = [(s["modes"], f"{100 * s['share_of_peak']:.1f} %",
             f"{100 * s['naive_share_of_peak']:.1f} %", f"{s['times_naive']:.1f}",
             f"{s['modes_in_real_time']:,.0f}") for s in sizes]
    errors = ", ".join(f"{error:.1f} dB at {modes} modes"
                       for modes, error in figures["error_after_10_s_db"].items())
    eq12 = figures["eq12"]
    return (table(("modes", "share of peak", "the paper's loop", "times faster",
                   "modes in real time"), rows) +
            f"\n\nPeak: {figures['peak_fma_per_second'] / 1e9:.1f} × 10⁹ multiply-adds a second. "
            f"Error after 10 s: {errors}. Eq. 12 at N = 5000 needs "
            f"{eq12['flop_per_second_of_sound'] / 1e6:.0f} MFLOP per second of sound. That is "
            f"{100 * eq12['share_of_core']:.1f} % of a core at the rate of 10000 modes.")


def callback(figures):
    figure, axes = plt.subplots()
    for scene in figures["scenes"]:
        axes.plot([1e6 * s for s in scene["seconds"]], label=scene["name"])
    axes.set_xlabel("callback of 64 samples (16 strikes in number 48)")
    axes.set_ylabel("µs")
    axes.set_ylim(0)
    axes.legend()
    save(figure, "callback")
    rows = [(s["name"], f"{1e6 * s['struck_s']:.1f}", f"{1e6 * s['worst_s']:.1f}",
             f"{1e6 * s['mean_s']:.1f}", f"{s['worst_over_mean']:.2f}")
            for s in figures["scenes"]]
    return (table(("scene", "16 strikes, µs", "worst, µs", "mean, µs", "worst / mean"), rows) +
            f"\n\nA callback with every mode below τ costs "
            f"{100 * figures['silence_over_sound']:.2f} % of a ringing one.")


def plugin(figures):
    keys = ("mean_s", "at_notes_s", "at_ten_keys_s", "at_another_material_s",
            "at_automated_material_s", "at_another_preset_s")
    rows = [(p["name"], *(f"{1e6 * p[key]:.1f}" for key in keys), p["worst_event"],
             f"{100 * p['worst_share']:.1f}") for p in figures["presets"]]
    return table(("preset", "mean, µs", "worst: notes", "ten keys", "another material",
                  "automated material", "another preset", "worst of all", "of its time, %"), rows)


def force(figures):
    rows = [(s["modes"], f"{1e6 * s['free_s']:.2f}", f"{1e6 * s['staying_s']:.2f}",
             f"{1e6 * s['moving_s']:.2f}", f"{s['staying_over_free']:.2f}",
             f"{s['moving_over_free']:.2f}") for s in figures["sizes"]]
    sources = [(s["name"], f"{1e6 * s['seconds']:.2f}", f"{s['over_free_500']:.2f}")
               for s in figures["generators"]]
    return (table(("modes", "free, µs a cell", "contact stays, µs", "contact moves, µs",
                   "stays / free", "moves / free"), rows) + "\n\n" +
            table(("making the force of a", "µs a cell", "of a free cell of 500 modes"), sources))


def memory(figures):
    rows = [(m["vertices"], m["modes"], m["groups"], m["windows"], f"{m['before_million']:.3g}",
             f"{m['after_million']:.3g}", f"{m['dense_million']:.3g}")
            for m in figures["meshes"]]
    return table(("vertices V", "modes to 22 kHz", "groups", "groups without asking for beats",
                  "before (3V × 3V), millions", "after (3V × groups)",
                  "dense spectrum (3V × 962)"), rows)


def tau(figures):
    figure, axes = plt.subplots()
    for run in figures["runs"]:
        seconds = [k * figures["cell_s"] for k in range(len(run["modes"]))]
        line, = axes.step(seconds, run["modes"], where="post", label=f"τ = {run['tau']:g}")
        axes.axvline(run["eq14_s"], color=line.get_color(), linestyle=":")
    axes.set_xlim(0, 1.1 * max(run["eq14_s"] for run in figures["runs"]))
    axes.set_xlabel("s (dotted: the last cutoff by eq. 14)")
    axes.set_ylabel("modes mixed")
    axes.legend()
    save(figure, "tau")
    rows = [(f"{r['tau']:g}", f"{r['mode_seconds']:.3f}", f"{r['last_s']:.4f}",
             f"{r['eq14_s']:.4f}") for r in figures["runs"]]
    return (table(("τ", "mode-seconds", "last mode, s", "by eq. 14, s"), rows) +
            f"\n\nThe output peaks at {figures['peak_steps']:.0f} of 65536 steps. τ = 2 saves "
            f"{100 * figures['saved']:.0f} % of the mode-seconds.")


def rings(figures, rendered):
    """The paper's Figure 8, with the frames of `rendered` if the same run has them."""
    figure, axes = plt.subplots(figsize=(7, 4.6))
    for curve in figures["curves"]:
        axes.semilogy(*over_time(curve, 0.01), label=curve["name"])
    for curve, style in zip(rendered["curves"] if rendered else (), (":", "--")):
        axes.semilogy(*over_time(curve, curve["frame_seconds"]), "k" + style, linewidth=1,
                      label=f"motion and sound of the falling rings, {curve['name']}")
    axes.axhline(100, color="gray", linewidth=0.8)
    axes.text(0.01, 103, "real time", color="gray", fontsize=7, va="bottom")
    axes.set_xlim(0, 0.01 * len(figures["curves"][0]["frames_per_second"]))
    axes.set_xlabel("s (strikes within the first second)")
    axes.set_ylabel("audio frames of 1/100 s a second")
    axes.legend(fontsize=7, ncols=2, loc="lower center", bbox_to_anchor=(0.5, 1))
    save(figure, "rings")
    rows = [(c["name"], f"{c['mean_frames_per_second']:.0f}",
             "" if k == 0 else f"{c['factor']:.2f}") for k, c in enumerate(figures["curves"])]
    return (table(("row", "frames a second", "times the row above"), rows) +
            f"\n\n{figures['modes_3n']} modes by eq. 12 (3N), {figures['modes_audible']} audible; "
            f"τ = {figures['tau']:g}; the mix peaks at {figures['peak_steps']:.0f} steps. "
            f"Fixed quality: a budget of {figures['mode_budget']:.0f} modes "
            f"({figures['worst_error_db']:.1f} dB for the worst of the ten loudest objects). "
            f"All factors together: {figures['every_mode_over_everything']:.0f} times the paper's "
            f"loop with 3N modes, {figures['naive_over_everything']:.0f} times its loop with the "
            f"audible ones. Rate in the slowest tenth of a second over the mean, while strikes "
            f"occur: {figures['slowest_tenth_over_mean']:.2f}.")


def over_time(curve, frame_seconds):
    rates = curve["frames_per_second"]
    return [frame_seconds * (k + 0.5) for k in range(len(rates))], rates


def render(figures):
    rows = [(c["name"], digits(c["mean_frames_per_second"]),
             digits(100 / c["mean_frames_per_second"])) for c in figures["curves"]]
    return (table(("threads", "audio frames a second", "of real time"), rows) +
            f"\n\nTwo cores over one: {figures['two_cores_over_one']:.2f}. Of "
            f"{figures['samples']:,} samples, {figures['differing_samples']} differ.")


def scale(figures):
    crowds = figures["crowds"]
    bodies = [crowd["bodies"] for crowd in crowds]
    budget = figures["mode_budget"]
    figure, (modes, cost) = plt.subplots(1, 2)
    for key, name in (("unscaled", "no budget"), ("scaled", f"budget {budget:.0f}")):
        modes.loglog(bodies, [c[key]["modes_mixed_mean"] for c in crowds], "o-", label=name)
        cost.loglog(bodies, [1e6 * c[key]["frame_seconds_mean"] for c in crowds], "o-",
                    label=name)
    modes.set_ylabel("modes mixed")
    cost.set_ylabel("µs a frame of 10 ms")
    for axes in modes, cost:
        axes.set_xlabel("sounding bodies")
        axes.legend(fontsize=7)
    save(figure, "scale")
    rows = [(c["bodies"], f"{c['unscaled']['modes_mixed_mean']:.0f}",
             f"{c['scaled']['modes_mixed_mean']:.0f}", c["scaled"]["modes_mixed_most"],
             digits(1e6 * c["unscaled"]["frame_seconds_mean"]),
             digits(1e6 * c["scaled"]["frame_seconds_mean"]),
             digits(1e6 * c["scaled"]["frame_seconds_worst"]),
             "" if c["heap_bytes"] is None else digits(c["heap_bytes"] / 1e6))
            for c in crowds]
    return table(("bodies", "modes mixed", f"with a budget of {budget:.0f}", "at most",
                  "µs a frame", "with the budget", "at worst", "memory, MB"), rows)


def scenes(figures):
    return table(("scene", "s", "bodies, of real time", "in the slowest tenth of a second",
                  "impacts"),
                 [(s["name"], digits(s["seconds"]), digits(s["motion_over_real_time"]),
                   digits(s["slowest_tenth_over_real_time"]), s["impacts"])
                  for s in figures["scenes"]])


def analysis(figures):
    return table(("body", "triangles", "modes", "one thread, s", "two threads, s", "one over two",
                  "processor time of two over one", "figures that differ"),
                 [(b["name"], f"{b['triangles']:,}", b["modes"],
                   digits(b["one_thread_wall_s"]), digits(b["two_threads_wall_s"]),
                   f"{b['one_over_two']:.2f}", f"{b['processor_two_over_one']:.2f}",
                   b["differing_figures"]) for b in figures["bodies"]])


def xylophone(figures):
    return table(("strikes", "s", "share of one core", "dearest cell / its length", "modes mixed",
                  "at most"),
                 [(figures["strikes"], f"{figures['seconds']:.0f}",
                   f"{100 * figures['share_of_core']:.3f} %",
                   f"{100 * figures['dearest_cell_share']:.1f} %",
                   f"{figures['modes_mixed_mean']:.0f}", figures["modes_mixed_most"])])


def compression(figures):
    figure, axes = plt.subplots()
    axes.loglog(*zip(*figures["discrimination_curve"]))
    axes.set_xlabel("Hz")
    axes.set_ylabel("just noticeable difference, Hz")
    save(figure, "discrimination")
    figure, axes = plt.subplots()
    objects = figures["objects"]
    places = range(len(objects))
    axes.bar(places, [o["modes"] for o in objects], label="modes")
    axes.bar(places, [o["groups"] for o in objects], label="groups")
    axes.set_xticks(list(places), [o["name"].replace("xylophone-", "") for o in objects],
                    rotation=90, fontsize=6)
    axes.set_xlabel("factory object (numbers: xylophone bars)")
    axes.legend()
    save(figure, "compression")
    return table(("object", "modes", "groups", "level error, mean dB", "at most, dB"),
                 [(o["name"], o["modes"], o["groups"], digits(o["mean_error_db"], 2),
                   digits(o["largest_error_db"], 2)) for o in objects])


def goals(document):
    return table(("goal", "measured", "bound", "met"),
                 [(g["name"], digits(g["measured"]), f"{g['relation']} {digits(g['bound'])}",
                   "yes" if g["met"] else "**no**") for g in document["goals"]])


def replace_between_markers(text, name, content):
    pattern = re.compile(rf"(<!-- {name} -->\n).*?(<!-- /{name} -->)", re.DOTALL)
    if not pattern.search(text):
        sys.exit(f"the page has no place for '{name}'")
    return pattern.sub(lambda found: f"{found[1]}{content}\n{found[2]}", text)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    document = json.loads(pathlib.Path(sys.argv[1]).read_text())
    IMAGES.mkdir(parents=True, exist_ok=True)
    page = DOCS / "benchmarks.md"
    text = page.read_text()
    build = document["build"]
    machine = f"{sys.argv[2]}, " if len(sys.argv) == 3 else ""
    text = replace_between_markers(
        text, "machine", f"Measured on: {machine}SIMD target {build['simd_target']}, compiler "
                         f"{build['compiler']}.")
    text = replace_between_markers(text, "goals", goals(document))
    measured = document["benchmarks"]
    for draw in (kernel, callback, plugin, force, memory, tau, rings, scale, scenes, render,
                 analysis, xylophone, compression):
        if draw.__name__ in measured:
            more = (measured.get("render"),) if draw is rings else ()
            text = replace_between_markers(text, draw.__name__,
                                           draw(measured[draw.__name__], *more))
    page.write_text(text)


if __name__ == "__main__":
    main()
