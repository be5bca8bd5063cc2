#!/usr/bin/env bash
# A handout from inside: a newcomer's first day with the commands of its README, a student's mistakes and chapters that
# pass, and an update in mid-semester. Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/copy.sh
. "$(dirname "$0")/scratch/copy.sh"
course=$COURSE_BUILD/bin/course
class=$COURSE_BUILD/scratch/"a newcomer"
handout=$class/handout
rm -rf "$class"
mkdir -p "$class"

expect "a handout is made" 0 "made .*: chapters 01 to 02, " "$course" handout "$handout" --chapters 1-2

# ---------------------------------------------------------------------------------- a newcomer's first day

# What is the same as in the repository gets its time, by which borrow.sh sees that.
same_times() {
    local file ours
    cd "$handout" || exit
    git ls-files -z --cached --others --exclude-standard '*.cpp' '*.hpp' | while IFS= read -r -d '' file; do
        ours=$COURSE_ROOT/${file/#.course\/pristine/chapters}
        if cmp -s "$file" "$ours"; then touch -r "$ours" "$file"; fi
    done
}
lend_to "$handout"
same_times

expect_of_newcomer() {  # expect_of_newcomer COMMAND...: what a command of the README comes to before anything is written
    case "$*" in
        ./course) expect "README: $*" 0 "write step 01.1" "$@" ;;
        *" list") expect "README: $*" 0 "02.5  " "$@" ;;
        *" check "*) expect "README: $*" 1 "write step 01.1 in chapters/01_ray_casting/" "$@" ;;
        *" hint "*) expect "README: $*" 0 "Hint 1 of" "$@" ;;
        *" render "*) expect "README: $*" 1 "needs step 01.[0-9] \(chapter 01, " "$@" ;;
        *" reset "*) expect "README: $*" 0 "Nothing to reset" "$@" ;;
        *) fail "README: nothing is known of $*" ;;
    esac
}
mapfile -t commands < <(grep '^\./course' README.md | sed 's/ *#.*//')
[ ${#commands[@]} -ge 6 ] || fail "the README shows commands" "${commands[*]}"
for command in "${commands[@]}"; do
    read -ra words <<<"$command"
    expect_of_newcomer "${words[@]}"
done
[ -z "$(git status --porcelain)" ] || fail "that changes nothing" "$(git status --porcelain)"

# write_step STEP FILE: writes a step as its solution does.
write_step() {
    awk -v head="[exercise $1]" '/\[\/exercise\]/ { on = 0 } on; index($0, head) { on = 1 }' \
        "$COURSE_ROOT/solutions/$2" >"$class/answer"
    sed -i -e "/return todo(\"$1\");/{r $class/answer" -e 'd}' "chapters/$2"
}
first_step=01_ray_casting/camera.cpp
expect "a step that is to do" 1 "write step 01.1 in chapters/$first_step" ./course check 01.1
write_step 01.1 $first_step
expect "it passes when it is written" 0 "1 of 1 step" ./course check 01.1
expect "the next one is told" 0 "write step 01.2" ./course
expect "it is taken back, and kept" 0 "camera.cpp.001.backup" ./course reset 01.1
[ -z "$(git status --porcelain)" ] || fail "it is as it was handed out" "$(git status --porcelain)"

# --------------------------------------------------------------------------------------- what is not there

program=build/bin/course
expect "hidden chapters are not listed" 2 "there is no chapter '6'; there are 01, 02" $program check 6
for command in "tour" "test" "report" "references" "exercises" "figures" "mutate" "new 10_lights" "solution 01.1" \
    "handout x" "grade x" "similarity x" "autograder x" "check 01 --solutions" \
    "render references/01_ray_casting/planes.scene --solutions" \
    "trace references/01_ray_casting/planes.scene 1 1 --against solutions"; do
    read -ra words <<<"$command"
    expect "$command" 2 "^this is a handout, which has no solutions; ./course ${words[0]}.* needs them$" \
        $program "${words[@]}"
done
for command in tour test grade similarity autograder references new handout; do
    if $program --help | grep -qE "^  $command "; then fail "--help does not offer $command"; fi
done

# ------------------------------------------------------------------------- a student, and what goes wrong

sphere=chapters/02_spheres/sphere.cpp
sed -i 's/return todo("02.2");/return nothing;/' $sphere
expect "a compile error is told" 1 "$sphere:[0-9]+:[0-9]+: error: .*nothing" ./course check 02
expect "and breaks nothing else" 1 "write step 01.1" ./course check 01
expect "it is taken back" 0 "$sphere is back at its start" ./course reset 02
plane=chapters/01_ray_casting/plane.cpp
rm $plane
expect "a file that is missing is named, also by later chapters" 1 "$plane is missing; ./course reset 01" \
    ./course check 02
expect "and comes back" 0 "$plane was missing and is back" ./course reset 01
git restore chapters
[ -z "$(git status --porcelain)" ] || fail "git takes changes back"

# What is given, and is changed or deleted by accident.
echo "}" >>common/math/vec.hpp
expect "a broken header is named" 0 "common/math/vec.hpp is not as the course has it; git restore common/math/vec.hpp brings" \
    ./course hint 01.1
expect "the program that could be built last does what it can" 0 "Hint [0-9] of" ./course hint 01.2
expect "also a reset" 0 "Nothing to reset" ./course reset 01
expect "what to do is told" 1 "Next:.* git restore common/math/vec.hpp" ./course check 01
git restore common && same_times
rm chapters/01_ray_casting/camera.hpp chapters/01_ray_casting/chapter.json tests/01_ray_casting/camera_test.cpp
expect "deleted files are named" 2 "camera.hpp \(deleted\), .*git restore chapters/01_ray_casting/camera.hpp" ./course hint 01.1
expect "and come back" 0 "tests/01_ray_casting/camera_test.cpp was missing and is back" ./course reset 01
[ -z "$(git status --porcelain)" ] || fail "all of them" "$(git status --porcelain)"
same_times
expect "then all is well" 1 "write step 01.1" ./course check 01

# solve NUMBER...: writes the chapters as their solutions do.
solve() {
    local number
    for number in "$@"; do
        cp "$COURSE_ROOT"/solutions/"$number"_*/*.cpp chapters/"$number"_*/  # newer than what was built of them
    done
}
solve 01
expect "a chapter passes" 0 "Your picture: build/pictures/01_ray_casting/" ./course check 01
expect "and draws" 0 "your code$" ./course render references/01_ray_casting/planes.scene -o mine.pfm
"$course" render references/01_ray_casting/planes.scene --solutions --quiet -o theirs.pfm
cmp -s mine.pfm theirs.pfm || fail "what the solutions draw"
expect "a page of both has the rays of the student's code" 0 "^equal" ./course compare mine.pfm theirs.pfm \
    --page page.html --scene references/01_ray_casting/planes.scene
grep -q '"mine":"pixel (' page.html || fail "in the page"
rm page.html
rm mine.pfm theirs.pfm
solve 02
expect "with these chapters alone both pass" 0 "Chapter 02.*5 of 5 steps" ./course check 01 02
expect "what a scene needs is told" 0 "Drawn by.* 02 Spheres" ./course explain references/02_spheres/normals.scene
cat >mirror.scene <<'END'
version 1
size 8 8
camera 0 0 4 0 0 0 0 1 0 45
point 0 5 5 1 1 1
specular 1 1 1
sphere 0 0 0 1
END
expect "a step that is not there is named" 1 "this needs step 0[0-9].[0-9], of a chapter that this handout does not have" \
    ./course render mirror.scene -o mirror.png

# -------------------------------------------------------------------------------------------- mid-semester

git -c user.name=Student -c user.email=student@localhost commit -qam "Chapters 1 and 2"
echo "// Mine." >>$sphere
cp $sphere "$class/mine"
expect "an update brings more chapters" 0 "has chapters 01 to 05: [0-9]+ files written, 0 removed" \
    "$course" handout --update "$handout" --chapters 1-5
cmp -s $sphere "$class/mine" || fail "and leaves the student's files alone"
if git diff --name-only -- chapters/0[12]*/*.cpp | grep -qvx $sphere; then fail "all of them"; fi
expect "then it is up to date" 0 "0 files written, 0 removed" "$course" handout --update "$handout"
git add --all
git -c user.name=Student -c user.email=student@localhost commit -qm "Chapters 3 to 5"
same_times
solve 03 04 05
expect "and they pass, on the student's own chapters" 0 "Chapter 05.*5 of 5 steps" ./course check 02 05

cd "$COURSE_ROOT" || exit
rm -rf "$class"
finish
