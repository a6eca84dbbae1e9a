#include "Plugin/RecorderSession.h"

#include "AudioFiles/AudioFileWriter.h"
#include "Editor/Utf8.h"

#include <array>
#include <cmath>

namespace idiophone {
namespace {

Result<void>
writeWav(const std::filesystem::path& file, const RollingSound::Piece& piece, double rateHz) {
    auto writer = AudioFileWriter::create(file, static_cast<int>(std::lround(rateHz)), 2, 32);
    if (!writer)
        return tl::unexpected(writer.error());
    const std::array<const float*, 2> channels{piece.left.data(), piece.right.data()};
    return (*writer)->write(channels.data(), static_cast<int>(piece.left.size())).and_then([&] {
        return (*writer)->finish();
    });
}

} // namespace

RollingSound::Piece RecorderSession::heard() const {
    const auto sound = lastSound.sound();
    return sound == nullptr ? RollingSound::Piece() : withoutSilence(sound->read(0));
}

bool RecorderSession::writeLastSound(const std::filesystem::path& file) {
    const auto sound = lastSound.sound();
    const auto piece = heard();
    if (sound == nullptr || piece.left.empty())
        return false;
    const auto written = writeWav(file, piece, sound->sampleRateHz());
    if (!written)
        session.reportError("The sound was not written: " + written.error().message + ".");
    return written.has_value();
}

void RecorderSession::startRecording() {
    const auto refuse = [this](const std::string& reason) {
        session.reportError("The recording cannot start: " + reason + ".");
    };
    keepLastSound();
    const auto sound = lastSound.sound();
    if (sound == nullptr)
        return refuse("the host has not started the sound yet");
    const auto folder =
        juce::File::getSpecialLocation(juce::File::userMusicDirectory).getChildFile("Idiophone");
    if (folder.createDirectory().failed())
        return refuse("there can be no folder " + folder.getFullPathName().toStdString());
    const auto file = folder.getNonexistentChildFile(fromUtf8(newName()), ".wav");
    if (const auto started = recorder.start(sound, pathOf(file)); !started)
        refuse(started.error().message);
}

void RecorderSession::stopRecording() {
    recorder.stop();
    poll();
}

void RecorderSession::poll() {
    if (const auto error = recorder.takeError(); !error.empty())
        session.reportError(error);
}

std::string RecorderSession::newName() const {
    const auto preset = fromUtf8(session.playingPreset().details.name).trim();
    const auto time = juce::Time::getCurrentTime().formatted(" %Y-%m-%d %H.%M.%S");
    return juce::File::createLegalFileName((preset.isEmpty() ? "Idiophone" : preset) + time)
        .toStdString();
}

} // namespace idiophone
