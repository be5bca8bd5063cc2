#!/usr/bin/env bash
# What it costs that a student's chapter runs in another process: each chapter's tests as `course check` runs them,
# with the solutions in a worker, against the same tests in one process. For a quiet machine, by hand:
#   ninja -C build judges tests && bash tests/grading/measure.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
chmod 755 "$place"  # a worker has a uid of its own
worker=$place/worker
g++ -o "$worker" -Wl,--start-group build/grading/*.a -Wl,--end-group -ltbb -lfmt -lspng -pthread
told=(--worker "$worker" --isolation none)

seconds() {  # seconds TESTS...: of wall clock, the median of five runs, which must pass
    local TIMEFORMAT=%R
    for _ in 1 2 3 4 5; do
        { time "$@" --quick >"$place/said"; } 2>&1 || { tail -n 20 "$place/said" >&2 && exit 1; }
    done | sort -n | sed -n 3p
}

printf 'chapter  one process, s  judge, s  ratio\n'
for judge in build/bin/judge_??; do
    number=${judge##*_}
    here=$(seconds "build/bin/check_${number}_solution" --seed 5)
    there=$(seconds "$judge" "${told[@]}" --seed 5)
    awk -v n="$number" -v a="$here" -v b="$there" 'BEGIN { printf "%7s  %14.2f  %8.2f  %5.1f\n", n, a, b, b / a }'
done

# One function, called again and again.
test="no ray slips through between two triangles" calls=370000
here=$(seconds build/bin/check_03_solution "$test")
there=$(seconds build/bin/judge_03 "${told[@]}" "$test")
awk -v a="$here" -v b="$there" -v n=$calls 'BEGIN { printf "%d calls a second\n", n / (b - a) }'
