#!/usr/bin/env bash
# The whole program from outside, in a scratch copy of the repository to which a tiny chapter column is added:
# that nothing else needs an edit, and what a student's day is like there - crashes and hangs included.
# Run by `course test`, which sets COURSE_ROOT and COURSE_BUILD.
set -eu
# shellcheck source=tests/program/scratch/copy.sh
. "$(dirname "$0")/scratch/copy.sh"

# state STEP: as check said last.
state() { build/bin/course list --json | grep -oE "\"id\":\"$1\"[^}]*\"state\":\"[a-z]+\"" | grep -oE '[a-z]+"$' | tr -d '"' || true; }
expect_state() {
    local found
    found=$(state "$2")
    [ "$found" = "$3" ] || fail "$1: step $2 is $found, expected $3"
}

# ---------------------------------------------------------------------------------------- the copy

# Directories have such names, too.
copy=$COURSE_BUILD/scratch/"a \$5 column"
go_to_copy "$copy"

name=99_tiny
mkdir -p chapters/$name solutions/$name tests/$name/mistakes references/$name
cat >chapters/$name/tiny.hpp <<'END'
// A tiny chapter.
#pragma once

namespace rt {

/// [99.1] The number after `n`.
int next(int n);

/// [99.2] The number after the next.
int after_next(int n);

}  // namespace rt
END
cat >solutions/$name/tiny.cpp <<'END'
// A tiny chapter.
#include "chapters/99_tiny/tiny.hpp"

namespace rt {

int next(int n) {
    // [exercise 99.1] Return the number after `n`.
    return n + 1;
    // [/exercise]
}

int after_next(int n) {
    // [exercise 99.2] Return the number after the next.
    return n + 2;
    // [/exercise]
}

}  // namespace rt
END
cat >tests/$name/tiny_test.cpp <<'END'
// A tiny chapter is right.
#include "chapters/99_tiny/tiny.hpp"
#include "tests/catch.hpp"

TEST_CASE("after one comes two", "[99.1]") {
    INFO("n := " << 1);
    CHECK(rt::next(1) == 2);
}
TEST_CASE("after the next comes the next's next", "[99.2]") { CHECK(rt::after_next(1) == 3); }
END
cat >chapters/$name/chapter.json <<'END'
{"title": "Tiny", "summary": "The least chapter.", "hours": 1,
 "steps": [
  {"id": "99.1", "title": "Next", "file": "tiny.cpp", "points": 1, "hints": ["first", "second", "third"]},
  {"id": "99.2", "title": "After next", "file": "tiny.cpp", "points": 2, "uses": ["99.1"],
   "picture": "one.scene", "hints": ["a", "b", "c"]}],
 "scenes": ["one.scene"]}
END
cat >references/$name/one.scene <<'END'
version 1
size 16 12
camera 0 0 4 0 0 0 0 1 0 45
integrator normals
sphere 0 0 0 1
END
exercise=chapters/$name/tiny.cpp

# Its neighbour, the same under another number.
for room in chapters solutions tests references; do
    cp -R $room/$name $room/98_tiny
    find $room/98_tiny -type f -exec sed -i 's/99/98/g; s/next/follow/g' {} +
done

# -------------------------------------------------------------------------------- a chapter is added

expect "exercises are generated" 0 "wrote $exercise" ./course exercises --make
expect "and then as generated" 0 "nothing has changed" ./course exercises
expect "the chapter is listed" 0 "99.2  After next" ./course list
expect "its solution passes" 0 "2 of 2 steps" ./course check 99 --solutions
expect "nothing is started" 1 "write step 99.1 in $exercise" ./course check 99
expect_state "nothing is started" 99.1 todo
[ "$(cd / && "$copy/course" list)" = "$(./course list)" ] || fail "it works from any directory"
cp $exercise "$COURSE_BUILD/scratch/tiny.start"

