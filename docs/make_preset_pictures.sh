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
set -- "$standalone" "$console"
. Tests/window.sh
start_window "$standalone" look=dark width=944 height=1380
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
key=(760 1300) picture=918x612+17+102 next=(586 52)
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
