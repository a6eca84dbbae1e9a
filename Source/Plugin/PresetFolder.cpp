#include "Plugin/PresetFolder.h"

#include "Editor/Utf8.h"
#include "Instrument/PresetFile.h"
#include "Object/FileBytes.h"
#include "Object/TextFile.h"
#include "Plugin/ContentHash.h"
#include "Plugin/PresetObjects.h"
#include "Plugin/WholeFile.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace idiophone {
namespace {

constexpr int longestName = 100;
constexpr std::size_t longestNameBytes = 240; // file systems allow 255, with the ending
constexpr const char* ending = ".json";

std::string nameOf(const PresetFolder::Entry& entry) {
    return entry.preset ? entry.preset->name : entry.id;
}

Result<juce::String> legalName(const std::string& name, const char* ofWhat) {
    // JUCE takes a name that begins with ~ for a path.
    const auto legal =
        juce::File::createLegalFileName(fromUtf8(name)).trimCharactersAtStart(".~ ").trim();
    if (legal.isEmpty())
        return failure(std::string(ofWhat) + " needs a name that a file can have.");
    if (legal.length() > longestName || legal.getNumBytesAsUTF8() > longestNameBytes)
        return failure(std::string(ofWhat) + " needs a name of at most " +
                       std::to_string(longestName) + " characters and " +
                       std::to_string(longestNameBytes) + " bytes.");
    return legal;
}

/// Ignores case, because some file systems do.
bool isForObjects(const juce::String& topFolder) {
    return topFolder.equalsIgnoreCase(presetObjectFolder);
}

struct FoundFile {
    juce::File file;
    juce::int64 bytes = 0;
    juce::Time written;
};

/// Returns the folder's own files first, by depth, then files behind links, as a link may lead to a
/// whole disk.
std::vector<FoundFile> presetFilesBelow(const juce::File& root, int maximumEntries) {
    struct Place {
        juce::File folder;
        int depth = 0;
    };
    std::vector<FoundFile> files;
    std::deque<Place> own{{.folder = root}}, linked;
    std::set<std::filesystem::path> visited; // links may form cycles
    int entries = 0;
    while (!own.empty() || !linked.empty()) {
        auto& waiting = own.empty() ? linked : own;
        const Place place = std::move(waiting.front());
        waiting.pop_front();
        std::error_code fault;
        auto path = std::filesystem::canonical(pathOf(place.folder), fault);
        if (fault)
            path = pathOf(place.folder);
        if (!visited.insert(std::move(path)).second)
            continue;
        for (const auto& entry : juce::RangedDirectoryIterator(place.folder, false, "*",
                                                               juce::File::findFilesAndDirectories |
                                                                   juce::File::ignoreHiddenFiles)) {
            if (++entries > maximumEntries)
                return files;
            const auto file = entry.getFile();
            if (!entry.isDirectory()) {
                if (file.hasFileExtension(ending))
                    files.push_back({.file = file,
                                     .bytes = entry.getFileSize(),
                                     .written = entry.getModificationTime()});
            } else if (place.depth < PresetFolder::deepestFolder &&
                       (place.depth > 0 || !isForObjects(file.getFileName()))) {
                (file.isSymbolicLink() ? linked : own)
                    .push_back({.folder = file, .depth = place.depth + 1});
            }
        }
    }
    return files;
}

std::uint64_t hashOf(const std::string& text) {
    return contentHash(std::as_bytes(std::span(text)));
}

Result<void> writePreset(const Preset& preset, const juce::File& file) {
    const auto text = encodePreset(preset);
    if (text.size() > largestPresetBytes)
        return failure(file.getFileName().toStdString() + ": the preset is too large for a file.");
    return writeWhole(file, std::as_bytes(std::span(text)));
}

} // namespace

std::string PresetFolder::idOf(const juce::File& file) const {
    return file.getRelativePathFrom(root).replaceCharacter('\\', '/').toStdString();
}

juce::File PresetFolder::fileOf(const std::string& id) const {
    return root.getChildFile(fromUtf8(id));
}

PresetFolder::Entry PresetFolder::readEntry(const juce::File& file) const {
    const auto path = pathOf(file);
    const auto text = readTextFile(path, largestPresetBytes);
    const auto id = idOf(file);
    const auto slash = id.rfind('/');
    return {.id = id,
            .folder = slash == std::string::npos ? "" : id.substr(0, slash),
            .preset = text.and_then([&](const std::string& read) {
                return parsePreset(read, nameOf(path.filename()));
            }),
            .content = text ? hashOf(*text) : 0};
}

const std::vector<PresetFolder::Entry>& PresetFolder::read() {
    std::map<std::string, Entry> known;
    for (auto& entry : std::exchange(found, {}))
        known.emplace(entry.id, std::move(entry));
    for (const auto& [file, bytes, written] : presetFilesBelow(root, entryLimit)) {
        const auto before = known.find(idOf(file));
        const bool isKnown = before != known.end() && before->second.bytes == bytes &&
                             before->second.written == written;
        found.push_back(isKnown ? std::move(before->second) : readEntry(file));
        found.back().bytes = bytes;
        found.back().written = written;
    }
    std::ranges::sort(found, [](const Entry& a, const Entry& b) {
        const int folders = fromUtf8(a.folder).compareNatural(fromUtf8(b.folder));
        const int names = fromUtf8(nameOf(a)).compareNatural(fromUtf8(nameOf(b)));
        return folders != 0 ? folders < 0 : names != 0 ? names < 0 : a.id < b.id;
    });
    return found;
}

