#!/usr/bin/env bash
# A small class marked from the command line, as an instructor does it.
# Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/marking.sh
. "$(dirname "$0")/scratch/marking.sh"
begin_in "marked class"

# Three students: all of chapter 1, its optional step, which counts beside the 70 points, included; its camera alone; and
# nothing at all.
for student in ada ben cleo; do
    mkdir -p "submissions/$student/chapters"
    cp -R "$COURSE_ROOT/chapters/01_ray_casting" "submissions/$student/chapters"
done
cp "$COURSE_ROOT"/solutions/01_ray_casting/*.cpp submissions/ada/chapters/01_ray_casting
cp "$COURSE_ROOT"/solutions/01_ray_casting/camera.cpp submissions/ben/chapters/01_ray_casting

expect "a level that there is not" 2 "bwrap, user" "$course" grade submissions/ada --isolation moon
expect "a format that there is not" 2 "csv" "$course" grade submissions/ada --format moon
expect "a submission that there is not" 2 "submissions/dan: No such file" "$course" grade submissions/dan
expect "a rubric that is none" 2 "rubric.json:1:1" bash -c "echo moon >rubric.json; '$course' grade submissions/ada --rubric rubric.json"
expect "the same name twice" 2 "two submissions of the same name" "$course" grade submissions/ada submissions/../submissions/ada
expect "an engine that there is not" 2 "parallel or slurm" "$course" grade submissions/ada --on moon
expect "parts without an engine" 2 "--on" "$course" grade submissions/ada --parts 3
expect "no script for a submission that there is not" 2 "submissions/dan: No such file" \
    "$course" grade submissions/dan --on slurm
expect "a script has all that was asked for in it" 0 "grade --chapter 01 --seed 5 --isolation none --part .*/2" \
    "$course" grade submissions/* --seed 5 --isolation none --chapter 01 --on slurm --parts 2

level=$(best_of bwrap user none)
expect "the class is marked" 0 "" "$course" grade submissions/* --chapter 01 --seed 5 --isolation "$level" -o marks.csv
marks=$(cut -d, -f1,3,4 marks.csv)
expected="submission,earned,possible
ada,80,70
ben,30,70
cleo,0,70"
[ "$marks" = "$expected" ] || fail "each has the marks of what works" "$marks"

# What was marked is not marked again, and says the same.
cp marks.csv first.csv
"$course" grade submissions/* --chapter 01 --seed 5 --isolation "$level" -o marks.csv
cmp -s first.csv marks.csv || fail "a second run gives the same file" "$(diff first.csv marks.csv)"
expect "the class's page" 0 "" "$course" grade submissions/* --chapter 01 --seed 5 --isolation "$level" --format html -o class.html
grep -q cleo class.html || fail "the page shows everybody"

# Archives are marked as directories are, late work as the rubric says.
tar czf ben.tar.gz -C submissions ben
(cd submissions/ada && bsdtar --format zip -cf ../../ada.zip chapters)
echo '{"version": 1, "due": {"01": "2027-03-01T12:00Z"}, "late": [{"hours": 24, "percent": 50}]}' >rubric.json
printf '%s\n' ada,2027-03-01T12:00:00Z ben,2027-03-01T14:00:00+01:00 >times.csv
mark_archives() { "$course" grade ada.zip ben.tar.gz --chapter 01 --seed 5 --isolation "$level" --rubric rubric.json "$@"; }
expect "archives" 0 "nothing counts as late: --submitted" mark_archives -o marks.csv
[ "$(cut -d, -f1,3 marks.csv)" = "$(printf 'submission,earned\nada,80\nben,30')" ] || fail "archives have their marks" "$(cat marks.csv)"
expect "late work" 0 "" mark_archives --submitted times.csv -o marks.csv
[ "$(cut -d, -f1,3 marks.csv)" = "$(printf 'submission,earned\nada,80\nben,15')" ] || fail "late work has less" "$(cat marks.csv)"
sed -i 2d times.csv
expect "a time that is missing" 2 "times.csv: it does not say when ben was handed in" mark_archives --submitted times.csv

# What cannot be read has no marks, and a reason; the others have theirs.
mkdir -p bad/nobody
head -c "$(($(stat -c %s ada.zip) / 2))" ada.zip >bad/dan.zip
expect "a class with bad submissions" 0 "bad/dan.zip: not taken: it cannot be unpacked: " \
    "$course" grade ada.zip bad/* --chapter 01 --seed 5 --isolation "$level" -o marks.csv
[ "$(cut -d, -f1,3,4 marks.csv)" = "$(printf 'submission,earned,possible\nada,80,70\ndan,0,70\nnobody,0,70')" ] ||
    fail "bad submissions keep nobody from having marks" "$(cat marks.csv)"
expect "a student reads why" 0 "what was handed in cannot be unpacked" \
    "$course" grade bad/dan.zip --chapter 01 --seed 5 --isolation "$level" --format gradescope
expect "an instructor reads why" 0 "what was handed in has no file of an exercise, such as chapters/01" \
    "$course" grade bad/nobody --chapter 01 --seed 5 --isolation "$level" --format html

expect "what a level leaves open is said" 0 "level none leaves open: read what everybody may read" \
    "$course" grade submissions/cleo --chapter 01 --seed 5 --isolation none -o marks.csv

end_there
