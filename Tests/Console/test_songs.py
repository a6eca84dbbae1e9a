import struct

from console import ConsoleTest, Wave, midi_file, note, tempo

XYLOPHONE = "Rosewood Xylophone"
NOTES = note(0, 72) + note(480, 74) + note(960, 76)


class Songs(ConsoleTest):
    """Renders the MIDI files of many programs."""

    def render(self, content, *options, preset=XYLOPHONE, seconds=1.5):
        output = self.folder / "song.wav"
        said = self.succeed("render", "--preset", preset, "--midi",
                            self.write("song.mid", content), "-o", output, "--seconds", seconds,
                            *options).stderr
        return output.read_bytes(), said

    def assert_plays(self, content, expected, saying=""):
        sound, said = self.render(content)
        self.assertEqual(sound, self.render(expected)[0])
        if saying:
            self.assertIn(saying, said)
            self.assertEqual(said.count("warning: "), 1)
        else:
            self.assertEqual(said, "")

    def refuse_song(self, content, saying):
        self.refuse("render", "--preset", XYLOPHONE, "--midi", self.write("bad.mid", content), "-o",
                    self.folder / "bad.wav", naming="bad.mid", saying=saying)

    def test_frames_with_dropped_numbers_take_1001_of_30000_seconds(self):
        # 30 frames of 40 ticks take 1.001 seconds.
        frames = midi_file(note(0, 72) + note(1200, 84), division=-29 * 256 + 40)
        milliseconds = midi_file([tempo(0, 1000000)] + note(0, 72) + note(1001, 84), division=1000)
        self.assert_plays(frames, milliseconds)

    def test_lengths_of_system_exclusive_messages_count_not_their_bytes(self):
        plain = midi_file(NOTES)
        for packets in ([b"\xf0\x03\x43\x12\x00", b"\xf7\x04\x43\x12\x00\xf7"],
                        [b"\xf0\x02\x43\x12", b"\xf7\x01\x00", b"\xf7\x02\x12\xf7"],
                        [b"\xf0\x05\x43\x90\x45\x64\xf7"],
                        [b"\xf0\x04\x43\x12\x45\x64"],
                        [b"\xf0\x00"], [b"\xf7\x03\x90\x45\x64"],
                        [b"\xf0\x81\x00" + b"\x48" * 127 + b"\xf7"]):
            with self.subTest(packets=packets):
                self.assert_plays(midi_file([(240, packet) for packet in packets] + NOTES), plain)

    def test_songs_in_riff_files_are_played_wherever_their_chunk_is(self):
        plain = midi_file(NOTES)

        def chunk(name, content):
            return name + struct.pack("<I", len(content)) + content + b"\0" * (len(content) % 2)

        info = chunk(b"LIST", b"INFO" + chunk(b"INAM", b"A name of some words"))
        for chunks in (chunk(b"data", plain), info + chunk(b"data", plain),
                       chunk(b"data", plain) + info, chunk(b"disp", b"odd") + chunk(b"data", plain)):
            self.assert_plays(chunk(b"RIFF", b"RMID" + chunks), plain)
        self.refuse_song(chunk(b"RIFF", b"WAVE" + chunk(b"data", plain)[:8]), "not a MIDI file")

    def test_bytes_before_the_header_are_left_out_with_a_warning(self):
        self.assert_plays(b"\0" * 128 + midi_file(NOTES), midi_file(NOTES), "128 bytes before")

    def test_a_longer_header_is_passed_over(self):
        plain = midi_file(NOTES)
        self.assert_plays(plain[:4] + b"\0\0\0\x08" + plain[8:14] + b"\0\0" + plain[14:], plain)

    def test_more_tracks_than_the_header_says_are_played_with_a_warning(self):
        both = midi_file(NOTES, note(240, 84))
        type_0, miscounted = bytearray(both), bytearray(both)
        type_0[9] = 0
        miscounted[11] = 1
        self.assert_plays(bytes(type_0), both, "it is of type 0")
        self.assert_plays(bytes(miscounted), both, "its header counts 1 track, but it has 2")
        miscounted[9], miscounted[11] = 2, 2
        self.assert_plays(bytes(miscounted), both, "separate songs")

    def test_tracks_of_wrong_length_are_read_to_their_end_with_a_warning(self):
        both = midi_file(NOTES, note(240, 84))
        for number, start in ((1, both.index(b"MTrk")), (2, both.rindex(b"MTrk"))):
            length = struct.unpack_from(">I", both, start + 4)[0]
            for wrong in (length + 3, length + 11, length - 3, length - 10, 0, 2 ** 32 - 1):
                with self.subTest(track=number, length=length, wrong=wrong):
                    content = both[:start + 4] + struct.pack(">I", wrong) + both[start + 8:]
                    self.assert_plays(content, both, f"the length of track {number} is wrong")

    def test_blank_bytes_between_tracks_are_passed_over(self):
        both = midi_file(NOTES, note(240, 84))
        second = both.rindex(b"MTrk")
        self.assert_plays(both[:second] + b"\0" + both[second:], both)

    def test_the_damaged_rest_of_a_track_is_left_out_with_a_warning(self):
        whole = midi_file(NOTES)
        body = whole[22:whole.index(b"\x4c\x64") - 2] + b"\xff\xff\xff\xff"
        damaged = whole[:18] + struct.pack(">I", len(body)) + body
        self.assert_plays(damaged, midi_file(NOTES[:4]), "track 1 is damaged")

    def test_damaged_songs_are_refused_with_what_is_wrong(self):
        whole = midi_file(NOTES)
        self.refuse_song(b"hello", "not a MIDI file")
        self.refuse_song(whole[:10], "cut off in its header")
        self.refuse_song(whole[:9] + b"\3" + whole[10:], "there is no type 3")
        self.refuse_song(whole[:-3], "cut off in track 1 of 1")
        self.refuse_song(midi_file(note(0, 72), division=0), "beats have no ticks")
        self.refuse_song(midi_file(note(0, 72, velocity=200)), "a byte above 127")


