#!/usr/bin/env bash
# The command-line tool: formats, options, and one clear line for everything that can go wrong.
#
#   test_tool.sh PATH_OF_simplify_point_set
set -u
tool=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
failures=0

fail() {
  echo "FAILED: $*"
  failures=$((failures + 1))
}

# must_fail PATTERN ARGUMENT...: non-zero exit, one line that matches, and no new file
must_fail() {
  local pattern=$1 before after
  shift
  before=$(ls -A)
  if "$tool" "$@" >stdout.log 2>stderr.log; then fail "no error for: $*"; fi
  mv stdout.log stderr.log "$folder.logs/"
  after=$(ls -A)
  [ "$before" = "$after" ] || fail "files are left behind by: $*: $after"
  [ "$(wc -l <"$folder.logs/stderr.log")" -eq 1 ] || fail "not one line for: $*"
  grep -qE -- "$pattern" "$folder.logs/stderr.log" ||
    fail "'$(cat "$folder.logs/stderr.log")' does not match '$pattern' for: $*"
}
mkdir "$folder.logs"
trap 'rm -rf "$folder" "$folder.logs"' EXIT

# a wavy patch of 10,000 points
awk 'BEGIN { for (i = 0; i < 100; ++i) for (j = 0; j < 100; ++j)
  print i / 100, j / 100, 0.1 * sin(i / 10) * cos(j / 10) }' >patch.xyz

for format in ply xyz off; do
  "$tool" -q patch.xyz "out.$format" || fail "cannot write $format"
  "$tool" -q --subset -n 500 "out.$format" "again.$format" || fail "cannot read $format"
done
[ "$(wc -l <out.xyz)" -eq 500 ] || fail "not 5 % of 10,000 points"
[ "$(sed -n 2p out.off)" = "500 0 0" ] || fail "not 500 points in the off file"
grep -aq "element vertex 500" out.ply || fail "not 500 points in the ply file"
cmp -s out.xyz again.xyz || fail "a file that is read and written is not the same"

"$tool" -q -n 77 patch.xyz count.xyz && [ "$(wc -l <count.xyz)" -eq 77 ] || fail "--count"
"$tool" -q -p 1.5 patch.xyz count.xyz && [ "$(wc -l <count.xyz)" -eq 150 ] || fail "--percentage"
"$tool" -q -s 1 patch.xyz seed1.xyz
"$tool" -q -s 1 patch.xyz seed2.xyz
cmp -s seed1.xyz seed2.xyz || fail "the same seed gives different results"
cmp -s seed1.xyz out.xyz && fail "another seed gives the same result"
for option in "-i 3" "-a 0" "--paper"; do
  # shellcheck disable=SC2086
  "$tool" -q $option patch.xyz changed.xyz || fail "$option"
  cmp -s changed.xyz out.xyz && fail "no effect of $option"
done
"$tool" -q --paper patch.xyz paper.xyz
for option in "-r 0.3" "-d 0" "-w 0.1" "-k 40"; do
  # shellcheck disable=SC2086
  "$tool" -q --paper $option patch.xyz changed.xyz || fail "$option"
  cmp -s changed.xyz paper.xyz && fail "no effect of $option"
done

# extensions in capitals, links and permissions
cp patch.xyz PATCH.XYZ
"$tool" -q PATCH.XYZ capitals.PLY && cmp -s capitals.PLY out.ply || fail "extensions in capitals"
mkdir elsewhere
echo old >elsewhere/target.xyz
chmod 600 elsewhere/target.xyz
ln -s elsewhere/target.xyz link.xyz
"$tool" -q patch.xyz link.xyz
[ -L link.xyz ] && cmp -s elsewhere/target.xyz out.xyz || fail "what a link leads to is not replaced"
ln -s elsewhere/new.xyz dangling.xyz
"$tool" -q patch.xyz dangling.xyz
[ -L dangling.xyz ] && cmp -s elsewhere/new.xyz out.xyz || fail "what a link leads to is not made"
[ "$(ls -l elsewhere/target.xyz | cut -c 1-10)" = "-rw-------" ] || fail "a file loses its permissions"

