#!/usr/bin/env bash
# The instructor's guide and its reference, followed to the letter: every command that they show, in their order, with
# the files that they show, on a class that hands in what the guide says it may. Only Slurm is tried elsewhere
# (tests/grading/engines.sh). Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/copy.sh
. "$(dirname "$0")/scratch/copy.sh"
texts=$COURSE_ROOT/common/grading
class=$COURSE_BUILD/scratch/"a guided class"
rm -rf "$class"
mkdir -p "$class/tree"
cd "$class/tree" || exit
export GIT_AUTHOR_NAME=Ada GIT_AUTHOR_EMAIL=ada@localhost GIT_COMMITTER_NAME=Ada GIT_COMMITTER_EMAIL=ada@localhost

# blocks LANGUAGE TEXT: what stands in its blocks of this language.
blocks() {
    awk -v head="\`\`\`$1" '/^ *```/ { sub(/^ */, ""); inside = !inside; wanted = inside && $0 == head; next } wanted' \
        "$texts/$2"
}
blocks json README.md >class.json
blocks json REFERENCE.md >grading.json

# Boxes as good as this machine has them: the first level at which a broken archive is opened.
echo moon >no.zip
for LEVEL in bwrap user none; do
    "$COURSE_BUILD/bin/course" similarity no.zip --isolation $LEVEL 2>&1 | grep -q "is not possible here" || break
done
export LEVEL COURSE_BUILD
cat >course <<'END_OF_COURSE'
#!/usr/bin/env bash
if [[ $1 =~ ^(grade|similarity)$ && " $* " != *" --merge "* ]]; then set -- "$@" --isolation "$LEVEL"; fi
exec "$COURSE_BUILD/bin/course" "$@"
END_OF_COURSE
chmod +x course

# hand_in: Ada has written everything, Ben only his camera, and Cleo's planes crash.
hand_in() {
    local chapter=01_ray_casting
    mkdir -p submissions/ben cleo
    git clone --quiet ../handout submissions/ada
    cp "$COURSE_ROOT"/solutions/$chapter/*.cpp submissions/ada/chapters/$chapter
    cp "$COURSE_ROOT"/solutions/$chapter/camera.cpp submissions/ben
    cp "$COURSE_ROOT"/solutions/$chapter/*.cpp cleo
    sed 's/return todo("01.4");/return *(std::optional<Hit>*)nullptr;/' \
        "$COURSE_ROOT"/chapters/$chapter/plane.cpp >cleo/plane.cpp
    bsdtar --format zip -cf submissions/cleo.zip cleo
}

# follow TEXT: its commands.
followed=0
follow() {
    local command commands
    mapfile -t commands < <(blocks "" "$1" | grep -E '^(\./course|git) ')
    for command in "${commands[@]}"; do
        expect "$1: $command" 0 "" bash -c "$command"
        followed=$((followed + 1))
        [ -d submissions ] || hand_in
    done
}
follow README.md
for handed in $(blocks "" README.md | grep -o '^submissions/[a-z.]*'); do
    [ -e "$handed" ] || fail "$handed is in the class that hands in"
done
[ "$(cut -d, -f1,3,4 marks.csv)" = "$(printf 'submission,earned,possible\nada,80,70\nben,30,70\ncleo,40,70')" ] ||
    fail "each has the marks of what works" "$(cat marks.csv)"
for section in "Common mistakes" "Crashed, or stopped otherwise"; do
    grep -q "<h2[^>]*>$section<" class.html || fail "the page has what the guide says: $section"
done
cp class.html whole.html
follow REFERENCE.md
cmp -s whole.html class.html || fail "parts that are merged are the whole"
for file in mark.sh similarity.html autograder.zip; do [ -s $file ] || fail "$file is made"; done
[ "$(git -C ../handout rev-list --count HEAD)" = 2 ] || fail "the update is committed"
[ $followed -gt 11 ] || fail "the texts show commands" "$followed"

cd "$COURSE_ROOT" || exit
rm -rf "$class"
finish
