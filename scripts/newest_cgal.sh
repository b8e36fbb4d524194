#!/usr/bin/env bash
# Unpacks the CGAL of a newer Debian release into a folder and prints the folder of its CMake
# configuration. CGAL consists of headers only, so that it needs nothing else of that release.
#
#   scripts/newest_cgal.sh FOLDER [RELEASE]
set -euo pipefail
folder=$(realpath -m "$1")
release=${2:-testing}

mkdir -p "$folder/lists/partial"
cd "$folder"
if ! compgen -G "libcgal-dev_*.deb" >/dev/null; then
  mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | head -n 1)
  echo "deb $mirror $release main" >sources.list
  options=(-q -o "Dir::Etc::sourcelist=$folder/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$folder/lists" -o APT::Default-Release= -o APT::Sandbox::User=root)
  apt-get "${options[@]}" update >&2
  apt-get "${options[@]}" download libcgal-dev >&2
fi
dpkg -x libcgal-dev_*.deb .
dirname "$(find "$folder/usr" -name CGALConfig.cmake)"
