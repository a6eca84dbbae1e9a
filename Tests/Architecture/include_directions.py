#!/usr/bin/env python3
"""Checks that modules of Source include only modules below them and the libraries they may use.

MODULES is the whole rule (docs/ARCHITECTURE.md gives the reasons). For each module it lists the other
modules and the third-party headers that the module may include. Every module may include the
standard library. Unused entries are allowed; includes without an entry fail.

The editor shows the processor through its own interface (Editor/ProcessorView.h), which the
processor implements. So Plugin includes Editor, and Editor never includes Plugin.

    include_directions.py SOURCE_FOLDER     checks the folder
    include_directions.py --self-test       checks that planted violations are found
"""
import pathlib
import re
import sys
import tempfile

MODULES = {
    # module: (modules it may include, third-party headers it may include, by prefix)
    "Object": ("", "nlohmann/ tl/"),
    "Parameters": ("", ""),
    "Python": ("Analysis World Synth Geometry Gltf Mesh Object", "Eigen/ nanobind/"),
    "AudioFiles": ("Object", "sndfile.h"),
    "Mesh": ("Object", "Eigen/ igl/"),
    "Gltf": ("Mesh Object", "Eigen/ nlohmann/ tiny_gltf.h"),
    "Geometry": ("Gltf Mesh Object", "Eigen/ igl/ CGAL/"),
    "Synth": ("Object", "hwy/"),
    "World": ("Synth Mesh Object", "Eigen/ boost/lockfree/"),
    "C": ("World Synth Gltf Mesh Object", "Eigen/"),
    "Web": ("C World Synth Mesh Object", ""),
    "Browser": ("Output Scene Instrument World Synth Gltf Mesh Parameters Object", "nlohmann/"),
    "Analysis": ("Geometry Mesh Object", "Eigen/ unsupported/Eigen/ igl/ tetgen.h"),
    "Instrument": ("World Synth Gltf Mesh Object Parameters", "Eigen/ nlohmann/ Tunings.h"),
    "Scene": ("Instrument World Synth Geometry Gltf Mesh Object Parameters",
              "Eigen/ boost/lockfree/ BulletCollision/ LinearMath/ btBulletDynamicsCommon.h nlohmann/"),
    "Output": ("Object Parameters", "Eigen/"),
    "Sampling": ("AudioFiles Output Instrument World Synth Geometry Mesh Parameters Object",
                 "juce_audio_basics/ nlohmann/ ebur128.h"),
    "Editor": ("Parameters Object Geometry Mesh", "Eigen/ juce_ GL/ X11/"),
    "Plugin": ("Editor Sampling Output Scene Instrument Analysis World Synth Geometry Gltf Mesh Parameters AudioFiles Object",
               "boost/lockfree/ clap/ clap-juce-extensions/ juce_ nlohmann/ libMTSClient.h pluginterfaces/"),
    "Console": ("Sampling Output Scene Instrument Analysis World Synth Geometry Gltf Mesh Parameters AudioFiles Object",
                "juce_ CLI/ nlohmann/ mysofa.h windows.h"),
}

HEADER_ENDINGS = {".h", ".hpp"}
SOURCE_ENDINGS = HEADER_ENDINGS | {".cpp", ".cc", ".mm"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:<([^>]+)>|"([^"]+)"|(\S+))', re.MULTILINE)
COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
# Headers without folder and extension (<vector>, <cmath>) and those of C and operating systems.
STANDARD = re.compile(r"^[a-z_0-9]+$|^(immintrin|unistd|fcntl|malloc|signal|io|share|stddef|stdint|sys/\w+)\.h$")


def words(text):
    return text.split()


def without_comments(text):
    """Returns `text` with its comments blanked and its lines unchanged in length."""
    return COMMENT_OR_TEXT.sub(
        lambda found: found.group() if found.group().startswith('"')
        else re.sub(r"[^\n]", " ", found.group()), text)


