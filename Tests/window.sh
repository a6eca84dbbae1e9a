# For scripts that look at the window; source it from the project's folder. Starts the standalone
# with settings of its own, on a screen of its own (xvfb, xdotool, imagemagick). With pulseaudio and
# libasound2-plugins there is a sound device.

for tool in Xvfb xvfb-run xdotool import; do
    command -v "$tool" >/dev/null || { echo "$tool is missing: see the head of this script." >&2; exit 2; }
done
# On a screen of our own, once. The arguments start the script again.
if [ -z "${IDIOPHONE_SCREEN:-}" ]; then
    export IDIOPHONE_SCREEN=1
    exec xvfb-run -a -s "-screen 0 2560x1440x24 +extension GLX" "$0" "$@"
fi

scratch=$(mktemp -d)
running=
stop() {
    [ -z "$running" ] || kill "$running" 2>/dev/null || true
    [ ! -d "$scratch/pulse" ] || pulseaudio --kill 2>/dev/null || true
    rm -rf "$scratch"
}
trap stop EXIT
export XDG_CONFIG_HOME=$scratch/config XDG_RUNTIME_DIR=$scratch HOME=$scratch
mkdir -p "$XDG_CONFIG_HOME/Idiophone"
if command -v pulseaudio >/dev/null; then
    mkdir "$scratch/pulse"
    printf '%s\n' 'pcm.!default { type pulse hint { show on description "Default" } }' \
        'ctl.!default { type pulse }' >"$HOME/.asoundrc"
    pulseaudio --start --exit-idle-time=-1 -n -L "module-null-sink" \
        -L "module-native-protocol-unix" 2>/dev/null || true
fi

# Starts $1 and sets `window` and `running`. The other arguments are settings, such as scale=150.
# Selected presets play no phrase, which would be seen to ring; the first hints have been seen.
start_window() {
    {
        echo '<PROPERTIES>'
        for setting in playOnSelection=0 hintsSeen=1 "${@:2}"; do
            echo "<VALUE name=\"${setting%%=*}\" val=\"${setting#*=}\"/>"
        done
        echo '</PROPERTIES>'
    } >"$XDG_CONFIG_HOME/Idiophone/Window.settings"
    "$1" 2>/dev/null &
    running=$!
    window=
    for _ in $(seq 100); do
        window=$(xdotool search --onlyvisible --name '^Idiophone$' 2>/dev/null | head -1) && [ -n "$window" ] && break
        sleep 0.2
    done
    [ -n "$window" ] || { echo "The window did not open." >&2; exit 1; }
    sleep 3
    xdotool windowmove "$window" 0 0
}
