#include "Instrument/ScalaTuning.h"

#include "Object/ByteOrderMark.h"
#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <Tunings.h>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

constexpr double maximumCents = 24000; // from one degree to the first, up or down
constexpr double lowestHz = 1, highestHz = 100000;
constexpr double negligibleSemitones = 1e-9;

// Within this file a fault is thrown; keyTuning turns it into a Result.
struct Fault {
    std::string sentence;
};

struct Line {
    std::string_view text;
    int number = 0; ///< from 1
};

/// The lines of a file, without comments, with any kind of line ending.
class Lines {
public:
    explicit Lines(const ScalaFile& source)
        : file(source), rest(withoutByteOrderMark(source.text)) {}

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

    /// Returns the next line that is not blank.
    std::optional<Line> nextFilled() {
        while (const auto line = next())
            if (line->text.find_first_not_of(" \t") != std::string_view::npos)
                return line;
        return std::nullopt;
    }

    /// Returns the next line that is not blank; the error calls its content `what`.
    Line expect(const char* what) {
        if (const auto line = nextFilled())
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

/// Returns the first word, or a ratio without the blanks around its slash ("9 / 8").
std::string pitchOf(std::string_view line) {
    const std::string first(firstWord(line));
    const auto slash = line.find('/');
    if (slash == std::string_view::npos)
        return first;
    const auto above = firstWord(line.substr(0, slash)), below = firstWord(line.substr(slash + 1));
    const auto between = line.substr(0, slash).substr(line.find(above) + above.size());
    const bool isRatio = between.find_first_not_of(" \t") == std::string_view::npos &&
                         above.find('.') == std::string_view::npos && !below.empty() &&
                         std::isdigit(static_cast<unsigned char>(below.front())) != 0;
    return isRatio ? std::string(above) + "/" + std::string(below) : first;
}

/// Parses "701.955" as cents, and "3/2" and "2" as ratios of numbers of any size.
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

Tunings::Tone toneOf(double cents) {
    Tunings::Tone tone;
    tone.type = Tunings::Tone::kToneCents;
    tone.cents = cents;
    tone.floatValue = cents / 1200 + 1;
    return tone;
}

Tunings::Scale readScale(const ScalaFile& file) {
    if (!file.isGiven())
        return Tunings::evenTemperament12NoteScale();
    Lines lines(file);
    if (!lines.next())
        throw Fault{oneLine(file.name) + " is empty."};
    Tunings::Scale scale;
    scale.count = wholeNumber(lines, "the number of notes", 1, ScalaTuning::maximumDegrees);
    for (int degree = 1; degree <= scale.count; ++degree) {
        const auto what =
            "note " + std::to_string(degree) + " of its " + std::to_string(scale.count);
        const auto line = lines.expect(what.c_str());
        const auto pitch = cents(pitchOf(line.text));
        if (!pitch)
            lines.refuse(line, what + " is neither cents nor a ratio");
        if (!(std::abs(*pitch) <= maximumCents))
            lines.refuse(line, what + " is more than twenty octaves away");
        scale.tones.push_back(toneOf(*pitch));
    }
    return scale;
}

/// A mapping as the library expects it: a scale of the mapped keys' pitches in order, and the
/// reference. The scale repeats at the formal octave. The library's own mappings always repeat at
/// the scale's last note.
struct Mapping {
    Tunings::Scale scale;
    Tunings::KeyboardMapping reference;
    std::vector<bool> isMapped; ///< [period's keys]; empty: all
};

bool isMapped(const Mapping& mapping, int note) {
    if (mapping.isMapped.empty())
        return true;
    const int count = mapping.scale.count;
    const int key = ((note - mapping.reference.middleNote) % count + count) % count;
    return mapping.isMapped[static_cast<std::size_t>(key)];
}

/// Returns the cents above the scale's first note; degrees beyond the scale continue periodically.
double centsOfDegree(const Tunings::Scale& scale, int degree) {
    const int rounds = degree / scale.count, rest = degree % scale.count;
    return rounds * scale.tones.back().cents +
           (rest == 0 ? 0 : scale.tones[static_cast<std::size_t>(rest - 1)].cents);
}

/// Returns the degrees of one period's keys; −1 for unmapped keys and those missing at the end.
std::vector<int> readDegrees(Lines& lines, int count) {
    std::vector<int> degrees(static_cast<std::size_t>(count), -1);
    for (std::size_t key = 0; key < degrees.size(); ++key) {
        const auto line = lines.nextFilled();
        if (!line)
            break;
        const auto word = firstWord(line->text);
        if (word == "x" || word == "X")
            continue;
        const auto degree = parseInteger(word);
        if (!degree || *degree < 0 || *degree > ScalaTuning::maximumDegrees)
            lines.refuse(*line, "key " + std::to_string(key + 1) + " of its " +
                                    std::to_string(count) + " is neither x nor a degree");
        degrees[key] = static_cast<int>(*degree);
    }
    return degrees;
}

Tunings::Scale
scaleOfKeys(const Tunings::Scale& scale, const std::vector<int>& degrees, int octaveDegree) {
    const auto cents = [&](int degree) { return centsOfDegree(scale, std::max(degree, 0)); };
    Tunings::Scale keys;
    keys.count = static_cast<int>(degrees.size());
    for (std::size_t key = 1; key < degrees.size(); ++key)
        keys.tones.push_back(toneOf(cents(degrees[key]) - cents(degrees[0])));
    keys.tones.push_back(toneOf(cents(octaveDegree == 0 ? scale.count : octaveDegree)));
    return keys;
}

Mapping readMapping(const ScalaFile& file, const Tunings::Scale& scale) {
    Mapping mapping{.scale = scale, .reference = {}, .isMapped = {}};
    if (!file.isGiven())
        return mapping;
    auto& reference = mapping.reference;
    Lines lines(file);
    const int count = wholeNumber(lines, "the size of the map", 0, ScalaTuning::maximumDegrees);
    reference.firstMidi = wholeNumber(lines, "the first note", 0, 127);
    reference.lastMidi = wholeNumber(lines, "the last note", 0, 127);
    reference.middleNote = wholeNumber(lines, "the middle note", 0, 127);
    reference.tuningConstantNote = wholeNumber(lines, "the reference note", 0, 127);
    const auto frequencyLine = lines.expect("the reference frequency");
    const auto frequency = parseNumber(firstWord(frequencyLine.text));
    if (!frequency || !(*frequency >= lowestHz) || !(*frequency <= highestHz))
        lines.refuse(frequencyLine, "the reference frequency is not one from 1 to 100000 Hz");
    reference.tuningFrequency = *frequency;
    reference.tuningPitch = *frequency / Tunings::MIDI_0_FREQ;
    const int octaveDegree =
        wholeNumber(lines, "the degree of the formal octave", 0, ScalaTuning::maximumDegrees);
    if (count == 0)
        return mapping;
    const auto degrees = readDegrees(lines, count);
    mapping.scale = scaleOfKeys(scale, degrees, octaveDegree);
    for (const int degree : degrees)
        mapping.isMapped.push_back(degree >= 0);
    if (!isMapped(mapping, reference.tuningConstantNote))
        throw Fault{oneLine(file.name) + " gives the reference note no degree."};
    return mapping;
}

KeyTuning pitches(const Mapping& mapping) {
    const Tunings::Tuning tuning(mapping.scale, mapping.reference);
    KeyTuning keys;
    for (int note = 0; note < KeyTuning::notes; ++note) {
        const auto index = static_cast<std::size_t>(note);
        const double hertz = tuning.frequencyForMidiNote(note);
        if (!isMapped(mapping, note) || !(hertz >= lowestHz) || !(hertz <= highestHz)) {
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
        return pitches(readMapping(tuning.mapping, scale));
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
