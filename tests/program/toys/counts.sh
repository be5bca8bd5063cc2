#!/usr/bin/env bash
# How many existing files must be edited to add a shape, an accelerator, an integrator or a scene command: in a scratch
# copy of the repository the toys beside this file are added, each as its chapter would, built together, and seen in
# pictures. Run by .ci/run, which sets COURSE_ROOT and COURSE_BUILD, after `course test`.
set -eu
# shellcheck source=tests/program/scratch/copy.sh
. "$(dirname "$0")/../scratch/copy.sh"
go_to_copy "$COURSE_BUILD/scratch/toys"

# add TOY MOST: TOY/new has the toy's own files, TOY/edit a sed script for each existing file that must be edited, both
# under the files' paths in the repository. Of these there may be at most MOST. What `./course exercises --make` writes
# is not edited by hand and does not count.
add() {
    local toy=$COURSE_ROOT/tests/program/toys/$1 most=$2 file edited=0
    while IFS= read -r file; do
        [ ! -e "$file" ] || fail "$1: $file is there already"
        mkdir -p "$(dirname "$file")"
        cp "$toy/new/$file" "$file"
    done < <(cd "$toy" && find new -type f -printf '%P\n' 2>/dev/null)
    while IFS= read -r file; do
        cp "${file%.sed}" before
        sed -i -f "$toy/edit/$file" "${file%.sed}" || fail "$1: ${file%.sed} cannot be edited"
        ! cmp -s before "${file%.sed}" || fail "$1: nothing in ${file%.sed} is where it was"
        edited=$((edited + 1))
    done < <(cd "$toy" && find edit -type f -printf '%P\n')
    echo "$1: $edited existing files"
    [ "$edited" -le "$most" ] || fail "$1: $edited existing files had to be edited; at most $most may be"
}

add shape 5
add accelerator 3
add integrator 2
add command 4
[ "$failures" = 0 ] || finish

# The quickest way to a program: not optimised, and without the rooms that no toy is known in.
if ! { cmake -S . -B build -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER_LAUNCHER="$BORROW_ELSE" &&
    cmake --build build --target draw_toys; } >log 2>&1; then
    fail "the toys do not build" "$(grep -A 4 -E 'error:|CMake Error' log | head -n 40)"
    finish
fi

# same NAME SCENE OTHER: both scenes give the same picture, and something is to be seen in it.
same() {
    local one
    for one in "$2" "$3" ""; do
        printf 'version 1\nsize 40 30\ncamera 1 2 5  0 0 0  0 1 0  40\nbackground .1 .2 .3\n%b\n' "$one" >one.scene
        expect "$1" 0 "" build/bin/draw_toys one.scene one.pfm
        mv one.pfm "picture.$((++pictures))"
        mv one.pfm.pov "for_povray.$pictures"
    done
    cmp -s "picture.$((pictures - 2))" "picture.$((pictures - 1))" || fail "$1: the pictures differ"
    ! cmp -s "picture.$((pictures - 2))" "picture.$pictures" || fail "$1: nothing is to be seen"
}
pictures=0

same "a shape" "directional 1 1 1 1 1 1\ndiffuse 1 .5 0\nball .5 0 0 1" \
    "directional 1 1 1 1 1 1\ndiffuse 1 .5 0\nsphere .5 0 0 1"
same "a shape under a transform" "integrator normals\nscale 2 1 1\nrotate 1 2 3 40\nball .25 0 0 .5" \
    "integrator normals\nscale 2 1 1\nrotate 1 2 3 40\nsphere .25 0 0 .5"
balls=$(for i in 1 2 3 4 5 6 7 8; do printf 'sphere .%s -.%s .%s .3\\nball -.%s .%s -.%s .2\\n' $i $i $i $i $i $i; done)
same "an accelerator" "integrator normals\naccelerator boxes\n$balls" "integrator normals\naccelerator none\n$balls"
same "an integrator" "integrator silhouette\nsphere 0 0 0 1" "integrator flat\nambient 1 1 1\nsphere 0 0 0 1"
same "a command" "brightness 2\nambient .25 .125 .5\nsphere 0 0 0 1" "ambient .5 .25 1\nsphere 0 0 0 1"
grep -q 'rgb <0.5, 0.25, 1>' "for_povray.$((pictures - 2))" || fail "a command is expressed for POV-Ray"

# The toy shape has no inside. As a sheet it may filter light, which is beyond POV-Ray; glass it cannot be.
camera='version 1\nsize 40 30\ncamera 1 2 5  0 0 0  0 1 0  40\n'
printf '%b' "${camera}transmission 1 .5 1\nball .5 0 0 1\n" >one.scene
expect "a sheet" 0 "" build/bin/draw_toys one.scene one.pfm
grep -q 'one.scene:5:1: .* without an inside' one.pfm.pov || fail "a sheet is refused by the export"
printf '%b' "${camera}transmission 1 .5 1\nior 1.5\nball .5 0 0 1\n" >one.scene
expect "glass without an inside" 2 'one.scene:6:1: .* without an inside' build/bin/draw_toys one.scene one.pfm

# needs NAME FILE EDIT SOURCE MESSAGE: without a part of the toy shape the source does not compile, and the compiler
# says what is missing.
needs() {
    cp -p "$2" before
    sed -i "$3" "$2"
    ! cmp -s before "$2" || fail "$1: nothing was taken out of $2"
    expect "$1" 1 "$5" cmake --build build --target "CMakeFiles/common_$(cut -d / -f 2 <<<"$4").dir/$4.o"
    cp -p before "$2"
}
needs "words of a file's shape" common/scene/shapes.hpp 's/file_words<Ball>/file_words<char>/' common/scene/mesh_file.cpp \
    'there_are_no_file_words_for_this_shape'
needs "a section for POV-Ray" common/povray/shapes.cpp '/^Extent extent_of(const Scene& scene, const Ball/,/^}/d' \
    common/povray/shapes.cpp 'lacks one of open_statement, with_uv, extent_of and scale'
needs "bounds" chapters/97_toys/ball.hpp '/^Bounds bounds_of/d' common/render/primitives.cpp 'bounds_of is missing'
finish
