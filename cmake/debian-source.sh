#!/usr/bin/env bash
# Unpacks one pinned Debian package, signature checked, without touching the machine's own apt
# sources. Used by DebianSource.cmake; the mirror is read from the machine's apt settings.
#   debian-source.sh PACKAGE VERSION SUITE DESTINATION [FOLDER_TO_KEEP | --archives | --original | --binary]
# --archives downloads the archives of the source package without unpacking them. --original unpacks the
# upstream archive without Debian's changes. --binary unpacks the binary package into
# DESTINATION/PACKAGE-VERSION.
set -euo pipefail
package=$1 version=$2 suite=$3 destination=$4 keep=${5:-}
upstream=${version%-*}
upstream=${upstream#*:} # names of files have no epoch
# shellcheck disable=SC1091
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
# shellcheck disable=SC2016
mirror=$(apt-get indextargets --format '$(REPO_URI) $(RELEASE)' 'Created-By: Packages' |
    awk -v release="$release" '$2 == release { print $1; exit }')
[ -n "$mirror" ] || { echo "apt knows no mirror of $release; run apt-get update first" >&2; exit 1; }

kind=deb-src lists=Sources work=$destination/apt-$suite
[ "$keep" != --binary ] || { kind=deb lists=Packages work=$work-binary; }
[ "$package" = "${package%:*}" ] || work=$work-${package#*:} # a processor's packages have lists of their own
mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
echo "$kind [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" \
    > "$work/sources.list"
apt=(apt-get -qq -o "Dir::Etc::sourcelist=$work/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$work/lists" -o "Dir::Cache=$work/cache" -o APT::Sandbox::User=root)

cd "$destination"
[ -n "$(find "$work/lists" -name "*$lists*" -print -quit)" ] || "${apt[@]}" update
if [ "$keep" = --archives ]; then
    # Some mirrors serve the archives of a package but not its description.
    "${apt[@]}" source --download-only "$package=$version" || true
elif [ "$keep" = --original ]; then
    rm -rf "$package-$upstream"
    "${apt[@]}" source --download-only "$package=$version" || true # as above
    mkdir "$package-$upstream.partial"
    tar --extract --file "${package}_$upstream".orig.tar.* --strip-components 1 \
        --directory "$package-$upstream.partial"
    mv "$package-$upstream.partial" "$package-$upstream"
    rm -f "${package}_"*
elif [ "$keep" = --binary ]; then
    # The star stands for Debian's rebuilds of a version (+b1): processors have others.
    "${apt[@]}" download "$package=$version*"
    rm -rf "$package-$version.partial"
    dpkg-deb --extract "${package%:*}_"*.deb "$package-$version.partial"
    mv "$package-$version.partial" "$package-$version"
    rm -f "${package%:*}_"*.deb
else
    # In a folder of its own, so that an interrupted call leaves none that looks complete.
    rm -rf "$work/unpacked"
    mkdir "$work/unpacked"
    cd "$work/unpacked"
    "${apt[@]}" source "$package=$version"
    if [ -n "$keep" ]; then
        find "$package-$upstream" -type f -not -path "*/$keep/*" -delete
        find "$package-$upstream" -type d -empty -delete
    fi
    mv "$package-$upstream" "$destination"
    rm -r "$work/unpacked"
fi
