"""Runs Ardour without a window: its Lua makes and exports sessions in a separate home folder."""
import os
import pathlib
import shutil
import subprocess
import xml.etree.ElementTree as xml

import mido
import soundfile

from performance import SAMPLE_RATE

SESSION = "song"
SCRIPTS = pathlib.Path(__file__).parent
TICKS_PER_QUARTER = 1920  # of Ardour, independent of the file
FIRST_ID = 90_001  # above all ids of a session with one track


class Ardour:
    def __init__(self, lua, scanner, home, vst3, lv2):
        self.lua = lua
        self.environment = {name: value for name, value in os.environ.items()
                            if not name.startswith("XDG_") and name != "LV2_PATH"}
        self.environment["HOME"] = str(home)
        for folder, plugin in ((home / ".vst3", vst3), (home / ".lv2", lv2)):
            folder.mkdir()
            (folder / plugin.name).symlink_to(plugin)
        presets = home / ".config" / "ardour7" / "export"
        presets.mkdir(parents=True)
        shutil.copy(SCRIPTS / "ardour_export.preset", presets)
        self.run(scanner, "-f", home / ".vst3" / vst3.name, LD_LIBRARY_PATH=str(scanner.parent))

    def run(self, *command, **variables):
        result = subprocess.run(list(map(str, command)), env=self.environment | variables,
                                capture_output=True, text=True)
        assert result.returncode == 0, (
            f"{command} ended with {result.returncode}: {result.stdout}{result.stderr}")

    def make_session(self, folder, midi_file, plugin_type, program, parameters=(), output=1):
        values = [text for pair in parameters for text in pair]
        try:
            self.run(self.lua, SCRIPTS / "ardour_session.lua", folder, SESSION, SAMPLE_RATE,
                     "Idiophone", plugin_type, program, output, *values)
        except AssertionError as error:
            # On a busy machine Ardour may register a port of the new track twice, and abort.
            if "register_port: Port already exists" not in str(error):
                raise
            shutil.rmtree(folder)
            return self.make_session(folder, midi_file, plugin_type, program, parameters, output)
        put_song(folder, midi_file)

    def render(self, folder, frames, attempts=3):
        """Reopens the session and exports its first `frames`; returns [channels, frames]."""
        try:
            self.run(self.lua, SCRIPTS / "ardour_export.lua", folder, SESSION, frames)
        except AssertionError as error:
            # Now and then Ardour frees one of its export channels twice and dies of it, by one signal
            # or another: mostly when the session closes, with a complete file, seldom before.
            if "ended with -" not in str(error):
                raise
            if "exported\n" not in str(error):
                if attempts == 1:
                    raise
                return self.render(folder, frames, attempts - 1)
        wave = folder / "export" / "song.wav"
        assert soundfile.info(wave).subtype == "FLOAT"
        samples, rate = soundfile.read(wave, dtype="float32", always_2d=True)
        assert rate == SAMPLE_RATE
        return samples.T


def put_song(folder, midi_file):
    """Adds a MIDI file (tracks merged) and its tempo to the session file, because Ardour's Lua can
    neither import files nor make regions."""
    song = mido.MidiFile(midi_file)
    merged = mido.merge_tracks(song.tracks)
    single = mido.MidiFile(type=0, ticks_per_beat=song.ticks_per_beat)
    single.tracks.append(merged)
    single.save(next(folder.glob("interchange/*/midifiles")) / "song.mid")
    length = sum(message.time for message in merged) * TICKS_PER_QUARTER // song.ticks_per_beat
    tempo, = (mido.tempo2bpm(message.tempo) for message in merged if message.type == "set_tempo")

    file = folder / f"{SESSION}.ardour"
    tree = xml.parse(file)
    session, source, region = tree.getroot(), str(FIRST_ID), str(FIRST_ID + 1)
    session.set("id-counter", str(FIRST_ID + 2))
    xml.SubElement(session.find("Sources"), "Source", {
        "name": "song.mid", "type": "midi", "id": source, "origin": ""})
    xml.SubElement(session.find("Playlists/Playlist"), "Region", {
        "name": "song", "type": "midi", "id": region, "source-0": source,
        "master-source-0": source, "position": "b0", "start": "b0", "length": f"b{length}@b0"})
    element = session.find("TempoMap/Tempos/Tempo")
    element.set("npm", str(tempo))
    element.set("enpm", str(tempo))
    tree.write(file, encoding="UTF-8", xml_declaration=True)
