#!/usr/bin/env bash
# What submissions have in common, as an instructor asks for it. Run by `course test`, which sets COURSE_ROOT and
# COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/marking.sh
. "$(dirname "$0")/scratch/marking.sh"
begin_in "similar class"
mkdir -p submissions/{ada,ben,cleo}

# Ada has the solution without its comments, Ben has it with other names, and Cleo has begun nothing.
for file in "$COURSE_ROOT"/solutions/01_ray_casting/*.cpp; do
    grep -v '^ *//' "$file" >"submissions/ada/${file##*/}"
    sed 's/direction/way/g; s/\bi\b/column/g' "$file" >"submissions/ben/${file##*/}"
done
cp "$COURSE_ROOT"/chapters/01_ray_casting/*.cpp submissions/cleo

expect "a report in a form that there is not" 2 "similar.txt: expected a name that ends in .html, .csv or .json" \
    "$course" similarity submissions/* -o similar.txt
expect "a submission that there is not" 2 "submissions/dan: No such file" "$course" similarity submissions/dan
expect "two submissions of one name" 2 "submissions/ada and ada.zip: two submissions of the same name" \
    bash -c "(cd submissions && bsdtar --format zip -cf ../ada.zip ada) && '$course' similarity submissions/ada ada.zip"
expect "the most similar are told" 0 "100 %   100 % of ada, 100 % of ben" "$course" similarity submissions/* --chapter 01
expect "published answers, too" 0 "100 % of ben, 100 % of our solution" "$course" similarity submissions/* --chapter 01
expect "as JSON" 0 '"second": "ben"' "$course" similarity submissions/* --chapter 01 --json
if "$course" similarity submissions/* --chapter 01 --json | grep -q cleo; then fail "what was handed out is no copy"; fi

for form in html csv json; do
    expect "a file" 0 "" "$course" similarity submissions/* --chapter 01 -o similarity.$form
    grep -q "our solution" similarity.$form || fail "similarity.$form names the solution"
done
[ "$(grep -c '^01_ray_casting,ada,ben,no,1.000,' similarity.csv)" = 1 ] || fail "a row a pair" "$(cat similarity.csv)"
expect "fewer pairs" 0 "^  100 %   100 % of ada, 100 % of ben$" "$course" similarity submissions/ada submissions/ben --chapter 01 --least 100
expect "more than all" 2 "--least" "$course" similarity submissions/* --least 101

# Archives are opened in boxes; what cannot be opened is told, and is not compared.
echo "no archive" >dan.zip
archives() { "$course" similarity ada.zip dan.zip submissions/ben --chapter 01 --isolation "$level"; }
level=$(best_of bwrap user none)
expect "archives are compared" 0 "100 %   100 % of ada, 100 % of ben" archives
expect "what is no archive is told" 0 "^dan.zip: not taken: it cannot be unpacked: " archives

end_there
