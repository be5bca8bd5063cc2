#!/usr/bin/env bash
# A class whose marks are known beforehand, marked in two parts at once after a grader was killed in the middle of it:
# every mark comes out, none is given twice, and of the killed grader nothing is left.
# Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/marking.sh
. "$(dirname "$0")/scratch/marking.sh"
begin_in "known class"

# Names of this run alone: marks of an earlier one are kept in the tree.
"$COURSE_BUILD/bin/make_class" . 6 3 05
for student in submissions/*; do mv "$student" "$student-$$"; done
sed -i "s/^s[0-9][0-9]*/&-$$/" expected.csv
asked=(submissions/* --chapter 05 --seed 5)

# kept_marks: the files of this class, with what would change if one were written again.
kept_marks() {
    find "$COURSE_ROOT/.course/grades" -name '*.json' -newer expected.csv -print0 2>/dev/null |
        xargs -0r grep -lZ -- "\"s[0-9]*-$$\"" | xargs -0r stat -c '%i %y %n' | sort
}
children_of() { cat /proc/[0-9]*/stat 2>/dev/null | sed -n "s/^\([0-9]*\) (.*) [A-Z] $1 .*/\1/p"; }
descendants_of() {
    local child
    for child in $(children_of "$1"); do
        echo "$child"
        descendants_of "$child"
    done
}
is_there() { [ -e "/proc/$1" ]; }

# ------------------------------------------------------------------------- killed in the middle of the class

level=$(best_of bwrap user none)
"$course" grade "${asked[@]}" --isolation "$level" --format json -o whole.json 2>said &
grader=$!
while is_there $grader && { [ -z "$(kept_marks)" ] || [ -z "$(descendants_of $grader)" ]; }; do sleep 0.05; done
if ! is_there $grader; then
    wait $grader || fail "the class is marked" "$(cat said)"
    fail "the class takes long enough to be killed"
    finish
fi
its_processes=$(descendants_of "$grader")
its_places=$(find "/proc/$grader/fd" -type l -exec readlink {} + 2>/dev/null | grep -E 'course-staged|/runs/' || true)
kill -9 "$grader"
wait "$grader" 2>/dev/null || true
[ ! -e whole.json ] || fail "it was killed in the middle"
[ "$(wc -l <<<"$its_places")" = 2 ] || fail "it had a workshop, and a place for reports" "$its_places"
for _ in $(seq 100); do
    left=""
    for process in $its_processes; do ! is_there "$process" || left+=" $process"; done
    [ -n "$left" ] || break
    sleep 0.1
done
[ -z "$left" ] || fail "judges and boxes end with their grader" "$left"
kept_marks >before

# ------------------------------------------------------------------------------------- two parts of it at once

for part in 1 2; do
    "$course" grade "${asked[@]}" --isolation "$level" --part $part/2 -o part$part.json 2>said.$part &
    parts[part]=$!
done
for part in 1 2; do wait "${parts[part]}" || fail "two graders at once do not disturb each other" "$(cat said.$part)"; done
while IFS= read -r place; do
    [ ! -e "$place" ] || fail "what a killed grader left is removed by the next" "$place"
done <<<"$its_places"
kept_marks >after
[ -z "$(comm -23 before after)" ] || fail "what was marked is not marked again" "$(comm -23 before after)"
[ "$(wc -l <after)" = 6 ] || fail "everybody is marked once" "$(cat after)"

"$course" grade --merge part2.json part1.json -o marks.csv
steps=$(head -1 expected.csv | tr ',' '\n' | grep -c '^[0-9]')
tr -d '\r' <marks.csv | cut -d, -f"1,3-$((steps + 4))" >marks
cmp -s expected.csv marks || fail "every mark is as it was known beforehand" "$(diff expected.csv marks; cat about.txt)"

"$course" grade --merge part1.json part2.json --format json -o merged.json
"$course" grade "${asked[@]}" --isolation "$level" --format json -o whole.json
cmp -s merged.json whole.json || fail "the parts together are the same file as the whole" "$(diff merged.json whole.json)"

# --------------------------------------------------------------------------------- parts that are no one class

expect "a part is missing" 2 "^part1.json is part 1 of 2, and there is no part 2$" "$course" grade --merge part1.json
expect "a part is there twice" 2 "^part1.json is part 1 of 2, and so is part1.json$" \
    "$course" grade --merge part1.json part1.json part2.json
expect "a whole class is no part" 2 "^whole.json is no part of a class, and" "$course" grade --merge part1.json whole.json
sed 's/"seed":5/"seed":6/' part2.json >other.json
expect "another seed" 2 "^other.json: the submission .* was marked with another seed than .* in part1.json$" \
    "$course" grade --merge part1.json other.json
sed 's/"isolation":"[a-z]*"/"isolation":"moon"/' part2.json >other.json
expect "another level" 2 "other.json: .* another level of isolation \(moon, not $level\)" \
    "$course" grade --merge part1.json other.json
sed 's/"list":"[0-9a-f]*"/"list":"moon"/' part2.json >other.json
expect "another list" 2 "other.json is a part of other submissions than part1.json" \
    "$course" grade --merge part1.json other.json
echo '{"version": 1, "credit": "part"}' >rubric.json
expect "another rubric" 2 "part1.json: was marked with another rubric than rubric.json" \
    "$course" grade --merge part1.json part2.json --rubric rubric.json
expect "a part that there is not" 2 "there is no part '3/2' of a class" "$course" grade "${asked[@]}" --part 3/2
expect "nothing to mark" 2 "name their directories or archives" "$course" grade
expect "what is merged is not marked" 2 "excludes" "$course" grade submissions/* --merge part1.json

sed "s|^[^/]*||" after | tr '\n' '\0' | xargs -0r rm
end_there
