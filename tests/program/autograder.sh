#!/usr/bin/env bash
# The archive for Gradescope, and its script at work in a directory that looks like Gradescope's.
# tests/grading/autograder_image.sh tries both in a whole image.
# Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/marking.sh
. "$(dirname "$0")/scratch/marking.sh"
begin_in "an image"
mkdir submission

cat >grading.json <<'END'
{"version": 1, "due": {"01": "2027-03-01T12:00:00Z"}, "late": [{"hours": 24, "percent": 50}]}
END
expect "it needs a name" 2 "autograder autograder.zip" "$course" autograder
expect "a chapter that there is not" 2 "no chapter '55'" "$course" autograder a.zip --chapter 55
expect "a place that there is not" 2 "nowhere/a.zip" "$course" autograder nowhere/a.zip --chapter 01
[ -z "$(find . -name '*.zip' -o -name '.course-*')" ] || fail "nothing is left of what was refused"

level=$(best_of user bwrap none)
expect "the archive is made" 0 "made autograder.zip: [0-9]+ files" \
    "$course" autograder autograder.zip --chapter 01 --seed 5 --rubric grading.json --isolation "$level"
unzip -q autograder.zip -d source

# ------------------------------------------------------------------------------------------- what is in it

cmp -s grading.json source/grading.json || fail "the rubric is in it"
for file in setup.sh run_autograder course/course; do
    [ -x "source/$file" ] || fail "$file can be run"
done
for file in CMakeLists.txt solutions/01_ray_casting/camera.cpp tests/01_ray_casting chapters/01_ray_casting/chapter.json; do
    [ -e "source/course/$file" ] || fail "$file is in it"
done
[ "$(find source/course -mindepth 1 -maxdepth 1 -printf '%f\n' | LC_ALL=C sort | tr '\n' ' ')" = \
    "CMakeLists.txt CMakePresets.json LICENSE chapters common course references solutions tests " ] ||
    fail "nothing else is in it" "$(ls -A source/course)"
bash -n source/setup.sh
grep -q -- "--prepare --chapter 01" source/setup.sh || fail "setup.sh builds what is marked"

# ----------------------------------------------------------------------------------------------- it marks

# What setup.sh would have built is there already.
rm -rf source/course
mkdir -p source/course/build/bin
ln -s "$course" source/course/build/bin/course
marked() { AUTOGRADER_PLACE=$PWD source/run_autograder >said 2>&1 || fail "run_autograder ends well" "$(cat said)"; }
results() { jsonschema -i results/results.json "$COURSE_ROOT/tests/grading/schemas/gradescope.schema.json" ||
    fail "$1: results.json is as Gradescope wants it" "$(cat results/results.json)"; }
sum() { grep -oE '"score": [0-9.]+' results/results.json | awk '{ sum += $2 } END { print sum + 0 }'; }

cp "$COURSE_ROOT"/solutions/01_ray_casting/*.cpp submission
marked
results "all solved"
[ "$(sum)" = 80 ] || fail "what is solved has all 70 points, and 10 for the optional step" "$(cat said results/results.json)"
[ "$(stat -c %A source | cut -c 5-)" = "------" ] || fail "others cannot get at the tree"

echo '{"created_at": "2027-03-01T13:00:00.25+00:00"}' >submission_metadata.json
marked
[ "$(sum)" = 40 ] || fail "late work has what the rubric leaves" "$(cat said results/results.json)"

rm submission/*
echo "notes" >submission/notes.txt
marked
results "nothing to mark"
grep -q "has no exercises" results/results.json || fail "the student is told what is missing" "$(cat results/results.json)"
[ "$(sum)" = 0 ] || fail "no points for nothing"

# Whatever the grader's own fault is, there are results, and the student reads nothing of this machine.
cp "$COURSE_ROOT"/solutions/01_ray_casting/*.cpp submission
echo "{" >source/grading.json
marked
results "the grader fails"
[ "$(sum)" = 0 ] || fail "no points when the grader fails"
grep -q "could not mark this" results/results.json || fail "the student is told so" "$(cat results/results.json)"
grep -q "grading.json:[0-9]" said || fail "the instructor reads why" "$(cat said)"
! grep -q "$COURSE_BUILD\|grading.json" results/results.json || fail "the student reads nothing of the machine"
rm source/course/build/bin/course
marked
results "there is no program"

end_there
