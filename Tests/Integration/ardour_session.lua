-- Makes a session with one MIDI track for the instrument; run by ardour7-lua. Arguments: the
-- session's folder and name, its sample rate, the instrument's name, VST3 or LV2, one of its
-- programs, the only output that is heard, then pairs of a parameter name and a value from 0 to 1.
local folder, name, rate, instrument, plugin_type, program = table.unpack(arg, 1, 6)
local heard = tonumber(arg[7])

AudioEngine:set_backend("None (Dummy)", "", "")
local session = assert(create_session(folder, name, tonumber(rate)), "no session")
local info = ARDOUR.LuaAPI.new_plugin_info(instrument, ARDOUR.PluginType[plugin_type])
assert(not info:isnil(), "Ardour does not know the plugin")

local midi = ARDOUR.ChanCount(ARDOUR.DataType("midi"), 1)
local audio = ARDOUR.ChanCount(ARDOUR.DataType("audio"), heard == 1 and 2 or 16)
local tracks = session:new_midi_track(midi, audio, heard == 1, info, nil, nil, 1, instrument,
    ARDOUR.PresentationInfo.max_order, ARDOUR.TrackMode.Normal, true)
local track = tracks:front()
local processor = track:nth_plugin(0)
local plugin = processor:to_insert():plugin(0)

-- Ardour's values reach the plugin with the next block, and the plugin's values reach Ardour from a
-- JUCE timer. Without a pause they cross.
local function settle()
    ARDOUR.LuaAPI.usleep(500000)
end

settle()
local preset = plugin:preset_by_label(program)
assert(preset and plugin:load_preset(preset), "no program " .. program)
settle()

local indices = {}
for index = 0, plugin:parameter_count() - 1 do
    indices[plugin:parameter_label(index)] = index
end
for position = 8, #arg, 2 do
    local index = assert(indices[arg[position]], "no parameter " .. arg[position])
    assert(ARDOUR.LuaAPI.set_processor_param(processor, index, tonumber(arg[position + 1])))
end
settle()

-- By now Ardour's own thread has connected the new track.
if heard > 1 then
    track:panner_shell():set_bypassed(true) -- it would spread each channel over all of them
    track:output():disconnect_all(nil)
    for channel = 0, 1 do
        local port = track:output():audio(2 * heard - 2 + channel)
        assert(port:connect(session:master_out():input():audio(channel):name()) == 0)
    end
end

session:save_state("")
close_session()
quit()
