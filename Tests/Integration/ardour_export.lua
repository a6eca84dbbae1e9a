-- Opens a session and exports its start to export/song.wav, for ardour7-lua. Arguments: the
-- session's folder and name, and how many samples.
local folder, name, frames = table.unpack(arg)

AudioEngine:set_backend("None (Dummy)", "", "")
local session = assert(load_session(folder, name), "no session")
-- An export that starts while the butler thread is still busy with the loaded session waits for it,
-- holding a lock that the butler waits for: ardour7-export stops there for ever, now and then.
ARDOUR.LuaAPI.usleep(1000000)

local export = session:simple_export()
assert(export:set_preset("5b0a6a0e-8f0d-4f0e-9d55-6b1f0c1c7a52"), "no preset of this id")
export:set_name("song")
export:set_range(0, tonumber(frames))
assert(export:run_export(), "nothing exported")

close_session()
quit()
