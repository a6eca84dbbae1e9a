// The functions of `instrument.wasm` (docs/web.md). JavaScript passes texts and bytes by address
// and length. Functions that can fail return 1 on success, else 0. The answer is then the requested
// text, or the sentence of the error.
#include "Browser/BrowserInstrument.h"
#include "Browser/InstrumentText.h"
#include "Instrument/FactoryContent.h"
#include "Object/OneLine.h"

#include <cmath>
#include <new>
#include <optional>

using namespace idiophone;

namespace {

std::optional<BrowserInstrument> played;
std::string answer;

int succeed(std::string text = {}) {
    answer = std::move(text);
    return 1;
}

int fail(std::string sentence) {
    answer = std::move(sentence);
    return 0;
}

template <class Work>
int attempt(const Work& work) {
    try {
        const Result<std::string> done = work();
        return done ? succeed(*done) : fail(done.error().message);
    } catch (const std::bad_alloc&) {
        return fail("it is too large for this machine's memory");
    }
}

std::string noText() {
    return {};
}

std::string_view text(const char* characters, std::size_t size) {
    return {characters, size};
}

} // namespace

#define EXPORT(name) __attribute__((export_name("instrument_" #name))) name

extern "C" {

void EXPORT(start)(double sampleRateHz, int isOffline) {
    played.emplace(sampleRateHz, isOffline != 0);
}

const char* EXPORT(answer_text)() {
    return answer.data();
}

std::size_t EXPORT(answer_size)() {
    return answer.size();
}

int EXPORT(presets)() {
    return attempt([] { return presetsText(); });
}

int EXPORT(parameters)() {
    return attempt([] { return parametersText(); });
}

int EXPORT(describe)() {
    return attempt([] { return instrumentText(*played); });
}

int EXPORT(needs)(const char* preset, std::size_t size) {
    return attempt([&]() -> Result<std::string> {
        if (const auto* factory = findFactoryPreset(text(preset, size)))
            return objectNamesText(*factory);
        return parsePreset(text(preset, size), "preset").and_then(objectNamesText);
    });
}

int EXPORT(add_object)(const char* name,
                       std::size_t nameSize,
                       const std::byte* bytes,
                       std::size_t size) {
    return attempt([&] {
        return played->objects()
            .add(std::string(name, nameSize), {bytes, size})
            .transform([](const auto&) { return std::string(); });
    });
}

int EXPORT(has_object)(const char* name, std::size_t nameSize) {
    return played->objects().has(std::string(name, nameSize)) ? 1 : 0;
}

int EXPORT(load_factory)(const char* name, std::size_t size) {
    return attempt([&] { return played->loadFactory(text(name, size)).transform(noText); });
}

int EXPORT(load_text)(const char* preset, std::size_t size) {
    return attempt(
        [&] { return played->loadText(text(preset, size), "preset").transform(noText); });
}

int EXPORT(load_object)(const char* name, std::size_t size) {
    return attempt([&] { return played->loadObject(std::string(name, size)).transform(noText); });
}

const float* EXPORT(vertices)(std::size_t object) {
    return played->instrument()->slots()[played->slots()[object]].object->vertices.data();
}

const std::int32_t* EXPORT(faces)(std::size_t object) {
    return played->instrument()->slots()[played->slots()[object]].object->faces.data();
}

void EXPORT(set)(std::size_t parameter, double value) {
    if (parameter < parameterCount)
        played->set(static_cast<ParameterId>(parameter), value);
}

double EXPORT(get)(std::size_t parameter) {
    return parameter < parameterCount ? played->values()[static_cast<ParameterId>(parameter)] : NAN;
}

void EXPORT(send)(int frame, int status, int first, int second) {
    played->send({.sampleOffset = frame,
                  .bytes = {static_cast<std::uint8_t>(status), static_cast<std::uint8_t>(first),
                            static_cast<std::uint8_t>(second)}});
}

void EXPORT(strike)(std::size_t object, double x, double y, double z, int velocity) {
    played->strike(object, {x, y, z}, velocity);
}

void EXPORT(scrape)(std::size_t object, double x, double y, double z, double pressure) {
    played->scrape(object, {x, y, z}, pressure);
}

void EXPORT(silence)() {
    played->silence();
}

void EXPORT(work)() {
    played->work();
}

/// Returns the numbers of BrowserInstrument::poses.
const float* EXPORT(poses)() {
    return played->poses().data();
}

std::size_t EXPORT(poses_size)() {
    return played->poses().size();
}

/// Returns the left channel; the right one begins `maximumFrames` floats later.
const float* EXPORT(render)(std::size_t frames) {
    return played->render(frames).left.data();
}

} // extern "C"
