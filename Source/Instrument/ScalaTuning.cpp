#include "Instrument/ScalaTuning.h"

#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <Tunings.h>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

constexpr double mostCents = 24000; // from one degree to the first, either way
constexpr double lowestHz = 1, highestHz = 100000;
constexpr double negligibleSemitones = 1e-9;

// Inside this file a fault travels as an exception and becomes a Result at keyTuning.
struct Fault {
    std::string sentence;
};

struct Line {
    std::string_view text;
    int number = 0; ///< from 1
};

/// The lines of a file that are no comments, whichever way they end.
class Lines {
public:
    explicit Lines(const ScalaFile& source) : file(source), rest(source.text) {}

    std::optional<Line> next() {
        while (!rest.empty()) {
            const auto end = rest.find_first_of("\r\n");
            const auto line = rest.substr(0, end);
            rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end);
            if (rest.starts_with("\r\n"))
                rest.remove_prefix(2);
            else if (!rest.empty())
                rest.remove_prefix(1);
            ++number;
            if (!line.starts_with('!'))
                return Line{line, number};
        }
        return std::nullopt;
    }

    /// The next line with something on it; `what` says what it should hold.
    Line expect(const char* what) {
        while (const auto line = next())
            if (line->text.find_first_not_of(" \t") != std::string_view::npos)
                return *line;
        throw Fault{oneLine(file.name) + " ends before " + what + "."};
    }

    [[noreturn]] void refuse(const Line& line, const std::string& because) const {
        throw Fault{oneLine(file.name) + ", line " + std::to_string(line.number) + ": " + because +
                    "."};
    }

private:
    const ScalaFile& file;
    std::string_view rest;
    int number = 0;
};

std::string_view firstWord(std::string_view line) {
    const auto start = line.find_first_not_of(" \t");
    if (start == std::string_view::npos)
        return {};
    line.remove_prefix(start);
    return line.substr(0, line.find_first_of(" \t!"));
}

/// "701.955" is cents; "3/2" and "2" are ratios, whose numbers may be of any size.
std::optional<double> cents(std::string_view word) {
    if (word.find('.') != std::string_view::npos)
        return parseNumber(word);
    const auto slash = word.find('/');
    const auto above = parseNumber(word.substr(0, slash));
    const auto below = parseNumber(slash == std::string_view::npos ? "1" : word.substr(slash + 1));
    if (!above || !below || !(*above > 0) || !(*below > 0))
        return std::nullopt;
    return 1200 * std::log2(*above / *below);
}

int wholeNumber(Lines& lines, const char* what, int least, int most) {
    const auto line = lines.expect(what);
    const auto value = parseInteger(firstWord(line.text));
    if (!value || *value < least || *value > most)
        lines.refuse(line, std::string(what) + " is not a whole number from " +
                               std::to_string(least) + " to " + std::to_string(most));
    return static_cast<int>(*value);
}

Tunings::Scale readScale(const ScalaFile& file) {
    if (!file.isGiven())
        return Tunings::evenTemperament12NoteScale();
    Lines lines(file);
    if (!lines.next())
        throw Fault{oneLine(file.name) + " is empty."};
    Tunings::Scale scale;
    scale.count = wholeNumber(lines, "the number of notes", 1, ScalaTuning::mostDegrees);
    for (int degree = 1; degree <= scale.count; ++degree) {
        const auto what =
            "note " + std::to_string(degree) + " of its " + std::to_string(scale.count);
        const auto line = lines.expect(what.c_str());
        const auto pitch = cents(firstWord(line.text));
        if (!pitch)
            lines.refuse(line, what + " is neither cents nor a ratio");
        if (!(std::abs(*pitch) <= mostCents))
            lines.refuse(line, what + " is more than twenty octaves away");
        Tunings::Tone tone;
        tone.type = Tunings::Tone::kToneCents;
        tone.cents = *pitch;
        tone.floatValue = *pitch / 1200 + 1;
        scale.tones.push_back(tone);
    }
    return scale;
}

