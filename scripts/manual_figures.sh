#!/usr/bin/env bash
# Makes the figures of the manual anew, from the models of CGAL's data.
#
#   scripts/manual_figures.sh
set -euo pipefail
. "$(dirname "$0")/setup.sh"
install_missing nlohmann-json3-dev "${render_packages[@]}" # the first for simplify_and_measure

figures=doc/Curvature_aware_simplification_3/fig
meshes=$CGAL_DATA_DIR/meshes
files=build/manual_figures
mkdir -p "$files"

scripts/example.sh
cp output/simplified.png "$figures/elephant.png"

cmake --preset release -DBUILD_TESTING=OFF -B build/benchmark >/dev/null
cmake --build build/benchmark --target simplify_and_measure
measure() {
  build/benchmark/benchmark/Curvature_aware_simplification_3/simplify_and_measure --seed 1 "$@" >/dev/null
}

fandisk=(--input "$meshes/fandisk.off" --sample 40000 --count 1500)
measure "${fandisk[@]}" --parameters adaptivity=0 --write "$files/uniform.ply"
measure "${fandisk[@]}" --method "this package" --defaults-only --write "$files/default.ply"
measure "${fandisk[@]}" --parameters adaptivity=1 --write "$files/adaptive.ply"
render "$meshes/fandisk.off" "$files/uniform.ply=adaptivity 0" "$files/default.ply=2/3, the default" \
  "$files/adaptive.ply=1" --direction 0.5 0.8 1 --size 480 --output "$figures/adaptivity.png"

hand=(--input "$meshes/hand.off" --sample 40000 --degradation noise:0.5+outliers:5 --count 4000)
measure "${hand[@]}" --write-input "$files/scan.ply"
measure "${hand[@]}" --method "this package" --defaults-only --write "$files/simplified.ply"
measure "${hand[@]}" --method "CGAL WLOP" --defaults-only --write "$files/wlop.ply"
render "$meshes/hand.off" "$files/scan.ply=42,000 points" \
  "$files/simplified.ply=4,000 by this package" "$files/wlop.ply=4,000 by CGAL WLOP" --size 480 \
  --output "$figures/noise_and_outliers.png"
