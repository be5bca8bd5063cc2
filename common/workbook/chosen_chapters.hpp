// Which chapters a class gets, and which are marked.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <string>
#include <vector>

namespace rt {

/// The chapters that "1-5" or "1" names: from the first to another. All for an empty text. Throws InputError
/// for a text of another form, for numbers of no chapter, and if the first is not among them, because each
/// stands on those before it.
std::vector<Chapter> chosen_chapters(const std::vector<Chapter>& chapters, const std::string& text);

/// The chapters with these numbers, in this order, or all if there are none. Throws InputError for a number
/// of no chapter.
std::vector<const Chapter*> named_chapters(const std::vector<Chapter>& chapters,
                                           const std::vector<std::string>& numbers);

}  // namespace rt
