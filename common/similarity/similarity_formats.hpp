// The report of similar submissions, in the forms in which an instructor reads it.
#pragma once

#include "common/similarity/similarity_report.hpp"

#include <string>
#include <vector>

namespace rt {

/// For a terminal: of each chapter the most similar pairs.
std::string similarity_text(const std::vector<ChapterSimilarity>& report);

/// A row a pair, as `csv` in formats.hpp writes its fields.
std::string similarity_csv(const std::vector<ChapterSimilarity>& report);

/// All pairs with all their parts.
std::string similarity_json(const std::vector<ChapterSimilarity>& report);

/// A page with the parts of the most similar pairs side by side; nothing loaded from elsewhere.
std::string similarity_page(const std::vector<ChapterSimilarity>& report);

}  // namespace rt
