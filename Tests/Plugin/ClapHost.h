// A CLAP host for tests, with CLAP's headers only: it loads a plugin, sends events and renders.
#pragma once

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <clap/clap.h>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#ifdef _WIN32
#define NOMINMAX
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace idiophone {

/// The library stays loaded, as in most hosts.
inline const clap_plugin_entry& clapEntry(const std::string& path) {
#ifdef _WIN32
    const auto library = LoadLibraryA(path.c_str());
    const void* symbol =
        library ? reinterpret_cast<const void*>(GetProcAddress(library, "clap_entry")) : nullptr;
#else
    void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    const void* symbol = library ? dlsym(library, "clap_entry") : nullptr;
#endif
    REQUIRE(symbol);
    return *static_cast<const clap_plugin_entry*>(symbol);
}

/// An event of any kind that the tests send.
union ClapEvent {
    clap_event_header header;
    clap_event_note note;
    clap_event_note_expression expression;
    clap_event_param_value parameter;
    clap_event_param_mod modulation;
    clap_event_midi midi;
};

/// `id` is the host's number of the note.
inline ClapEvent
noteEvent(std::uint16_t type, std::uint32_t sample, int key, int id, double velocity) {
    return {.note = {.header = {sizeof(clap_event_note), sample, CLAP_CORE_EVENT_SPACE_ID, type, 0},
                     .note_id = id,
                     .port_index = 0,
                     .channel = 0,
                     .key = static_cast<std::int16_t>(key),
                     .velocity = velocity}};
}

inline ClapEvent noteOn(std::uint32_t sample, int key, int id, double velocity = 0.8) {
    return noteEvent(CLAP_EVENT_NOTE_ON, sample, key, id, velocity);
}

/// Addresses the note by its number alone.
inline ClapEvent expression(std::uint32_t sample, clap_note_expression kind, int id, double value) {
    return {.expression = {.header = {sizeof(clap_event_note_expression), sample,
                                      CLAP_CORE_EVENT_SPACE_ID, CLAP_EVENT_NOTE_EXPRESSION, 0},
                           .expression_id = kind,
                           .note_id = id,
                           .port_index = -1,
                           .channel = -1,
                           .key = -1,
                           .value = value}};
}

inline ClapEvent parameterEvent(const clap_param_info& parameter, double value) {
    return {.parameter = {.header = {sizeof(clap_event_param_value), 0, CLAP_CORE_EVENT_SPACE_ID,
                                     CLAP_EVENT_PARAM_VALUE, 0},
                          .param_id = parameter.id,
                          .cookie = parameter.cookie,
                          .note_id = -1,
                          .port_index = -1,
                          .channel = -1,
                          .key = -1,
                          .value = value}};
}

/// Modulates the note by its number alone; -1: all notes.
inline ClapEvent modulationEvent(std::uint32_t sample,
                                 const clap_param_info& parameter,
                                 double amount,
                                 int id = -1) {
    return {.modulation = {.header = {sizeof(clap_event_param_mod), sample,
                                      CLAP_CORE_EVENT_SPACE_ID, CLAP_EVENT_PARAM_MOD, 0},
                           .param_id = parameter.id,
                           .cookie = parameter.cookie,
                           .note_id = id,
                           .port_index = -1,
                           .channel = -1,
                           .key = -1,
                           .amount = amount}};
}

/// One instance at 48 kHz that renders offline.
class ClapInstance {
public:
    static constexpr std::uint32_t blockSamples = 480;

    explicit ClapInstance(const std::string& path) : entry(clapEntry(path)) {
        REQUIRE(entry.init(path.c_str()));
        const auto* factory =
            static_cast<const clap_plugin_factory*>(entry.get_factory(CLAP_PLUGIN_FACTORY_ID));
        REQUIRE(factory);
        REQUIRE(factory->get_plugin_count(factory) == 1);
        const auto* descriptor = factory->get_plugin_descriptor(factory, 0);
        plugin = factory->create_plugin(factory, &host, descriptor->id);
        REQUIRE(plugin);
        REQUIRE(plugin->init(plugin));
        REQUIRE(extension<clap_plugin_render>(CLAP_EXT_RENDER).set(plugin, CLAP_RENDER_OFFLINE));
        activate();
    }
    ~ClapInstance() {
        deactivate();
        plugin->destroy(plugin);
        entry.deinit();
    }
    ClapInstance(const ClapInstance&) = delete;
    ClapInstance& operator=(const ClapInstance&) = delete;

    void activateAnew() const {
        deactivate();
        activate();
    }

    const clap_plugin_descriptor& descriptor() const { return *plugin->desc; }

    template <class Extension>
    const Extension& extension(const char* id) const {
        const auto* found = static_cast<const Extension*>(plugin->get_extension(plugin, id));
        REQUIRE(found);
        return *found;
    }

    clap_param_info parameter(std::string_view name) const {
        const auto& parameters = extension<clap_plugin_params>(CLAP_EXT_PARAMS);
        clap_param_info info{};
        for (std::uint32_t i = 0; i < parameters.count(plugin); ++i)
            if (parameters.get_info(plugin, i, &info) && name == info.name)
                return info;
        FAIL("there is no parameter " << name);
        return info;
    }

    double value(const clap_param_info& parameter) const {
        double value = -1;
        REQUIRE(
            extension<clap_plugin_params>(CLAP_EXT_PARAMS).get_value(plugin, parameter.id, &value));
        return value;
    }

    std::vector<char> save() const {
        std::vector<char> bytes;
        const clap_ostream stream{
            &bytes, [](const clap_ostream* to, const void* from, std::uint64_t count) {
                const auto* first = static_cast<const char*>(from);
                auto& saved = *static_cast<std::vector<char>*>(to->ctx);
                saved.insert(saved.end(), first, first + count);
                return static_cast<std::int64_t>(count);
            }};
        REQUIRE(extension<clap_plugin_state>(CLAP_EXT_STATE).save(plugin, &stream));
        return bytes;
    }

    void restore(std::vector<char> bytes) const {
        const clap_istream stream{
            &bytes, [](const clap_istream* from, void* to, std::uint64_t count) {
                auto& left = *static_cast<std::vector<char>*>(from->ctx);
                const auto given = std::min<std::size_t>(left.size(), count);
                std::memcpy(to, left.data(), given);
                left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(given));
                return static_cast<std::int64_t>(given);
            }};
        REQUIRE(extension<clap_plugin_state>(CLAP_EXT_STATE).load(plugin, &stream));
    }

    /// Renders whole blocks with the events in time order; returns the left channel. An effect
    /// hears `input` on both channels.
    std::vector<float> render(std::vector<ClapEvent> events,
                              std::size_t blocks,
                              const std::vector<float>& input = {}) const {
        std::vector<float> rendered;
        ended.clear();
        for (std::size_t block = 0; block < blocks; ++block) {
            std::vector<ClapEvent> now;
            const auto start = static_cast<std::uint32_t>(block) * blockSamples;
            for (auto event : events)
                if (event.header.time >= start && event.header.time < start + blockSamples) {
                    event.header.time -= start;
                    now.push_back(event);
                }
            std::array<std::array<float, blockSamples>, 2> heard{}, played{};
            for (std::size_t k = 0; k < blockSamples && start + k < input.size(); ++k)
                heard[0][k] = heard[1][k] = input[start + k];
            const auto before = ended.size();
            process(now, heard, played);
            for (auto end = before; end < ended.size(); ++end)
                ended[end].header.time += start;
            rendered.insert(rendered.end(), played[0].begin(), played[0].end());
        }
        return rendered;
    }

    /// Returns the ends of notes that the plugin sent in the last `render`, at its samples.
    const std::vector<clap_event_note>& noteEnds() const { return ended; }

    clap_voice_info voices() const {
        clap_voice_info info{};
        REQUIRE(extension<clap_plugin_voice_info>(CLAP_EXT_VOICE_INFO).get(plugin, &info));
        return info;
    }

private:
    void activate() const {
        REQUIRE(plugin->activate(plugin, 48000, 1, blockSamples));
        REQUIRE(plugin->start_processing(plugin));
    }
    void deactivate() const {
        plugin->stop_processing(plugin);
        plugin->deactivate(plugin);
    }

    using Stereo = std::array<std::array<float, blockSamples>, 2>;

    void process(std::vector<ClapEvent>& events, Stereo& heard, Stereo& played) const {
        const clap_input_events in{
            &events,
            [](const clap_input_events* list) {
                return static_cast<std::uint32_t>(
                    static_cast<std::vector<ClapEvent>*>(list->ctx)->size());
            },
            [](const clap_input_events* list, std::uint32_t index) -> const clap_event_header* {
                return &(*static_cast<std::vector<ClapEvent>*>(list->ctx))[index].header;
            }};
        const clap_output_events out{
            &ended, [](const clap_output_events* list, const clap_event_header* event) {
                if (event->type == CLAP_EVENT_NOTE_END)
                    static_cast<std::vector<clap_event_note>*>(list->ctx)->push_back(
                        *reinterpret_cast<const clap_event_note*>(event));
                return true;
            }};
        std::array<float*, 2> heardChannels{heard[0].data(), heard[1].data()};
        std::array<float*, 2> playedChannels{played[0].data(), played[1].data()};
        clap_audio_buffer input{heardChannels.data(), nullptr, 2, 0, 0};
        clap_audio_buffer output{playedChannels.data(), nullptr, 2, 0, 0};
        const auto inputs =
            extension<clap_plugin_audio_ports>(CLAP_EXT_AUDIO_PORTS).count(plugin, true);
        const clap_process process{-1, blockSamples, nullptr, &input, &output, inputs,
                                   1,  &in,          &out};
        REQUIRE(plugin->process(plugin, &process) != CLAP_PROCESS_ERROR);
    }

    const clap_plugin_entry& entry;
    clap_host host{CLAP_VERSION,
                   nullptr,
                   "test",
                   "Idiophone",
                   "",
                   "1",
                   [](const clap_host*, const char*) -> const void* { return nullptr; },
                   [](const clap_host*) {},
                   [](const clap_host*) {},
                   [](const clap_host*) {}};
    const clap_plugin* plugin = nullptr;
    mutable std::vector<clap_event_note> ended;
};

} // namespace idiophone
