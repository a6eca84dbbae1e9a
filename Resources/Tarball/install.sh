#!/bin/sh
# Installs Idiophone for the user who runs it, see README.txt.
set -eu
cd "$(dirname "$0")"
for format in vst3 lv2 clap; do
    [ -d lib/$format ] || continue
    mkdir -p "$HOME/.$format"
    for plugin in lib/$format/*; do
        rm -rf "$HOME/.$format/$(basename "$plugin")"
        cp -R "$plugin" "$HOME/.$format/"
    done
done
mkdir -p "$HOME/.local"
rm -rf "$HOME/.local/share/doc/idiophone"
cp -R bin share "$HOME/.local/"
echo "Installed to ~/.vst3, ~/.lv2 and ~/.local/bin."
