// Which chapters a class gets.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <string>
#include <vector>

namespace rt {

/// The chapters that "1-5" or "1" names: from the first to another. All for an empty text. Throws InputError
/// for a text of another form, for numbers of no chapter, and if the first is not among them, because each
/// stands on those before it.
std::vector<Chapter> chosen_chapters(const std::vector<Chapter>& chapters, const std::string& text);

}  // namespace rt
