#!/usr/bin/env bash
# A large class whose marks are known beforehand, a chapter after the other, each in two parts at once. Prints the marks
# that are not as they must be, how many are right, and what a submission takes. By hand, because it takes long; run
# again, it goes on where it was.
#   tests/grading/whole_class.sh [DIRECTORY [SUBMISSIONS [CHAPTER...]]]
# Without arguments: build/class, 34 submissions of each chapter.
set -euo pipefail
cd "$(dirname "$0")/../.."
class=${1:-build/class} count=${2:-34} seed=2027
shift $(($# < 2 ? $# : 2))
[ $# -gt 0 ] || { set -- chapters/[0-9][0-9]_*; set -- "${@#chapters/}"; set -- "${@%%_*}"; }

# mark DIRECTORY CHAPTER: the class in it, into marks.csv.
mark() {
    local part processes=()
    for part in 1 2; do
        build/bin/course grade "$1"/submissions/* --chapter "$2" --seed $seed --part $part/2 -o "$1/part$part.json" &
        processes+=($!)
    done
    for part in "${processes[@]}"; do wait "$part"; done
    build/bin/course grade --merge "$1"/part[12].json -o "$1/marks.csv"
}

# compare DIRECTORY CHAPTER: into `marks` what stands in expected.csv, into `right` the lines that are the same, and
# into `costs` seconds and megabytes.
compare() {
    local steps
    steps=$(head -1 "$1/expected.csv" | tr ',' '\n' | grep -c '^[0-9]')
    tr -d '\r' <"$1/marks.csv" | sed 's/"[^"]*"/quoted/g' >"$1/plain.csv"
    cut -d, -f"1,3-$((steps + 4))" "$1/plain.csv" >"$1/marks"
    tail -n +2 "$1/expected.csv" | grep -xFf - "$1/marks" >"$1/right" || true
    tail -n +2 "$1/plain.csv" | cut -d, -f"$((steps + 6)),$((steps + 7))" >"$1/costs"
    diff --unchanged-line-format= --old-line-format="chapter $2: must be %L" \
        --new-line-format="chapter $2: is      %L" "$1/expected.csv" "$1/marks" || true
}

# summary NAME DIRECTORY...: one line about the classes in them.
summary() {
    local name=$1 right
    shift
    right=$(cat "${@/%//right}" | wc -l)
    cat "${@/%//costs}" | sort -t, -n | awk -F, -v name="$name" -v right="$right" '
        { seconds[NR] = $1; if ($2 > most) most = $2 }
        END { printf "%s: %d of %d marks right; seconds a submission: median %.1f, most %.1f; compilers: %d MB at most\n",
                     name, right, NR, seconds[int((NR + 1) / 2)], seconds[NR], most }'
}

ninja -C build --quiet course make_class judges
for chapter in "$@"; do
    rm -rf "${class:?}/$chapter"
    mkdir -p "$class/$chapter"
    build/bin/make_class "$class/$chapter" "$count" "$seed$chapter" "$chapter"
    mark "$class/$chapter" "$chapter"
    compare "$class/$chapter" "$chapter"
    summary "chapter $chapter" "$class/$chapter"
done
summary "all chapters" "${@/#/$class/}"
