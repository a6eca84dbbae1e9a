-- Makes a session with one MIDI track for the instrument; run by ardour7-lua. Arguments: the
-- session's folder and name, its sample rate, the instrument's name, VST3 or LV2, one of its
-- programs, then pairs of a parameter name and a value from 0 to 1.
local folder, name, rate, instrument, plugin_type, program = table.unpack(arg, 1, 6)

AudioEngine:set_backend("None (Dummy)", "", "")
local session = assert(create_session(folder, name, tonumber(rate)), "no session")
local info = ARDOUR.LuaAPI.new_plugin_info(instrument, ARDOUR.PluginType[plugin_type])
assert(not info:isnil(), "Ardour does not know the plugin")

local midi = ARDOUR.ChanCount(ARDOUR.DataType("midi"), 1)
local stereo = ARDOUR.ChanCount(ARDOUR.DataType("audio"), 2)
local tracks = session:new_midi_track(midi, stereo, true, info, nil, nil, 1, instrument,
    ARDOUR.PresentationInfo.max_order, ARDOUR.TrackMode.Normal, true)
local processor = tracks:front():nth_plugin(0)
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
for position = 7, #arg, 2 do
    local index = assert(indices[arg[position]], "no parameter " .. arg[position])
    assert(ARDOUR.LuaAPI.set_processor_param(processor, index, tonumber(arg[position + 1])))
end
settle()

session:save_state("")
close_session()
quit()
