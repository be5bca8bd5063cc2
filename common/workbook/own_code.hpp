// What of the course's code is the student's: whole chapters, and chapters that are half written, in which
// the solutions fill in what is not begun.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

struct OwnCode {
    std::vector<const Chapter*> whole;  ///< chapters whose exercises are used as they are
    /// Files of other chapters, as "02_spheres/sphere.cpp", of which something is written: they are filled
    /// in.
    std::vector<std::string> filled;
    std::vector<std::string> steps;  ///< of those chapters, which are begun
};

/// All that the student has begun; in a handout, where there is nothing to fill in with, all chapters.
OwnCode own_code(const Project& project, const std::vector<Chapter>& chapters);

inline bool is_empty(const OwnCode& own) { return own.whole.empty() && own.filled.empty(); }

/// "01, 02.1, 02.2": whole chapters, and steps.
std::string in_words(const OwnCode& own);

/// The chapter's steps of which at least one function is written.
std::vector<std::string> begun_steps(const Project& project, const Chapter& chapter);

/// A student's file with the solution's functions in place of those that are not begun. Messages of compilers
/// name the lines of both files, `name` as "02_spheres/sphere.cpp".
std::string filled_text(const std::string& mine, const std::string& pristine, const std::string& solution,
                        const std::string& name);

/// Writes the filled files into build/mine, those that have changed.
void write_filled(const Project& project, const OwnCode& own);

}  // namespace rt
