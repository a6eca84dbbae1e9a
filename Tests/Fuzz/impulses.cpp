// Fuzzes lists of impulses, as games and physics engines write them.
#include "Console/ImpulseFile.h"
#include "Fuzz/FuzzTarget.h"

#include <sstream>

namespace idiophone::fuzz {
namespace {

/// Claims one sentence for each of the first bad lines.
void claimSentences(const Error& error) {
    std::istringstream lines(error.message);
    std::string line;
    int count = 0;
    while (std::getline(lines, line)) {
        claimSentence({line});
        ++count;
    }
    claim(count >= 1 && count <= 21, "there are some sentences and not too many");
}

} // namespace

void examine(std::string_view bytes) {
    const auto impulses = readImpulses(scratchFile(bytes, "fuzz.jsonl"));
    if (!impulses)
        return claimSentences(impulses.error());
    claim(!impulses->empty(), "there are impulses");
    claim(std::ranges::is_sorted(*impulses, {}, &Impulse::seconds), "they are in order of time");
    for (const auto& impulse : *impulses) {
        claim(impulse.seconds >= 0 && impulse.seconds <= 36000, "they fall within 10 hours");
        claim(impulse.contactSeconds >= 0 && impulse.contactSeconds <= 1, "contacts are short");
        claim(!impulse.object.empty(), "they hit an object");
        claim(!impulse.vertex || *impulse.vertex >= 0, "they hit a vertex");
        claimFinite(impulse.pointMetres, "they hit a point");
        claimFinite(impulse.impulseNewtonSeconds, "they are finite");
    }
}

} // namespace idiophone::fuzz
