-- Opens a session and exports its start to export/song.wav; run by ardour7-lua. Arguments: the
-- session's folder and name, and the number of samples.
local folder, name, frames = table.unpack(arg)

AudioEngine:set_backend("None (Dummy)", "", "")
local session = assert(load_session(folder, name), "no session")
-- Wait until Ardour's butler thread is done with the loaded session. An export that starts earlier
-- waits for the butler while it holds a lock that the butler needs: a deadlock, now and then.
ARDOUR.LuaAPI.usleep(1000000)

local export = session:simple_export()
assert(export:set_preset("5b0a6a0e-8f0d-4f0e-9d55-6b1f0c1c7a52"), "no preset of this id")
export:set_name("song")
export:set_range(0, tonumber(frames))
assert(export:run_export(), "nothing exported")
io.stderr:write("exported\n")

close_session()
quit()
