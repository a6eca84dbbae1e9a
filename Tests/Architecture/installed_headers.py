#!/usr/bin/env python3
"""Checks that the package's headers include and mention only headers and names of the package.

Checks each word in a comment that looks like a type, function or header (aWord, AWord,
Module/Header.h). It must occur in the code of an installed header, or be the name of one. Some types
of other headers have an ordinary word as their name (Player). They are checked in backticks, or
capitalised within a sentence.

    installed_headers.py SOURCE_FOLDER MODULE/HEADER ...      without .h
"""
import pathlib
import re
import sys

COMMENT = re.compile(r"//.*")
INCLUDE = re.compile(r'#include "([^"]+)"')
NAME = re.compile(r"\b\w+/\w+\.h\b|\b(?!\d)\w*[a-z]\w*[A-Z]\w*", re.ASCII)
TYPE = re.compile(r"\b(?:class|struct|enum(?:\s+class)?)\s+(\w+)[^;{]*\{", re.ASCII)
AMID = re.compile(r"(?:[a-z,;(] |`|::)([A-Z]\w*)", re.ASCII)
ORDINARY = {"dB", "glTF", "kHz", "KiB", "MiB", "NaN", "macOS"}


def faults_of(headers, others=()):
    """Yields faults. `headers`: text by name; `others`: the texts of headers not installed."""
    code = "\n".join(COMMENT.sub("", text) for text in headers.values())
    known = (ORDINARY | set(re.findall(r"\w+", re.sub(r"\b(class|struct) \w+;", "", code)))
             | {pathlib.Path(name).stem for name in headers} | set(headers))
    lacking = set(TYPE.findall("\n".join(COMMENT.sub("", text) for text in others))) - known
    for name, text in headers.items():
        for number, line in enumerate(text.splitlines(), 1):
            if (include := INCLUDE.match(line)) and include[1] not in headers:
                yield f"{name}:{number}: {include[1]} is not installed"
            for comment in COMMENT.findall(line):
                words = (set(NAME.findall(comment)) - known) | (set(AMID.findall(comment)) & lacking)
                yield from (f"{name}:{number}: {word} is in no installed header"
                            for word in sorted(words))


def self_test():
    """Returns planted faults that are missed, and valid text that is reported."""
    sound = "#include \"A/Thing.h\"\n// Of aThing, see A/Thing.h, at 48 kHz.\nclass Hidden;\nint aThing;\n"
    sound += "// Player, like Poisson's. Players see a player.\n"
    others = ["class Base;\nclass Player final : public Base {\n// struct Poisson {\n", "enum class Pan { left };"]
    found = list(faults_of({"A/Thing.h": sound}, others))
    missed = [planted for planted in ('#include "A/Other.h"', "// A/Other.h", "// See otherThing.",
                                      "/// `OtherThing::name`.", "int a; ///< see HiddenThing",
                                      "// A Hidden one, HiddenThing;\nclass HiddenThing;", "// see Player.",
                                      "// `Player`", "/// Of the Pan.", "// `aThing::Pan`")
              if not list(faults_of({"A/Thing.h": sound + planted}, others))]
    return [f"not found: {planted}" for planted in missed] + [f"found: {fault}" for fault in found]


if __name__ == "__main__":
    source = pathlib.Path(sys.argv[1])
    names = [f"{header}.h" for header in sys.argv[2:]]
    faults = self_test()
    texts = {file.relative_to(source).as_posix(): file.read_text(encoding="utf-8")
             for file in source.rglob("*.h")}
    faults += faults_of({name: texts[name] for name in names},
                        [text for name, text in texts.items() if name not in names])
    if not names:
        faults.append("no header is installed")
    print("\n".join(faults) or f"{len(names)} headers speak of each other only")
    sys.exit(1 if faults else 0)
