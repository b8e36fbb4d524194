#!/usr/bin/env bash
# Builds everything with all warnings as errors and runs all tests.
#
#   scripts/test.sh [full]
#
# "full" adds what takes long: a build with clang, also of each internal header by itself, one with
# the newest CGAL that can be had from Debian, and the tests under the address and undefined behavior
# sanitizers.
set -euo pipefail
mode=${1:-quick}

. "$(dirname "$0")/setup.sh"
install_missing libgtest-dev libbenchmark-dev nlohmann-json3-dev

cmake --workflow --preset release
if [ "$mode" = full ]; then
  install_missing clang
  cmake --workflow --preset clang
  cmake --workflow --preset sanitize

  cgal=$(scripts/newest_cgal.sh build/newest_cgal)
  cmake --preset release -B build/release_newest_cgal "-DCGAL_DIR=$cgal"
  cmake --build build/release_newest_cgal
  ctest --test-dir build/release_newest_cgal --output-on-failure --no-tests=error
fi