def may_include_library(module, header):
    return any(header.startswith(prefix) for prefix in words(MODULES[module][1]))


def fault_of_include(module, header, is_angled, source):
    """Returns why `module` may not include `header`, or None."""
    folder = header.split("/")[0]
    if folder in MODULES and "/" in header:
        if folder != module and folder not in words(MODULES[module][0]):
            return f"module {module} may not include module {folder}"
        if not (source / header).is_file():
            return "no such header"
        return None
    if is_angled and (STANDARD.match(header) or may_include_library(module, header)):
        return None
    if is_angled:
        return f"module {module} may not include this library"
    return "headers of ours are included as \"Module/Name.h\""


def faults_of_file(file, module, source):
    text = file.read_text(encoding="utf-8")
    name = file.relative_to(source.parent)
    code = without_comments(text)
    for match in INCLUDE.finditer(code):
        line = code.count("\n", 0, match.start()) + 1
        angled, quoted, computed = match.groups()
        fault = ("includes a macro, which this test cannot follow" if computed
                 else fault_of_include(module, angled or quoted, angled is not None, source))
        if fault:
            yield f"{name}:{line}: {match.group().strip()}: {fault}"
    if file.suffix in HEADER_ENDINGS:
        if not re.sub(r"\A// SPDX.*\n", "", text).startswith(("//", "/*")):
            yield f"{name}:1: a header opens with a comment that says what it is for"
        # Highway's -inl.h files are included once for each instruction set.
        guard = "HWY_TARGET_TOGGLE" if file.name.endswith("-inl.h") else r"^#pragma once$"
        if not re.search(guard, code, re.MULTILINE):
            yield f"{name}:1: a header needs #pragma once"


def cycle_in(graph):
    """Returns a cycle in `graph` (node -> nodes) as a list of nodes, or None."""
    finished, walk = set(), []

    def visit(node):
        if node in walk:
            return walk[walk.index(node):] + [node]
        if node in finished:
            return None
        walk.append(node)
        for following in sorted(graph.get(node, ())):
            if found := visit(following):
                return found
        walk.pop()
        finished.add(node)
        return None

    return next(filter(None, map(visit, sorted(graph))), None)


def headers_graph(source):
    """Returns for each header of ours the headers of ours that it includes."""
    graph = {}
    for file in source.rglob("*.h"):
        code = without_comments(file.read_text(encoding="utf-8"))
        found = {angled or quoted for angled, quoted, _ in INCLUDE.findall(code)}
        graph[file.relative_to(source).as_posix()] = {
            header for header in found if (source / header).is_file()}
    return graph


def faults_of_table():
    for module, (below, _) in MODULES.items():
        yield from (f"module {module} names module {other}, which does not exist"
                    for other in words(below) if other not in MODULES)
    if cycle := cycle_in({module: words(below) for module, (below, _) in MODULES.items()}):
        yield "the table of modules goes round: " + " -> ".join(cycle)


def faults_of(source):
    faults, files = list(faults_of_table()), 0
    for file in sorted(source.rglob("*")):
        if not file.is_file() or file.suffix not in SOURCE_ENDINGS:
            continue
        files += 1
        module = file.relative_to(source).parts[0]
        if module in MODULES:
            faults += faults_of_file(file, module, source)
        else:
            faults.append(f"{file.relative_to(source.parent)}: {module} is no module of the table")
    if files == 0:
        faults.append(f"{source}: no source file found")
    if cycle := cycle_in(headers_graph(source)):
        faults.append("headers include each other in a circle: " + " -> ".join(cycle))
    return files, faults


