#!/usr/bin/env bash
# Simplifies a point set file and draws it before and after.
#
#   scripts/example.sh [INPUT [OUTPUT]]
#
# Without arguments, an elephant of 44,460 points from CGAL's data becomes 4,000 points in output/.
set -euo pipefail
input=$(realpath "${1:-/dev/null}")
output=$(realpath -m "${2:-$(dirname "$0")/../output/simplified.ply}")

. "$(dirname "$0")/setup.sh"
install_missing "${render_packages[@]}"

cmake --preset release -DBUILD_TESTING=OFF -DCURVATURE_AWARE_SIMPLIFICATION_3_BENCHMARKS=OFF \
  -B build/example >/dev/null
cmake --build build/example --target simplify_point_set

options=()
if [ $# -eq 0 ]; then
  input=$CGAL_DATA_DIR/meshes/refined_elephant.off
  options=(--count 4000)
fi
mkdir -p "$(dirname "$output")"
build/example/examples/Curvature_aware_simplification_3/simplify_point_set "${options[@]}" \
  "$input" "$output"
render "$input" "$input=before" "$output=after" --output "${output%.*}.png"
echo "The simplified points are in $output, a picture in ${output%.*}.png"
