#!/usr/bin/env bash
# The pictures in the preset browser: steps through the factory presets in the window, and keeps a
# small picture of each instrument. Needs xvfb, xdotool, imagemagick, pulseaudio and libasound2-plugins
# (Debian). Sound sets the bodies of a scene in motion; their places depend on the time. The other
# pictures repeat byte by byte.
#
#   docs/make_preset_pictures.sh [STANDALONE [CONSOLE]]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

build=build/${PRESET:-release}/Source
standalone=${1:-$build/Plugin/Idiophone_artefacts/Release/Standalone/Idiophone}
console=${2:-$build/Console/idiophone}
if [ -z "${IDIOPHONE_SCREEN:-}" ]; then
    export IDIOPHONE_SCREEN=1
    exec xvfb-run -a -s "-screen 0 1600x1440x24 +extension GLX" "$0" "$standalone" "$console"
fi

scratch=$(mktemp -d)
trap 'kill $(jobs -p) 2>/dev/null || true; pulseaudio --kill 2>/dev/null || true; rm -rf "$scratch"' EXIT
export HOME=$scratch XDG_CONFIG_HOME=$scratch XDG_RUNTIME_DIR=$scratch
mkdir "$scratch/Idiophone"
cat >"$scratch/Idiophone/Window.settings" <<'SETTINGS'
<?xml version="1.0" encoding="UTF-8"?>
<PROPERTIES>
  <VALUE name="look" val="dark"/>
  <VALUE name="width" val="944"/>
  <VALUE name="height" val="1380"/>
  <VALUE name="playOnSelection" val="0"/>
</PROPERTIES>
SETTINGS
mkdir "$scratch/pulse"
printf '%s\n' 'pcm.!default { type pulse hint { show on description "Default" } }' \
    'ctl.!default { type pulse }' >"$scratch/.asoundrc"
pulseaudio --start --exit-idle-time=-1 -n -L module-null-sink -L module-native-protocol-unix 2>/dev/null
"$standalone" 2>/dev/null &
window=
for _ in $(seq 100); do
    window=$(xdotool search --onlyvisible --name '^Idiophone$' 2>/dev/null | head -1) && [ -n "$window" ] && break
    sleep 0.2
done
[ -n "$window" ] || { echo "The window did not open." >&2; exit 1; }
xdotool windowmove "$window" 0 0
xdotool mousemove 600 15
sleep 4

settle() { # waits until the window has not changed for two seconds; on a busy machine it comes late
    local last="" now
    for _ in $(seq 30); do
        now=$(import -window "$window" rgb:- | cksum)
        [ "$now" != "$last" ] || return 0
        last=$now
        sleep 2
    done
}

mkdir -p Resources/Pictures
rm -f Resources/Pictures/*.png
# Places in the window of 944 x 1380: a key of every scene, the picture, the arrow to the next preset.
key=(760 1300) picture=918x612+17+102 next=(615 52)
"$console" presets --json | python3 -c '
import json, re, sys
for preset in json.load(sys.stdin):
    print(re.sub("[^a-z0-9]", "-", preset["name"].lower()), preset["keyMap"]["kind"])' |
while read -r name kind; do
    settle
    [ "$kind" != scene ] || { xdotool mousemove --window "$window" "${key[@]}" click 1; sleep 0.5; }
    import -window "$window" "$scratch/window.png"
    convert "$scratch/window.png" -crop "$picture" +repage -resize 192x128 -colors 64 -strip \
        "PNG8:Resources/Pictures/$name.png"
    xdotool mousemove --window "$window" "${next[@]}" click 1 mousemove 600 15
    sleep 3
done
