// A function of x, y and z, as a scene file writes it, read once into a small program.
#pragma once

#include "common/math/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// What a step of the program does to its stack: pushes a number, changes the top, or takes two numbers off
/// and pushes one.
enum class Operation : std::uint8_t {
    Constant,
    X,
    Y,
    Z,
    Negate,
    Power,  ///< by the step's exponent
    SquareRoot,
    Exponential,
    Logarithm,
    Sine,
    Cosine,
    Absolute,
    Add,
    Subtract,
    Multiply,
    Divide,
    Minimum,
    Maximum,
};

/// How many numbers it takes off the stack.
constexpr std::size_t numbers_taken(Operation operation) {
    return operation <= Operation::Z ? 0 : operation < Operation::Add ? 1 : 2;
}

struct Instruction {
    Operation operation = Operation::Constant;
    int exponent = 0;
    Real constant = 0;
};

/// f(x, y, z). The program leaves one number on the stack, which never holds more than `most_numbers`;
/// common/scene/evaluate.hpp says how to run it. Operations on constants alone have been done, and rounded.
struct Formula {
    std::vector<Instruction> steps;
    std::string text;  ///< as it was read, for messages
};

inline constexpr std::size_t most_numbers = 32;
inline constexpr int greatest_exponent = 64;

/// Everybody who shows a surface shares its program, which nobody changes.
using SharedFormula = std::shared_ptr<const Formula>;

/// The same formula, to be used while its owner keeps it: to count owners takes longer than many a ray.
inline SharedFormula lent(const SharedFormula& f) { return {SharedFormula(), f.get()}; }

/// What is wrong with the text of a formula, and where: `at` is counted from its beginning.
struct FormulaError : std::runtime_error {
    FormulaError(const std::string& what, std::size_t where) : runtime_error(what), at(where) {}
    std::size_t at;
};

/// Reads + − * / ^, parentheses, sqrt, exp, log (the natural one), sin, cos, abs, min, max, numbers, x, y and
/// z. A power binds closer than a sign, −x^2 = −(x^2), and from the right, 2^x^2 = 2^(x^2); by whole numbers
/// from −64 to 64 it is a product, by all others of positive numbers only. Throws FormulaError, also where an
/// operation on constants has no finite value, and where there is no x, y or z.
Formula parse_formula(std::string_view text);

/// f(p/factor): the same function of space in another unit.
Formula in_other_unit(const Formula& f, Real factor);

// What is known of f in a box, which is cut into 16³ parts; as a rule by interval arithmetic.

/// A number that the gradient of f exceeds nowhere in the box, so that f changes by no more than that per
/// unit of length; infinity where none was found, as of sqrt(x) near 0.
Real lipschitz_bound(const Formula& f, const Vec3& low, const Vec3& high);

/// The smallest box of whole parts outside of which f is positive in the box; `low` is greater than `high`
/// where it is so in all of them.
struct PartOfBox {
    Vec3 low{infinity}, high{-infinity};
};
PartOfBox not_positive(const Formula& f, const Vec3& low, const Vec3& high);

/// What |f| is less than in the middle of only a tenth of the parts; 0 where it has no value in any.
Real small_value(const Formula& f, const Vec3& low, const Vec3& high);

/// What it owns in memory.
inline std::size_t bytes_of(const Formula& f) { return f.steps.size() * sizeof(Instruction) + f.text.size(); }

}  // namespace rt
