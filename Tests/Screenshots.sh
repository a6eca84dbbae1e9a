#!/usr/bin/env bash
# Looks at the window: starts the standalone on a screen of its own, clicks, types, drops a mesh,
# changes size and look, and saves what is seen.
#
#   Tests/Screenshots.sh OUTDIR [STANDALONE]
#
# Needs (Debian): xvfb xdotool imagemagick, and python3-xlib for $PYTHON (python3) to drop the mesh;
# with pulseaudio and libasound2-plugins there is a sound device, so that what is struck is seen to
# ring.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ $# -lt 1 ]; then
    sed -n '2,10s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2
    exit 2
fi
mkdir -p "$1"
out=$(cd "$1" && pwd)
build=build/${PRESET:-release}
standalone=${2:-$build/Source/Plugin/Idiophone_artefacts/Release/Standalone/Idiophone}
python=${PYTHON:-python3}
console=$build/Source/Console/idiophone

set -- "$out" "$standalone"
. Tests/window.sh
start_window "$standalone"

title=30 # of the window's own bar
size() { # width and height of what is below the title
    xdotool windowsize --sync "$window" "$1" $(($2 + title)) || true
    width=$1 height=$2
    sleep 1.5
}
click() { xdotool mousemove --window "$window" "$1" $(($2 + title)) click "${3:-1}"; sleep 0.25; }
shot() { import -window "$window" "$out/$1.png"; echo "$out/$1.png"; }
shot_with_menus() { # which are windows of their own
    import -window root -crop "${width}x$((height + title))+0+0" +repage "$out/$1.png"
    echo "$out/$1.png"
}
held() { # with the button down there for a while, a picture of that name
    xdotool mousemove --window "$window" "$1" $(($2 + title)) mousedown 1
    sleep 1
    shot "$3"
    xdotool mouseup 1
    sleep 0.25
}
drag() { # from x y to x y, with a picture of that name on the way
    local steps=12
    xdotool mousemove --window "$window" "$1" $(($2 + title)) mousedown 1
    for step in $(seq $steps); do
        xdotool mousemove --window "$window" $(($1 + ($3 - $1) * step / steps)) \
            $(($2 + ($4 - $2) * step / steps + title))
        sleep 0.04
    done
    [ -z "${5:-}" ] || shot "$5"
    xdotool mouseup 1
    sleep 0.25
}
other_look() { click $((width - 29)) 22; xdotool mousemove --window "$window" 200 $((title + 20)); sleep 0.5; }
for look in dark light; do
    for extent in "800 500" "1180 860" "1920 1080" "2500 1370"; do
        # shellcheck disable=SC2086
        size $extent
        shot "$look-$width-rest"
        # Strike what is in the picture, which in a low window is beside the pages.
        part=$((width < 1000 ? 48 : 33))
        xdotool mousemove --window "$window" $((width / 4)) $((height * part / 100 + title)) click 1
        shot "$look-$width-struck"
    done
    size 1180 860
    [ "$look" = light ] || other_look
done

# Places in the window of 1180 x 860.
nodal_lines() { click 124 56; }
browse() { click 505 22; sleep 0.5; }
choose() { # a preset by its name
    browse
    xdotool type "$1"
    sleep 0.5
    xdotool key Down Return
    sleep 1.5
}
draw_path() { click 262 56; }
strike_path() { click 216 56; }

for look in light dark; do
    size 1180 860
    browse
    xdotool type "wood bars"
    sleep 0.5
    shot "$look-browser"
    xdotool key Escape key Escape
    choose vibraphone
    size 1560 960
    for key in 300 700; do click "$key" 935; done
    held 1100 935 "$look-vibraphone" # while it rings
    size 1180 860
    choose handbell
    nodal_lines
    click 590 200
    shot "$look-handbell-nodes"
    nodal_lines
    drag 540 190 640 330 "$look-handbell-scraped"
    choose breathing
    click 823 374
    shot "$look-modulation"
    choose junkyard
    click 1013 374
    click 500 820 # a key, whose part is shown
    shot "$look-kit"
    click 160 374
    choose 'rosewood xylophone'
    other_look
done

# Bodies on a stage, in the air and as they roll.
size 1180 860
choose dice
for key in 300 500 700; do click "$key" 835; done
shot stage-dice
choose cylinder
click 187 56 # plays it
sleep 1
shot stage-cylinder
choose 'rosewood xylophone'

# Every factory preset.
next_preset() { click 701 22; sleep 2; }
for number in $(seq -w "$(find Presets -name '*.json' | wc -l)"); do
    shot "preset-$number"
    next_preset
done

# By keys alone: on from the picture to a knob of the Play page, and its menu.
click 590 240
# shellcheck disable=SC2046
xdotool key $(yes Tab | head -24)
sleep 0.3
xdotool key Up Up Up
sleep 0.3
shot light-focus
xdotool key shift+F10
sleep 0.5
shot_with_menus light-focus-menu
xdotool key Escape
click 900 620 3
sleep 0.5
shot_with_menus light-menu
xdotool key Escape

# The export of samples, of keys and in the smallest window.
samples() { click $((width - 276)) "$1"; sleep 2; }
samples 726
shot light-samples
samples 726
size 800 500
samples 411
shot light-samples-small
samples 411
size 1180 860

# A strike path drawn by hand over the steel plate.
choose 'steel plate'
draw_path
drag 380 250 800 300 light-path-drawing
shot light-path-drawn
draw_path
strike_path
choose 'rosewood xylophone'
other_look

# The form that makes a material from a recording, for a bowl.
click 267 374
click 737 465
click 900 467
xdotool key Up Up Return
sleep 0.5
shot dark-material-form
click 1118 577

# Files, dropped on the picture: a mesh.
"$console" mesh ring -o "$scratch/ring.obj" >/dev/null
if "$python" -c 'import Xlib' 2>/dev/null; then
    "$python" Tests/drop_file.py "$window" 400 300 "$scratch/ring.obj"
    sleep 1
    shot dropped-preview
    sleep 8
    click 400 250
    shot dropped

    # A scale, dropped too.
    printf '%s\n' 'Quarter-comma meantone' 12 76.049 193.157 310.265 5/4 503.422 579.471 696.578 \
        25/16 889.735 1006.843 1082.892 2/1 >"$scratch/meantone.scl"
    "$python" Tests/drop_file.py "$window" 400 300 "$scratch/meantone.scl"
    sleep 1
    shot tuning
    size 800 500
    shot tuning-small

    # The same vibraphone in other materials, as dropped presets.
    size 1180 860
    for material in Rosewood "Bell glass" "Bell bronze"; do
        preset="$scratch/Vibraphone of ${material,,}.json"
        sed "s/\"parameters\": {/&\n\"material\": \"$material\",/" \
            Presets/*-vibraphone.json >"$preset"
        "$python" Tests/drop_file.py "$window" 400 300 "$preset"
        sleep 2
        click 400 200
        shot "vibraphone-${material// /-}"
    done
fi

# A scaled window.
kill "$running"
wait "$running" || true
start_window "$standalone" scale=150
size 1770 1290
shot scale-150
size 1920 1080
shot scale-150-1920
echo "Saved in $out."
