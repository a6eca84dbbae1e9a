#!/usr/bin/env bash
# Tries a tarball of Idiophone in a fresh root of a distribution: no library is missing, the console renders the
# factory song, and pedalboard plays a note on the VST3. Needs root, debootstrap and python3-pip.
#
#     in_root.sh TARBALL SUITE MIRROR [COMPONENTS [KEYRING]]
#
# The root stays in $ROOTS/SUITE (/var/tmp/idiophone-roots) for the next time.
set -euo pipefail

tarball=$(realpath "$1") suite=$2 mirror=$3 components=${4:-main}
keyring=${5:+--keyring=$5}
root=${ROOTS:-/var/tmp/idiophone-roots}/$suite
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
in_root() { chroot "$root" "$@"; }

if [ ! -e "$root/ready" ]; then
    mkdir -p "$root"
    # shellcheck disable=SC2086
    debootstrap --variant=minbase --components="$components" $keyring \
        --include=libatomic1,libfontconfig1,libfreetype6,libgl1,libsndfile1,libx11-6,libxcursor1,libxext6,libxinerama1,libxrandr2,python3-venv \
        "$suite" "$root" "$mirror"
    # Some distributions call it libasound2t64.
    in_root sh -c 'apt-get install -qy --no-install-recommends libasound2t64 || apt-get install -qy libasound2'
    # The root may know no certificates, so the machine's pip downloads.
    python=$(in_root python3 -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    pip download --quiet --only-binary :all: --python-version "$python" --dest "$root/wheels" \
        "$(grep '^pedalboard==' "$here/../Integration/requirements.txt")" mido
    in_root python3 -m venv /venv
    in_root sh -c '/venv/bin/pip install --quiet --no-index /wheels/*.whl'
    touch "$root/ready"
fi

rm -rf "$root/idiophone" "$root/home"
mkdir -p "$root/idiophone" "$root/home"
tar --extract --file "$tarball" --directory "$root/idiophone" --strip-components 1
in_root env HOME=/home /idiophone/install.sh

find "$root/home" \( -name '*.so' -o -path '*/bin/*' \) -printf '/home/%P\n' | while read -r program; do
    if in_root ldd "$program" | grep 'not found'; then
        echo "$suite: a library of $program is missing" >&2
        exit 1
    fi
done
in_root env HOME=/home /home/.local/bin/idiophone render --preset "Rosewood Xylophone" -o /home/song.wav \
    --midi /home/.local/share/doc/idiophone/examples/TheEntertainer.mid
in_root env HOME=/home /venv/bin/python - <<'PYTHON'
import mido
import pedalboard
plugin = pedalboard.load_plugin("/home/.vst3/Idiophone.vst3")
sound = plugin([mido.Message("note_on", note=72, velocity=100, time=0)], 0.5, 48000)
assert abs(sound).max() > 0.001
PYTHON
sha256sum "$root/home/song.wav"
