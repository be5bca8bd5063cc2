#!/usr/bin/env bash
# A handout as a class gets it: made whole or not at all, by one of several at once, and what students read in it.
# Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/copy.sh
. "$(dirname "$0")/scratch/copy.sh"
course=$COURSE_BUILD/bin/course
class=$COURSE_BUILD/scratch/"a class"
handout=$class/handout
rm -rf "$class"
mkdir -p "$class"

# ---------------------------------------------------------------------------------- it is made, or it is not

cat >"$class/class.json" <<'END'
{"course": "Rays 101", "instructor": "Ada Lovelace", "due": {"01": "2027-02-01", "02": "2027-02-15 23:59"}}
END
mkdir "$class/.course-staged-killed"
expect "a handout is made" 0 "made .*: chapters 01 to 05, [0-9]+ files, in git" \
    "$course" handout "$handout" --chapters 1-5 --class "$class/class.json"
[ ! -e "$class/.course-staged-killed" ] || fail "what a killed program left is removed"
expect "once" 2 "is a handout already; --update brings it up to date" "$course" handout "$handout"
expect "not over anything else" 2 "a class exists, and is no handout; nothing was changed" "$course" handout "$class"
expect "nothing else is updated" 2 "a class is no handout; nothing was changed" "$course" handout --update "$class"

for one in 1 2; do
    "$course" handout "$class/same" --chapters 1 >"$class/said.$one" 2>&1 &
    "$course" handout "$class/other.$one" --chapters 1 >/dev/null 2>&1 &
done
wait
[ "$(cat "$class"/said.* | grep -c '^made ')" = 1 ] || fail "of several at once, one is made" "$(cat "$class"/said.*)"
for one in same other.1 other.2; do
    [ -z "$(git -C "$class/$one" status --porcelain)" ] || fail "each is whole"
done
[ -z "$(find "$class" -maxdepth 1 -name '.course-*')" ] || fail "nothing is left beside them"
rm -rf "$class"/same "$class"/other.*

# ---------------------------------------------------------------------------------------- what students read

cd "$handout" || exit
expect "the README names the class" 0 "^# Rays 101" cat README.md
expect "its instructor" 0 "^Instructor: Ada Lovelace" cat README.md
expect "and dates" 0 "Spheres.* 2027-02-15 23:59 \|$" cat README.md

# Every link of what students read leads to something.
dead=$(for text in README.md chapters/*/README.md common/scene/README.md; do
    { grep -oE '\]\([^)#]+' "$text" || true; grep -oE 'src="[^"]+' "$text" || true; } | sed -E 's/^(\]\(|src=")//' |
        grep -v '^http' | while read -r link; do [ -e "$(dirname "$text")/$link" ] || echo "$text: $link"; done
done)
[ -z "$dead" ] || fail "links lead to something" "$dead"

# -------------------------------------------------------------------------------------- what nobody can read

# Lines with white space folded, sorted.
lines() { LC_ALL=C sed -E 's/[[:space:]]+/ /g; s/^ //; s/ $//' | LC_ALL=C sort -u; }
cd "$COURSE_ROOT" || exit
cat common/*/*.cpp common/*/*.hpp common/*/*/*.cpp common/*/*/*.hpp chapters/*/*.hpp "$handout"/.course/pristine/*/*.cpp |
    lines >"$class/given"
awk '/\[\/exercise\]/ { on = 0 } on && length >= 12 { print } /\[exercise / { on = 1 }' solutions/*/*.cpp | lines |
    LC_ALL=C awk 'length >= 12' | LC_ALL=C comm -23 - "$class/given" >"$class/secret"
[ "$(wc -l <"$class/secret")" -gt 400 ] || fail "solutions have lines" "$(cat "$class/secret")"
# All that git keeps there, of all commits.
kept_by_git() { git -C "$handout" cat-file --batch-all-objects --batch | lines; }
[ -z "$(kept_by_git | LC_ALL=C comm -12 "$class/secret" -)" ] ||
    fail "no line of a solution is in the handout's history" "$(kept_by_git | LC_ALL=C comm -12 "$class/secret" -)"
if find "$handout" -path "$handout/solutions*" -o -name '*.mistake' -o -name '*.variant' | grep -q .; then
    fail "no solution, mistake or variant is in it"
fi

rm -rf "$class"
finish
