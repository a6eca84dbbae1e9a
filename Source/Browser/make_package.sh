#!/usr/bin/env bash
# Makes the npm package: make_package.sh BUILD, the folder with instrument.wasm (build/web). Writes
# BUILD/package and packs it as BUILD/idiophone-VERSION.tgz. The module without SIMD is part of it if it
# has been built in BUILD-scalar.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
package=$build/package
version=$(sed -n 's/^project(Idiophone VERSION \([0-9.]*\).*/\1/p' "$source/CMakeLists.txt")

rm -rf "$package"
mkdir -p "$package"
cp -r "$source"/Source/Browser/package/. "$source"/LICENSE* "$source"/THIRD-PARTY* "$package"
cp "$build/instrument.wasm" "$package"
[ ! -f "$build-scalar/instrument-scalar.wasm" ] || cp "$build-scalar/instrument-scalar.wasm" "$package"
cp -r "$source/Resources/Objects" "$package/objects"
(cd "$package/objects" && printf '%s\n' *.modal) |
    python3 -c 'import json, sys; print(json.dumps([line.removesuffix(".modal\n") for line in sys.stdin]))' \
        > "$package/objects.json"
sed -i "s/\"version\": \"0.0.0\"/\"version\": \"$version\"/" "$package/package.json"
cd "$build" && npm pack --silent "$package"
