// Sturm's theorem with exact numbers: for the oracle's own .cpp files, in which CGAL stays.
#pragma once

#include "tests/oracle/exact.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace rt::oracle {

/// A polynomial and its Sturm sequence, in whole numbers times powers of two: each remainder may be
/// multiplied by any positive number, so nothing is ever divided.
class Sturm {
public:
    /// From the lowest coefficient to the highest; some of the last may be 0.
    explicit Sturm(std::vector<Exact> coefficients) {
        trim(coefficients);
        chain.push_back(std::move(coefficients));
        std::vector<Exact> slope;
        for (std::size_t i = 1; i < chain[0].size(); ++i)
            slope.push_back(chain[0][i] * Exact(static_cast<int>(i)));
        while (!slope.empty()) {
            chain.push_back(std::move(slope));
            slope = negative_remainder(chain[chain.size() - 2], chain.back());
        }
    }

    int sign_at(const Exact& t) const { return sign_of(chain[0], t); }

    /// How many different real roots are in (low, high]; an end that is missing is infinite.
    int roots(const std::optional<Exact>& low, const std::optional<Exact>& high) const {
        return changes(low, -1) - changes(high, 1);
    }

private:
    std::vector<std::vector<Exact>> chain;

    static void trim(std::vector<Exact>& a) {
        while (!a.empty() && CGAL::sign(a.back()) == 0) a.pop_back();
    }

    static int sign_of(const std::vector<Exact>& a, const Exact& t) {
        Exact value(0);
        for (std::size_t i = a.size(); i-- > 0;) value = value * t + a[i];
        return static_cast<int>(CGAL::sign(value));
    }

    static std::vector<Exact> negative_remainder(std::vector<Exact> a, const std::vector<Exact>& b) {
        const bool flip = CGAL::sign(b.back()) < 0;
        const Exact lead = flip ? -b.back() : b.back();
        while (a.size() >= b.size()) {
            const Exact top = flip ? -a.back() : a.back();
            const std::size_t shift = a.size() - b.size();
            for (Exact& x : a) x = x * lead;
            for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] = a[i + shift] - top * b[i];
            trim(a);
        }
        for (Exact& x : a) x = -x;
        return a;
    }

    /// The sign just beyond t, which is 0 for no polynomial: that of the first derivative that is not 0.
    static int sign_beyond(std::vector<Exact> a, const Exact& t) {
        for (;;) {
            if (const int sign = sign_of(a, t); sign != 0) return sign;
            for (std::size_t i = 1; i < a.size(); ++i) a[i - 1] = a[i] * Exact(static_cast<int>(i));
            a.pop_back();
        }
    }

    /// How often the sign changes along the sequence; at −∞ or ∞ (`end`) where there is no t.
    int changes(const std::optional<Exact>& t, int end) const {
        int count = 0, last = 0;
        for (const std::vector<Exact>& a : chain) {
            if (a.empty()) continue;
            int sign = t ? sign_beyond(a, *t) : static_cast<int>(CGAL::sign(a.back()));
            if (!t && end < 0 && a.size() % 2 == 0) sign = -sign;
            count += last != 0 && sign != last;
            last = sign;
        }
        return count;
    }
};

}  // namespace rt::oracle
