// What one kernel is: methods of one intersection, timed in turns and judged one by one.
#pragma once

#include "common/math/vec.hpp"
#include "tests/oracle/enclosure.hpp"
#include "tests/report/cpu_clock.hpp"
#include "tests/report/formulas.hpp"
#include "tests/report/kernels.hpp"
#include "tests/report/statistics.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rt::report {

/// The first seed of the kernels' cases.
inline constexpr std::uint64_t kernel_seed = 20;

/// A method of answering a case; the answers' points have the look in the plot.
template <class Case>
struct Method {
    const char* method;
    const char* number;
    Look look;
    Answer (*ask)(const Case&);
    bool course = false;
};

/// What an interval says: its middle, and half its width.
inline Answer answer_of(const oracle::Enclosure& enclosure) {
    using Kind = Answer::Kind;
    const Kind kinds[] = {Kind::Miss, Kind::Hit, Kind::Unknown};
    const Kind kind = kinds[static_cast<int>(enclosure.decision)];
    // The halves first, so that infinite ends do not make a NaN of the width.
    return {kind, enclosure.low / 2 + enclosure.high / 2, enclosure.high / 2 - enclosure.low / 2};
}

struct Judged {
    Real error = -1;  ///< in units of κu|t|; negative where there is none to judge
    bool wrong = false;
};

/// One shape: the methods of meeting it, and cases, drawn from a family that is described in words.
template <class Case>
struct Kernel {
    const char* shape;
    const char* family;
    std::span<const Method<Case>> methods;
    std::vector<Case> cases;
    Judged (*judge)(const Case&, const Answer&);
};

/// How much of the cases are of surfaces that exact arithmetic takes long for.
inline constexpr std::size_t slow_part = 20;

void measure_spheres(const KernelOptions& options, Kernels& kernels, const Told& told);
void measure_triangles(const KernelOptions& options, Kernels& kernels, const Told& told);
void measure_tori(const KernelOptions& options, Kernels& kernels, const Told& told);
void measure_quadrics(const KernelOptions& options, Kernels& kernels, const Told& told);
void measure_implicits(const KernelOptions& options, Kernels& kernels, const Told& told);

/// Where the digits of a sphere's t are lost.
std::vector<DigitsMap> measure_maps(const KernelOptions& options, const Told& told);

inline volatile Real sink = 0;  // what is measured must not be optimised away

/// CPU seconds for `rounds` times all the cases.
template <class Case>
double seconds(const Method<Case>& method, std::span<const Case> cases, int rounds) {
    const double start = cpu_seconds();
    Real sum = 0;
    for (int round = 0; round < rounds; ++round)
        for (const Case& item : cases) sum += method.ask(item).t;
    sink = sum;
    return cpu_seconds() - start;
}

/// Nanoseconds a call, for each method. The repeats of all methods take turns, so that whatever else the
/// machine does falls on all of them.
template <class Case>
std::vector<double> nanoseconds(std::span<const Method<Case>> methods, std::span<const Case> all,
                                const KernelOptions& options, const Told& told) {
    const std::span<const Case> cases = all.first(std::min<std::size_t>(all.size(), 4096));
    std::vector<int> rounds;
    for (const Method<Case>& method : methods) {
        const double once = seconds(method, cases, 1);
        rounds.push_back(std::max(1, static_cast<int>(options.repeat_ms * 1e-3 / once)));
    }
    std::vector<std::vector<double>> times(methods.size());
    for (int repeat = 0; repeat < options.repeats; ++repeat) {
        for (std::size_t i = 0; i < methods.size(); ++i)
            times[i].push_back(seconds(methods[i], cases, rounds[i]) * 1e9 /
                               (rounds[i] * static_cast<double>(cases.size())));
        told((repeat + 1.0) / options.repeats);
    }
    std::vector<double> medians;
    for (std::vector<double>& time : times) medians.push_back(median(std::move(time)));
    return medians;
}

template <class Case>
void measure(const Kernel<Case>& kernel, const KernelOptions& options, Kernels& kernels, const Told& told) {
    kernels.families.push_back({kernel.shape, kernel.family, kernel.cases.size()});
    const std::span<const Method<Case>> methods = kernel.methods;
    const std::vector<double> ns =
        nanoseconds(methods, std::span(kernel.cases), options, [&](double part) { told(part / 2); });
    for (std::size_t i = 0; i < methods.size(); ++i) {
        KernelRow row;
        row.shape = kernel.shape;
        row.method = methods[i].method;
        row.number = methods[i].number;
        row.look = methods[i].look;
        row.course = methods[i].course;
        row.ns = ns[i];
        row.cases = kernel.cases.size();
        std::vector<double> errors;
        for (const Case& item : kernel.cases) {
            const Answer answer = methods[i].ask(item);
            const Judged judged = kernel.judge(item, answer);
            row.wrong += judged.wrong;
            row.undecided += answer.kind == Answer::Kind::Unknown;
            if (judged.error >= 0 && !judged.wrong) errors.push_back(judged.error);
        }
        row.error_max = quantile(errors, 1);
        row.error_9999 = quantile(errors, 0.9999);
        row.error_median = quantile(errors, 0.5);
        kernels.rows.push_back(std::move(row));
        told(0.5 + (static_cast<double>(i) + 1) / (2 * static_cast<double>(methods.size())));
    }
}

}  // namespace rt::report