# attributes of a subset
awk '{ print $0, 0, 0, 1 }' patch.xyz >normals.xyz
"$tool" normals.xyz moved.xyz | grep -q "^left out   normal; .*--subset" ||
  fail "normals are left out without a word"
"$tool" --subset normals.xyz subset.xyz | grep -q "left out" && fail "--subset leaves something out"
"$tool" -q --subset normals.xyz subset.xyz
[ "$(grep -cE " 0 0 1$" subset.xyz)" -eq 500 ] || fail "--subset loses normals"

"$tool" patch.xyz out.ply >stdout.log 2>stderr.log || fail "with output"
for word in "points *10000" "returned *500" "spacing *0\.0" "noise *[0-9]" "outliers *0" "sorting .* s" "features .* s" \
  "selection .* s" "relaxation .* s" "projection .* s"; do
  grep -qE "$word" stdout.log || fail "no '$word' in the output"
done
[ ! -s stderr.log ] || fail "a progress bar that is not on a terminal"
# in a terminal, where one can be had
if script -qec true /dev/null </dev/null >/dev/null 2>&1; then
  script -qec "$tool patch.xyz out.ply" /dev/null </dev/null | grep -q "100 %" || fail "no progress bar"
fi
"$tool" --help | grep -q "Usage" || fail "--help"
rm stdout.log stderr.log

printf 'OFF\n0 0 0\n' >empty.off
printf '1 2 3\n4 five 6\n' >broken.xyz
printf 'not a ply file\n' >broken.ply
head -c 3000 out.ply >short.ply
mkdir folder.ply
must_fail 'radius needs --paper' -r 0.3 patch.xyz new.ply
must_fail 'radius needs --paper without --subset' --paper --subset -r 0.3 patch.xyz new.ply
must_fail 'curvature-dependence needs --paper' --subset -d 1 patch.xyz new.ply
must_fail 'curvature-weight needs --paper or --subset' -w 0.5 patch.xyz new.ply
must_fail 'iterations needs points that move' --subset -i 5 patch.xyz new.ply
must_fail "cannot open missing.ply" missing.ply out.xyz
must_fail "cannot open folder.ply" folder.ply out.xyz
must_fail "empty.off holds no points" empty.off out.xyz
must_fail "cannot read broken.xyz" broken.xyz new.xyz
must_fail "cannot read broken.ply" broken.ply new.xyz
must_fail "cannot read short.ply" short.ply new.xyz
must_fail "unknown format 'abc'" patch.abc new.xyz
must_fail "cannot write new.abc: unknown format 'abc'" patch.xyz new.abc
must_fail "cannot write nowhere/new.xyz: no folder" patch.xyz nowhere/new.xyz
must_fail "cannot write folder.ply: it is a folder" patch.xyz folder.ply
must_fail "unrecognised option '--colour'; see .*--help" --colour patch.xyz new.xyz
must_fail "'--output' is required" patch.xyz
must_fail "too many positional" patch.xyz new.xyz third.xyz
must_fail "the argument .*many.* is invalid" -n many patch.xyz new.xyz
must_fail "select_percentage is 0, but must be above 0 and at most 100" -p 0 patch.xyz new.xyz
must_fail "number_of_output_points is -3, but must be" -n -3 patch.xyz new.xyz
must_fail "number_of_output_points is 10001, but must be .* 10000" -n 10001 patch.xyz new.xyz
must_fail "neighbor_radius is 0, but must be above 0" --paper -r 0 patch.xyz new.xyz
must_fail "number_of_iterations is -1" -i -1 patch.xyz new.xyz
must_fail "number_of_neighbors is 1, but must be" -k 1 patch.xyz new.xyz

# a full disk: nothing is left, and an older file stays
if [ "$(uname)" = Linux ]; then
  cp out.xyz kept.xyz
  (
    ulimit -f 10 # blocks; the file has about 30
    trap "" XFSZ
    failures=0
    must_fail "cannot write kept.xyz" patch.xyz kept.xyz
    exit "$failures"
  ) || fail "in a full disk"
  cmp -s out.xyz kept.xyz || fail "a failed run destroys the older output"
fi

[ "$failures" -eq 0 ] && echo "all tests of the tool passed"
exit "$failures"