class TuningMessages(ConsoleTest):
    """Tunes by messages of the MIDI Tuning Standard."""

    def retuned(self, *cents):
        """Returns an event that moves the twelve notes of all octaves."""
        return b"\xf0\x14\x7f\x7f\x08\x08\x03\x7f\x7f" + bytes(64 + c for c in cents) + b"\xf7"

    def render(self, events, *options, preset=XYLOPHONE, seconds=0.5):
        output = self.folder / "tuned.wav"
        song = self.write("tuned.mid", midi_file([tempo(0, 500000)] + events))
        said = self.succeed("render", "--preset", preset, "--midi", song, "-o", output,
                            "--seconds", seconds, *options).stderr
        return output, said

    def test_messages_tune_as_a_scale_does(self):
        cents = [0, 7, -9, 11, 3, -20, 5, 2, 31, -14, 17, -12]
        scale = self.write("same.scl", "Same\n12\n" + "".join(
            f"{100.0 * degree + cents[degree % 12]}\n" for degree in range(1, 13)))
        struck = note(0, 81) + note(120, 74)
        expected = Wave(self.render(struck, "--scale", scale)[0]).left
        plain = Wave(self.render(struck)[0]).left
        tuned, said = self.render([(0, self.retuned(*cents))] + struck)
        self.assertEqual(said, "")
        for other, is_same in ((expected, True), (plain, False)):
            difference = max(abs(a - b) for a, b in zip(Wave(tuned).left, other))
            self.assertEqual(difference < 4e-3 * max(map(abs, other)), is_same)

    def test_messages_act_at_their_sample_in_any_block_size(self):
        events = (note(7, 81, 100, 900) + [(131, self.retuned(*[30] * 12))] + note(131, 74) +
                  [(333, self.retuned(*[-50] * 12))])
        expected = self.render(events)[0].read_bytes()
        for size in (1, 61, 64, 4096):
            self.assertEqual(self.render(events, "--block-size", size)[0].read_bytes(), expected)
        self.assertNotEqual(self.render(events[:-1])[0].read_bytes(), expected)

    def test_messages_without_effect_are_named(self):
        events = [(0, self.retuned(*[30] * 12))] + note(0, 81)
        mapping = self.write("a.kbm", "0\n0\n127\n60\n69\n440\n0\n")
        overridden, said = self.render(events, "--mapping", mapping)
        self.assertIn("--scale and --mapping override", said)
        overridden = overridden.read_bytes()
        self.assertEqual(overridden,
                         self.render(events[1:], "--mapping", mapping)[0].read_bytes())
        self.assertIn("share objects", self.render(events, preset="Steel Plate")[1])