# A column that the program makes is as complete as one that a person has made.
expect "a chapter is made by a command" 0 "wrote chapters/97_fresh/fresh.cpp" ./course new 97_fresh
expect "once" 2 "the number 97 is taken: there is chapters/97_fresh" ./course new 97_stale
expect "under a name of its own" 2 "the name 'fresh' is taken" ./course new 96_fresh
expect "its exercise is what its solution generates" 0 "nothing has changed" ./course exercises
expect "its solution passes" 0 "1 of 1 step" ./course check 97 --solutions
expect "its exercise is not started" 1 "write step 97.1 in chapters/97_fresh/fresh.cpp" ./course check 97
expect_state "its exercise is not started" 97.1 todo
for file in tests/97_fresh/mistakes/*; do
    mistake=mistake_$(basename "$file" .mistake)
    cmake --build build --target "$mistake" >/dev/null
    expect "its mistakes are caught" 1 "halfway between 1 and 4" "build/bin/$mistake"
done
for number in 1 2; do
    cmake --build build --target variants_97_$number >/dev/null
    expect "its variants pass" 0 "2 passed" build/bin/variants_97_$number
done
expect "its tests notice each change of its solution" 0 "100.0 %" ./course mutate 97.1
printf 'step 97.1\nfrom a;\nto   b;\nwhy  It is.\n' >tests/97_fresh/variants/equivalent.mutants
expect "of changes that are right one is listed that is not made" 1 \
    "variants/equivalent.mutants:3: step 97.1 has no mutant 'b;' of 'a;'" ./course mutate 97 --sample 1
rm tests/97_fresh/variants/equivalent.mutants

# ------------------------------------------------------------------------------------ a student's day

set_step() { sed -i "s|return todo(\"$1\");|$2|" $exercise; }
line_of() { grep -nE -- "$1" $exercise | tail -n 1 | cut -d: -f1; }  # of the last that has this
start_again() { cp "$COURSE_BUILD/scratch/tiny.start" $exercise; }

set_step 99.1 'return n + 1;'
expect "half a chapter" 1 "1 of 2 steps" ./course check 99
expect_state "half a chapter" 99.1 passed
expect_state "half a chapter" 99.2 todo
expect "a step alone" 0 "1 of 1 step" ./course check 99.1

set_step 99.2 'return next(n) * 2;'
expect "a wrong step" 1 "tests/$name/tiny_test.cpp:9: rt::after_next" ./course check 99
expect "the values are shown" 1 "came out: 4, expected 3" ./course check 99
expect_state "a wrong step" 99.2 failed

start_again; set_step 99.1 'return n;'; set_step 99.2 'return n;'
expect "what may follow from another step says so" 1 "99.2 .*perhaps because of 99.1" ./course check 99
expect "and how it is seen" 1 "./course check 99.2 shows all about that step" ./course check 99
expect "by itself" 1 "after the next comes the next's next" ./course check 99.2

start_again; set_step 99.1 'int* p = nullptr; return *(volatile int*)p;'; set_step 99.2 'return n + 2;'
expect "a crash is named" 1 'crashed \(segmentation fault\) in the test "after one comes two"' ./course check 99
expect "and its place" 1 " in next, $exercise:$(line_of nullptr)$" build/bin/course check 99
expect_state "a crash costs its step" 99.1 failed
expect_state "a crash costs its step" 99.2 passed

start_again; set_step 99.1 'volatile bool on = true; while (on) {} return n;'; set_step 99.2 'return n + 2;'
expect "a hang is named" 1 'did not finish in 10 s in the test "after one comes two"' ./course check 99
expect_state "a hang costs its step" 99.2 passed
expect "and its place is told" 0 "in next, $exercise:$(line_of while)\"" ./course list --json
start_again; set_step 99.1 'return n + 1;'
set_step 99.2 'std::vector<int> v(2); for (int i = 0; i <= n + 1; ++i) v[i + 0u] = i; return n + v[1];'
sed -i 's/^namespace rt/#include <iostream>\n#include <vector>\n&/' $exercise
expect "a step past the end of a vector" 1 " an index is out of range in after_next, $exercise:$(line_of 'vector<int> v')" \
    ./course check 99
start_again; set_step 99.1 'volatile int k = n; return next(n + 1) + k;'; set_step 99.2 'if (n > 1) return 3;'
# Warnings, whether or not they are errors elsewhere.
sed -i 's/^namespace rt/#pragma GCC diagnostic warning "-Wreturn-type"\n#pragma GCC diagnostic warning "-Winfinite-recursion"\n&/' $exercise
expect "a recursion without end" 1 " next called itself without end, $exercise:$(line_of 'next\(n . 1\)')$" ./course check 99
expect "the compiler warns of a missing return" 1 "$exercise:[0-9:]+ warning: .*-Wreturn-type" build/bin/course check 99
expect "and tells other programs" 1 '"warnings":\["'"$exercise"'[^]]*-Wreturn-type' build/bin/course check 99 --json
start_again; set_step 99.1 'std::printf("n is %d\\n", n); return n + 1;'
sed -i 's/^namespace rt/#include <cstdio>\n&/' $exercise
expect "what they print is shown" 1 "^ *n is 1$" ./course check 99
expect "with its test" 1 'Printed in the test "after one comes two"' build/bin/course check 99
expect "to other programs as well" 1 '"prints":\[\{"test":"after one comes two","lines":\["n is 1"' \
    build/bin/course check 99 --json
start_again; sed -i '/^int next/,/^$/d' $exercise
expect "a function that was deleted is named" 1 "has no function int next\(int n\) of step 99.1; .*reset 99.1" \
    ./course check 99
expect "and comes back" 0 "$exercise has int next\(int n\) again" ./course reset 99.1
cmp -s $exercise "$COURSE_BUILD/scratch/tiny.start" || fail "a function comes back where it was"
rm $exercise.*.backup

start_again; set_step 99.1 'return nextt(n);'
expect "a compile error is shown" 1 "$exercise:[0-9]+:[0-9]+: error: .*nextt" ./course check 99
expect "and said at every step" 1 '"state":"failed","message":"'"$exercise" ./course check 99 --json
expect "other chapters are checked all the same" 1 '○ 98.1' ./course check 98 99
expect "the next thing to do" 0 "Next:" ./course

# ------------------------------------------------------------------------------------ watched at work

python3 "$COURSE_ROOT/tests/program/scratch/watch.py" || failures=$((failures + 1))
expect "no terminal, no watch" 2 "^--watch needs a terminal" build/bin/course check 98 --watch

# ---------------------------------------------------------------------------------- several at once

# The right code passes, however many look at it, and whatever is being built anew meanwhile.
start_again; set_step 99.1 'return n + 1;'; set_step 99.2 'return n + 2;'
for one in 1 2 3 4; do
    sed -i "1s|.*|// Check $one.|" $exercise  # so that there is something to build
    ./course check 99 >"$COURSE_BUILD/scratch/at_once.$one" 2>&1 &
done
wait
for one in 1 2 3 4; do
    grep -q '2 of 2 steps' "$COURSE_BUILD/scratch/at_once.$one" ||
        fail "four at once" "$(cat "$COURSE_BUILD/scratch/at_once.$one")"
done
expect_state "four at once, remembered" 99.1 passed
[ -z "$(ls build/runs)" ] || fail "nothing is left of them" "$(ls build/runs)"

flock .course/build.lock sleep 3 &
sleep 1
echo '1234: Building chapter 98' >.course/build.lock
expect "what is waited for is said" 0 'Waiting for another ./course \(process 1234, Building chapter 98\)' ./course list
wait
flock .course/build.lock sleep 2 &
sleep 1
echo '1234: Building chapter 98' >.course/build.lock
expect "by the program, too" 0 'Waiting for another ./course \(process 1234, Building chapter 98\)' build/bin/course check 99
wait

# --------------------------------------------------------------------------- a link, and what is kept

ln -s "$copy" "$COURSE_BUILD/scratch/link"
: >build/witness
(cd "$COURSE_BUILD/scratch/link" && ./course list >/dev/null 2>&1) || fail "through a link of the directory"
(cd "$COURSE_BUILD/scratch/link" && ./course check 99 >/dev/null 2>&1) || fail "through a link of the directory"
[ -e build/witness ] || fail "a link does not build anew"
rm "$COURSE_BUILD/scratch/link"
expect_state "and keeps what is known" 99.1 passed

cp -p $exercise "$COURSE_BUILD/scratch/tiny.mine"
rm $exercise
expect "a deleted file is named" 1 "$exercise is missing; ./course reset 99" ./course check 99
expect "by who needs it" 2 "$exercise is missing; ./course reset 99" \
    ./course trace references/$name/one.scene 8 6 --against solutions
expect "a deleted file comes back" 0 "$exercise was missing and is back" ./course reset 99
cmp -s $exercise "$COURSE_BUILD/scratch/tiny.start" || fail "as it was at the start"
expect "and can be built" 1 "0 of 2 steps" ./course check 99

# ------------------------------------------------------------------------------- hints and fresh starts

expect "the first hint" 0 "Hint 1 of 3: first" ./course hint 99.1
expect "the second" 0 "Hint 2 of 3: second" ./course hint 99.1
expect "another step begins at its first" 0 "Hint 1 of 3: a" ./course hint 99.2
expect "the third" 0 "Hint 3 of 3: third" ./course hint 99.1
expect "no more" 0 "No hints are left" ./course hint 99.1
expect "all again" 0 "Hint 1 of 3: first" ./course hint 99.1 --all

start_again; set_step 99.1 'return n + 1; // mine'; set_step 99.2 'return n + 2; // mine'
expect "a step is reset" 0 "tiny.cpp.001.backup" ./course reset 99.1
grep -q 'return todo("99.1");' $exercise || fail "the step is back"
grep -q 'return n + 2; // mine' $exercise || fail "the other step is kept"
grep -q 'return n + 1; // mine' $exercise.001.backup || fail "the backup has what was there"
expect "the chapter is reset" 0 "tiny.cpp.002.backup" ./course reset 99
cmp -s $exercise "$COURSE_BUILD/scratch/tiny.start" || fail "the chapter is as it was at the start"
expect "nothing is left to reset" 0 "Nothing to reset" ./course reset 99
printf 'int other() { return 1; }\n' >$exercise
expect "a step that is gone cannot be reset alone" 2 "no function 'int next\(int n\)' any more" ./course reset 99.1
start_again

# ----------------------------------------------------------------------------------- passing the chapter

expect "no spoiling" 1 "./course solution 99.1 --spoil" ./course solution 99.1
set_step 99.1 'return 1 + n;'; set_step 99.2 'return n + 2;'
expect "all passes, and there is a picture" 0 "Your picture: build/pictures/$name/one.png" ./course check 99
[ -s build/pictures/$name/one.png ] || fail "the picture is there"
expect "other programs are told where" 0 '"prints":\[.*"warnings":\[\],"picture":"build/pictures/'"$name"'/one.png"' \
    ./course check 99 --json
expect "a step that passes has a picture of its own" 0 "Your picture: build/pictures/$name/99.2.png" \
    ./course check 99.2
[ -s build/pictures/$name/99.2.png ] || fail "the picture is there"
expect "one that names none, the chapter's" 0 "Your picture: build/pictures/$name/one.png" ./course check 99.1
expect "both are shown after passing" 0 "return 1 \+ n;" ./course solution 99.1
expect "a render says whose code it used" 0 "your code for 99, solutions for the rest" \
    ./course render references/$name/one.scene -o mine.png
expect "or is told to use the solutions" 0 "solutions for all chapters" \
    ./course render references/$name/one.scene -o theirs.png --solutions
cmp -s mine.png theirs.png || fail "both pictures are the same"
expect "what is not started is the solutions'" 0 "your code for 99, solutions for the rest" \
    ./course render references/$name/one.scene -o mine.png --mine
start_again; set_step 99.1 'return 1 + n;'
expect "and in a chapter that is half written, too" 0 "your code for 99.1, solutions for the rest" \
    ./course trace references/$name/one.scene 8 6 --mine
start_again
expect "nothing is called the student's that is not begun" 0 "nothing of yours is begun" \
    ./course trace references/$name/one.scene 8 6 --mine
set_step 99.1 'return 1 + n;'; set_step 99.2 'return n + 2;'
./course check 99 >/dev/null || fail "it passes again"

# ------------------------------------------------------------------------------------- a mistake is seen

cp solutions/02_spheres/*.cpp chapters/02_spheres/
build/bin/course-tool change "$COURSE_ROOT/tests/02_spheres/mistakes/02.3_only_the_near_root.mistake" \
    solutions/02_spheres chapters/02_spheres/sphere.cpp
expect "a failed step is drawn, and what is wrong is said" 1 \
    "at pixel \(44, 26\): your ray hits nothing, expected the sphere of line [0-9]+ – step 02.3" ./course check 02.3
[ -s build/pictures/02_spheres/02.3.png ] || fail "the picture is there"
expect "its pixel is followed to the step" 1 "Look at step 02.3" \
    ./course trace references/02_spheres/inside.scene 44 26 --size 80x60 --against solutions
./course reset 02 >/dev/null

# ------------------------------------------------------------------------------------- a build is erased

# All but the program itself, so that it need not be built once more.
find build -mindepth 1 -maxdepth 1 ! -name bin -exec rm -rf {} +
expect "hints taken are remembered" 0 "No hints are left" build/bin/course hint 99.1
expect_state "and results" 99.1 passed

finish
