#!/usr/bin/env bash
# The pictures of the README and the manual, from the window itself: Tests/Screenshots.sh says what
# that needs.
#
#   docs/make_pictures.sh [STANDALONE]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

shots=$(mktemp -d)
trap 'rm -rf "$shots"' EXIT
Tests/Screenshots.sh "$shots" "$@"

mkdir -p docs/manual/images
keep() { convert "$shots/$1.png" -strip "docs/$2.png"; }
keep light-vibraphone images/standalone
keep vibraphone-Bell-glass images/glass-vibraphone
keep light-modulation manual/images/modulation
keep light-kit manual/images/kit
keep light-browser manual/images/browser
keep dark-material-form manual/images/material-form
keep dropped manual/images/dropped
keep stage-dice manual/images/scene