# A valid source folder of two files, and the fault that each change to it must cause.
SOUND = {
    "Object/Thing.h": "// A thing.\n#pragma once\n#include <vector>\n",
    "Synth/Bank.cpp": '#include "Object/Thing.h"\n#include <hwy/highway.h>\n',
}
PLANTED = {
    "an upward include": ("Object/Up.cpp", '#include "Synth/Bank.cpp"\n', "may not include module"),
    "an upward include with odd spaces": ("Object/Up.cpp", '  #  include  "Synth/Bank.cpp"\n',
                                          "may not include module"),
    "an upward include in angle brackets": ("Object/Up.cpp", "#include <Synth/Bank.cpp>\n",
                                            "may not include module"),
    "Synth knowing Analysis": ("Synth/Up.cpp", '#include "Analysis/Solve.h"\n',
                               "may not include module"),
    "the editor knowing the plugin": ("Editor/Up.cpp", '#include "Plugin/Processor.h"\n',
                                      "may not include module"),
    "JUCE in Synth": ("Synth/Juce.cpp", "#include <juce_core/juce_core.h>\n", "this library"),
    "Eigen in Synth": ("Synth/E.cpp", "#include <Eigen/Core>\n", "this library"),
    "an unlisted library": ("Object/Boost.cpp", "#include <boost/any.hpp>\n", "this library"),
    "JUCE in Output": ("Output/J.cpp", "#include <juce_gui_basics/juce_gui_basics.h>\n",
                                          "this library"),
    "a path round the modules": ("Synth/Dots.cpp", '#include "../Object/Thing.h"\n', "Module/Name.h"),
    "a header that is not there": ("Synth/No.cpp", '#include "Object/Nothing.h"\n',
                                   "no such header"),
    "an include hidden in a macro": ("Synth/Macro.cpp", "#include HEADER\n", "macro"),
    "an unknown module": ("Attic/Box.cpp", "int box;\n", "no module of the table"),
    "a file outside any module": ("Loose.cpp", "int loose;\n", "no module of the table"),
    "a header without #pragma once": ("Object/Twice.h", "// Twice.\n", "#pragma once"),
    "an -inl.h that is not read for each target": ("Synth/Twice-inl.h", "// Twice.\n",
                                                   "#pragma once"),
    "a header without an opening comment": ("Object/Mute.h", "// SPDX-x\n#pragma once\n",
                                            "opens with a comment"),
    "an upward include after text that looks like a comment": (
        "Object/T.cpp", 'auto all = "/*";\n#include "Synth/Bank.cpp"\nauto end = "*/";\n',
        "may not include module"),
    "headers in a circle": ("Object/Self.h", '// Round.\n#pragma once\n#include "Object/Self.h"\n',
                            "circle"),
}


def house(folder, files):
    for name, text in files.items():
        path = folder / "Source" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder / "Source"


def self_test():
    missed = []
    with tempfile.TemporaryDirectory() as temporary:
        root = pathlib.Path(temporary)
        _, faults = faults_of(house(root / "sound", SOUND))
        missed += [f"found in a sound house: {fault}" for fault in faults]
        comments = '// #include "Synth/Bank.cpp"\n/*\n#include <juce>\n*/\n'
        commented = SOUND | {"Object/Comments.cpp": comments}
        _, faults = faults_of(house(root / "commented", commented))
        missed += [f"found in a comment: {fault}" for fault in faults]
        for number, (violation, (name, text, expected)) in enumerate(PLANTED.items()):
            _, faults = faults_of(house(root / str(number), SOUND | {name: text}))
            if not any(expected in fault and name.split("/")[-1] in fault for fault in faults):
                missed.append(f"not found: {violation}; found only {faults}")
        _, faults = faults_of(house(root / "empty", {}))
        if not faults:
            missed.append("not found: an empty Source folder")
        if cycle_in({"a": ["b"], "b": ["c"], "c": ["a"]}) != ["a", "b", "c", "a"]:
            missed.append("not found: a table that goes round")
    return len(PLANTED) + 4, missed


def main(argument):
    if argument == "--self-test":
        count, faults = self_test()
        done = f"{count} planted cases judged rightly"
    else:
        count, faults = faults_of(pathlib.Path(argument).resolve())
        done = f"{count} files keep the rules"
    print("\n".join(faults) if faults else done)
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1]))