/// The key that a mapping repeats from is moved by whole repetitions to where the reference note is
/// in the first of them: the library looks for it there alone.
void moveToReference(Tunings::KeyboardMapping& mapping) {
    while (mapping.tuningConstantNote < mapping.middleNote)
        mapping.middleNote -= mapping.count;
    while (mapping.tuningConstantNote >= mapping.middleNote + mapping.count)
        mapping.middleNote += mapping.count;
}

Tunings::KeyboardMapping readMapping(const ScalaFile& file, int degrees) {
    Tunings::KeyboardMapping mapping;
    if (!file.isGiven())
        return mapping;
    Lines lines(file);
    mapping.count = wholeNumber(lines, "the size of the map", 0, ScalaTuning::mostDegrees);
    mapping.firstMidi = wholeNumber(lines, "the first note", 0, 127);
    mapping.lastMidi = wholeNumber(lines, "the last note", 0, 127);
    mapping.middleNote = wholeNumber(lines, "the middle note", 0, 127);
    mapping.tuningConstantNote = wholeNumber(lines, "the reference note", 0, 127);
    const auto frequencyLine = lines.expect("the reference frequency");
    const auto frequency = parseNumber(firstWord(frequencyLine.text));
    if (!frequency || !(*frequency >= lowestHz) || !(*frequency <= highestHz))
        lines.refuse(frequencyLine, "the reference frequency is not one from 1 to 100000 Hz");
    mapping.tuningFrequency = *frequency;
    mapping.tuningPitch = *frequency / Tunings::MIDI_0_FREQ;
    mapping.octaveDegrees = wholeNumber(lines, "the degree of the formal octave", 0, degrees);
    for (int key = 1; key <= mapping.count; ++key) {
        const auto what = "key " + std::to_string(key) + " of its " + std::to_string(mapping.count);
        const auto line = lines.expect(what.c_str());
        const auto word = firstWord(line.text);
        const auto degree =
            word == "x" || word == "X" ? std::optional<std::int64_t>(-1) : parseInteger(word);
        if (!degree || *degree < -1 || *degree > degrees)
            lines.refuse(line,
                         what + " is neither x nor a degree from 0 to " + std::to_string(degrees));
        mapping.keys.push_back(static_cast<int>(*degree));
    }
    if (mapping.count > 0) {
        moveToReference(mapping);
        if (mapping
                .keys[static_cast<std::size_t>(mapping.tuningConstantNote - mapping.middleNote)] <
            0)
            throw Fault{oneLine(file.name) + " gives the reference note no degree."};
    }
    return mapping;
}

KeyTuning pitches(const Tunings::Tuning& tuning) {
    KeyTuning keys;
    for (int note = 0; note < KeyTuning::notes; ++note) {
        const auto index = static_cast<std::size_t>(note);
        const double hertz = tuning.frequencyForMidiNote(note);
        if (!tuning.isMidiNoteMapped(note) || !(hertz >= lowestHz) || !(hertz <= highestHz)) {
            keys.unmapped.set(index);
            continue;
        }
        const double semitones = 12 * tuning.logScaledFrequencyForMidiNote(note) - note;
        if (std::abs(semitones) > negligibleSemitones)
            keys.semitonesFromEqual[index] = semitones;
    }
    return keys;
}

} // namespace

Result<KeyTuning> keyTuning(const ScalaTuning& tuning) {
    try {
        const auto scale = readScale(tuning.scale);
        const auto mapping = readMapping(tuning.mapping, scale.count);
        return pitches(Tunings::Tuning(scale, mapping));
    } catch (const Fault& fault) {
        return failure(fault.sentence);
    }
}

std::string scaleTitle(const ScalaTuning& tuning) {
    if (!tuning.scale.isGiven())
        return tuning.mapping.isGiven() ? tuning.mapping.name : "Equal temperament";
    Lines lines(tuning.scale);
    const auto description = lines.next();
    if (!description)
        return tuning.scale.name;
    const auto first = description->text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return tuning.scale.name;
    const auto last = description->text.find_last_not_of(" \t");
    return oneLine(description->text.substr(first, last - first + 1));
}

} // namespace idiophone
