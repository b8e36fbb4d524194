#!/usr/bin/env bash
# Compares this package with all peers, and writes the page with the results.
#
#   scripts/benchmark.sh [quick|igea|shapes|full [OPTION...]]
#
# quick: a torus in three conditions, no search for settings, no external programs; under 5 minutes
#   on two cores.
# igea: the model of the paper's Table 1, igea.ply in the folder given with --shared, in six
#   conditions; cost, what each idea is worth, tables and figures of the paper; an hour and more.
# shapes: twelve shapes in seven conditions against CGAL's functions and what is built here; no
#   external programs, no times; an hour and a half. The page is results/shapes.md.
# full: as igea, with an elephant and five analytic surfaces as well; several hours.
# Options are those of benchmark.py: after a change of this package, --rerun "this package" takes the
# results of the others from the last run.
set -euo pipefail
mode=${1:-quick}
shift || true

. "$(dirname "$0")/setup.sh"
install_missing libbenchmark-dev nlohmann-json3-dev python3-matplotlib python3-pil "${render_packages[@]}"
if [ "$mode" = igea ] || [ "$mode" = full ]; then
  # external programs: what cannot be installed is reported as missing in its row
  while read -r package; do
    install_missing "$package" || echo "$package cannot be installed"
  done < <(sed 's/#.*//' scripts/external_packages.txt | grep -v '^ *$')
fi

cmake --preset release -DBUILD_TESTING=OFF -B build/benchmark >/dev/null
cmake --build build/benchmark --target simplify_and_measure kernels measure_scaling compare_with_wlop
output=benchmark/Curvature_aware_simplification_3/results
if [ "$mode" = quick ]; then output=build/benchmark/results; fi
/usr/bin/python3 benchmark/Curvature_aware_simplification_3/benchmark.py "$mode" \
  --build build/benchmark/benchmark/Curvature_aware_simplification_3 \
  --meshes "$CGAL_DATA_DIR/meshes" --output "$output" "$@"
