#!/usr/bin/env bash
# Makes the page, the gallery and the manual as static files: make_site.sh BUILD, the folder with
# instrument.wasm (build/web). Writes BUILD/site, and fetches what this needs from npm into BUILD/npm.
# The environment's SOURCE_URL is the public address of these sources. A published page links to it, as
# section 13 of the AGPL asks.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
site=$build/site

"$source/Source/Browser/make_package.sh" "$build"
mkdir -p "$build/npm"
cp "$source"/Source/Browser/{make_manual.mjs,page/package*.json} "$build/npm"
(cd "$build/npm" && npm ci --silent --no-audit --no-fund)

rm -rf "$site"
mkdir -p "$site/songs"
cp -r "$source"/Source/Browser/page/. "$site"
rm "$site"/package*.json
[ -z "${SOURCE_URL:-}" ] ||
    sed -i "s|.*rel=\"license\".*|&\n        <a href=\"$SOURCE_URL\">Source</a>|" "$site/index.html"
cp -r "$build/package" "$site/idiophone"
cp "$source"/Resources/Songs/*.mid "$site/songs"
cp "$source"/Resources/{Materials/materials,Mallets/mallets}.json "$site"
cp -r "$source/Resources/Shaders" "$site/shaders"
cp "$source"/Resources/Desktop/*.svg "$site/icon.svg"
mkdir "$site/three" "$site/midifile-ts"
cp "$build"/npm/node_modules/three/{LICENSE,build/three.{core,module}.min.js} "$site/three"
cp "$build"/npm/node_modules/midifile-ts/{LICENSE,dist/index.js} "$site/midifile-ts"

node "$build/npm/make_manual.mjs" "$source" "$site"
for sound in "$site"/manual/sounds/presets/*.ogg; do # for Safari before 18.4
    sndfile-convert "$sound" "${sound%.ogg}.mp3"
done
