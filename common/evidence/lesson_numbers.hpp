// Numbers in a chapter's pages against the tables that programs wrote.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A number as a person writes it, "3,221", "2.6", "−7·10⁻¹⁶", "10⁸", "7 \cdot 10^{-16}" or "1e-7".
struct WrittenNumber {
    double value = 0;
    double unit = 0;  ///< what a 1 in its last digit means; zeros at the end of a whole number are no digits
};

/// The last number of a text, whatever stands behind it, such as " ms" or " %".
std::optional<WrittenNumber> last_number(const std::string& text);

/// What is wrong with the numbers of a page that are tied to a table, a line each: "README.md:42: 3221 should
/// be 3219 (far_sphere.csv, '1e8', …)". Marks are described in CONTRIBUTING.md. `figures` is where the tables
/// are.
std::vector<std::string> wrong_numbers(const std::string& page, const std::string& name,
                                       const std::filesystem::path& figures,
                                       const std::filesystem::path& root);

}  // namespace rt
