#!/usr/bin/env bash
# Installs the package and uses it from outside, in the ways that are known to go wrong: a consumer
# that names CGAL first, with a CGAL that is not in /usr, and a prefix shared with CGAL.
#
#   test_install.sh BUILD_FOLDER CGAL_INCLUDE_FOLDER CGAL_CMAKE_FOLDER CXX_COMPILER
set -euo pipefail
build=$(realpath "$1")
cgal_include=$2
cgal_cmake=$3
export CXX=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
prefix=$folder/prefix

# a CGAL of its own, in the prefix into which the package goes
mkdir -p "$prefix/include" "$prefix/lib/cmake"
cp -r "$cgal_include/CGAL" "$prefix/include/"
cp -r "$cgal_cmake" "$prefix/lib/cmake/CGAL"
parameters=$prefix/include/CGAL/STL_Extension/internal/parameters_interface.h
before=$(cksum <"$parameters")
cmake --install "$build" --prefix "$prefix" >/dev/null
[ "$before" = "$(cksum <"$parameters")" ] || { echo "CGAL's file was overwritten"; exit 1; }

mkdir "$folder/consumer"
cd "$folder/consumer"
cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(consumer CXX)
find_package(CGAL REQUIRED)
find_package(Curvature_aware_simplification_3 0.1 REQUIRED)
add_executable(consumer consumer.cpp)
target_link_libraries(consumer PRIVATE CGAL::CGAL
                      Curvature_aware_simplification_3::Curvature_aware_simplification_3)
END
cat >consumer.cpp <<'END'
#include <CGAL/Simple_cartesian.h>
#include <CGAL/curvature_aware_simplify_point_set.h>
#include <iterator>
#include <vector>
int main()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  std::vector<Point> points, output;
  for (int i = 0; i < 1000; ++i)
    points.emplace_back(i % 32, i / 32, 0);
  CGAL::curvature_aware_simplify_point_set<CGAL::Sequential_tag>(
      points, std::back_inserter(output),
      CGAL::parameters::select_percentage(7).curvature_dependence(2.).random_seed(1));
  return output.size() == 70 ? 0 : 1;
}
END
cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" \
  -DCGAL_DIR="$prefix/lib/cmake/CGAL" >configure.log 2>&1 || { cat configure.log; exit 1; }
cmake --build build -- -v >build.log 2>&1 || { cat build.log; exit 1; }
grep -q -- "-isystem $prefix/include " build.log || { echo "CGAL was not taken from the prefix"; cat build.log; exit 1; }
build/consumer
echo "installed, found and used"
