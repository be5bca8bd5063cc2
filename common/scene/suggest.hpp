// "Did you mean …?": the nearest of some names to a word that is none of them.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rt {

/// Whether they are the same but for upper and lower case, in every locale.
bool same_letter(char a, char b);

/// Number of letters to insert, delete, replace or swap with a neighbour to get from one word to the other,
/// upper and lower case taken for the same (the optimal string alignment of Damerau 1964).
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `word`, the first of equal ones; nothing where every candidate differs in more
/// than a third of the word's letters (at least one may differ). A word of three letters or more that only
/// one candidate begins with is near, however long the rest.
std::optional<std::string> suggest(std::string_view word, std::span<const std::string_view> candidates);

/// `; did you mean 'popTransform'?`, or an empty string where nothing is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace rt