const PresetFolder::Entry* PresetFolder::find(const std::string& id) const {
    const auto entry = std::ranges::find(found, id, &Entry::id);
    return entry == found.end() ? nullptr : &*entry;
}

void PresetFolder::forget(const std::string& id) {
    if (const auto entry = std::ranges::find(found, id, &Entry::id); entry != found.end())
        entry->bytes = -1;
}

Result<juce::File> PresetFolder::folder() const {
    if (root == juce::File())
        return failure("There is no place for presets of your own on this machine.");
    if (const auto made = root.createDirectory(); !made.wasOk())
        return failure(root.getFullPathName().toStdString() + ": the folder cannot be made.");
    return root;
}

Result<juce::File> PresetFolder::placeFor(const std::string& name,
                                          const std::string& folderName) const {
    if (root == juce::File())
        return failure("There is no place for presets of your own on this machine.");
    auto place = root;
    const auto parts = juce::StringArray::fromTokens(fromUtf8(folderName), "/\\", "");
    int depth = 0;
    for (const auto& part : parts) {
        if (part.trim().isEmpty())
            continue;
        // An existing folder keeps its name, even if some systems do not allow it.
        const auto child = place.getChildFile(part.trim());
        const bool isThere = child.isDirectory() && child.isAChildOf(place);
        const auto legal =
            isThere ? Result<juce::String>(part.trim()) : legalName(part.toStdString(), "A folder");
        if (!legal)
            return tl::unexpected(legal.error());
        if (++depth > deepestFolder)
            return failure("Folders of presets go " + std::to_string(deepestFolder) + " deep.");
        if (depth == 1 && isForObjects(*legal))
            return failure(std::string("The folder '") + presetObjectFolder +
                           "' is for the objects of presets.");
        place = place.getChildFile(*legal);
    }
    return legalName(name, "A preset").map([&](const juce::String& legal) {
        return place.getChildFile(legal + ending);
    });
}

Result<std::string>
PresetFolder::write(const Preset& preset, const std::string& folderName, bool replace) {
    const auto place = placeFor(preset.name, folderName);
    if (!place)
        return tl::unexpected(place.error());
    if (place->exists() && !replace)
        return failure("There is already a preset '" +
                       place->getFileNameWithoutExtension().toStdString() + "'.");
    return writePreset(preset, *place).map([&] {
        forget(idOf(*place));
        return idOf(*place);
    });
}

std::uint64_t PresetFolder::contentOf(const juce::File& file) {
    const auto text = readTextFile(pathOf(file), largestPresetBytes);
    return text ? hashOf(*text) : 0;
}

Result<void> PresetFolder::checkContent(const std::string& id, std::uint64_t content) {
    const auto file = fileOf(id);
    if (find(id) == nullptr || !file.existsAsFile())
        return failure(id + " was renamed, moved or deleted elsewhere: save the sound by Save as "
                            "in the list of presets.");
    const auto text = readTextFile(pathOf(file), largestPresetBytes);
    if (text && hashOf(*text) == content)
        return {};
    forget(id);
    return failure(id + " was changed elsewhere since this sound was loaded: load it again, or "
                        "save the sound by Save as in the list of presets.");
}

Result<void> PresetFolder::replace(const std::string& id, const Preset& preset) {
    if (find(id) == nullptr)
        return failure("There is no preset '" + id + "' any more.");
    return writePreset(preset, fileOf(id)).map([&] { forget(id); });
}

Result<std::string> PresetFolder::rename(const std::string& id, const std::string& name) {
    const auto file = fileOf(id);
    if (find(id) == nullptr || !file.existsAsFile())
        return failure("There is no preset '" + id + "' any more.");
    const auto place = legalName(name, "A preset").map([&](const juce::String& legal) {
        return file.getSiblingFile(legal + ending); // the folder may have any name
    });
    if (!place)
        return tl::unexpected(place.error());
    const bool sameFile = *place == file;
    if (place->exists() && !sameFile)
        return failure("There is already a preset '" +
                       place->getFileNameWithoutExtension().toStdString() + "'.");
    return readPresetFile(pathOf(file))
        .and_then([&](Preset preset) {
            preset.name = name;
            return writePreset(preset, *place);
        })
        .and_then([&]() -> Result<std::string> {
            if (!sameFile && !file.deleteFile()) {
                place->deleteFile();
                return failure(file.getFullPathName().toStdString() +
                               ": the preset cannot be renamed.");
            }
            forget(idOf(*place));
            return idOf(*place);
        });
}

Result<void> PresetFolder::moveToBin(const std::string& id) {
    const auto file = fileOf(id);
    if (find(id) == nullptr || !file.existsAsFile())
        return failure("There is no preset '" + id + "' any more.");
#if JUCE_LINUX
    // JUCE expects the bin to exist. A desktop creates it with the first deletion.
    juce::File("~/.local/share/Trash/files").createDirectory();
#endif
    if (!file.moveToTrash())
        return failure(file.getFullPathName().toStdString() +
                       ": it cannot be moved to the bin, and stays.");
    return {};
}

} // namespace idiophone
