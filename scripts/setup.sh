# Sourced by the other scripts: installs the Debian or Ubuntu packages that are missing, and sets up
# what they share. Nothing else is downloaded.

set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q "install ok installed" ||
      missing+=("$package")
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "Installing ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
  "${as_root[@]}" apt-get update -q
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -q -y --no-install-recommends "${missing[@]}"
}

install_missing g++ cmake ninja-build ccache libcgal-dev libcgal-demo libeigen3-dev libtbb-dev \
  libboost-program-options-dev

export CMAKE_CXX_COMPILER_LAUNCHER=ccache

# CGAL's own data sets
export CGAL_DATA_DIR="$PWD/build/data"
if [ ! -d "$CGAL_DATA_DIR" ]; then
  mkdir -p build
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C build
fi

# A picture of point sets, see scripts/render_points.py, and the packages that it needs
render_packages=(python3-vtk9 python3-numpy python3-meshio xvfb xauth libgl1-mesa-dri)
render() {
  xvfb-run -a /usr/bin/python3 scripts/render_points.py "$@"
}
