// Mutants that are right, too: no test can notice them, and nobody has to look at them again.
#pragma once

#include "common/evidence/mutants.hpp"
#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// What an entry of tests/NN_name/variants/equivalent.mutants says of one mutant.
struct EquivalentMutant {
    std::string step;
    std::string from, to;  ///< the lines as in Mutant
    std::string why;       ///< it does what the solution does
    int line = 0;          ///< of `to` in the list
};

/// Reads a list: entries of lines `step NN.S`, `from …`, one or more `to …`, `why …`. `name` is its file's
/// name for messages. Throws InputError, with file and line, for anything else.
std::vector<EquivalentMutant> parse_equivalent(std::string_view text, const std::string& name);

/// The list of a chapter, and its name; nothing is listed where there is no file.
std::string equivalent_list(const Chapter& chapter);
std::vector<EquivalentMutant> equivalent_mutants(const Project& project, const Chapter& chapter);

/// Whether the entry is about this mutant.
bool is_about(const EquivalentMutant& entry, const Mutant& mutant);

/// One line for each entry that is about none of these mutants: its line was changed since.
std::vector<std::string> stale_entries(const std::vector<EquivalentMutant>& entries,
                                       const std::vector<Mutant>& mutants, const std::string& name);

}  // namespace rt
