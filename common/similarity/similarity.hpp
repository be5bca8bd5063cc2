// How much of their code people have in common, whatever it is called and wherever it stands.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace rt {

/// What somebody wrote for a chapter.
struct CodeSample {
    std::string name;
    std::map<std::string, std::string> files;  ///< texts by name
};

/// Lines of one of a sample's files, counted from 1, both ends included.
struct CodePlace {
    std::string file;
    int first_line = 0;
    int last_line = 0;
};

/// A part that two samples share, token by token.
struct SharedPart {
    CodePlace first, second;
    int tokens = 0;
};

struct SimilarPair {
    std::size_t first = 0, second = 0;             ///< numbers of the samples
    int shared = 0;                                ///< tokens
    double similarity = 0;                         ///< 2 · shared / (tokens of the first + of the second)
    double part_of_first = 0, part_of_second = 0;  ///< shared / tokens of the one, and of the other
    std::vector<SharedPart> parts;                 ///< the longest first
};

struct Similarities {
    std::vector<int> tokens;         ///< of each sample's own code
    std::vector<SimilarPair> pairs;  ///< the most similar first
    std::size_t compared = 0;        ///< pairs
    std::size_t similar = 0;         ///< of these, pairs of at least `least_similarity`
    double median = 0;               ///< similarity of those compared; 0 if there are none
};

/// `gram` and `least_tokens` were chosen by a measurement, which `test_grading "[measure]"` repeats: of all
/// chapters, copies that are renamed, reordered and laid out anew have a similarity of 0.98 at least; those
/// that have also a new line after every fifth statement, 0.88; and two right programs of ours that solve
/// every step in another way, 0.74 at most. Longer parts part copies from others no better and miss more of a
/// copy that was edited; shorter ones are shared by everybody.
struct SimilarityOptions {
    std::size_t gram = 8;  ///< tokens of what is hashed; of what was handed out, the least that counts
    std::size_t least_tokens = 20;  ///< of a shared part, at least `gram`
    double least_similarity = 0;    ///< of a pair that is listed
    std::size_t most_pairs = 1000;  ///< that are listed
};

/// Compares each sample with each other, but not the last `known` among themselves: those are known answers.
///
/// What was handed out, `given`, is nobody's own, and neither are fewer than `least_tokens` tokens in a row
/// between two parts of it. A sample without any of its own is compared with none. Of the rest, every part of
/// at least `least_tokens` tokens that two samples share is found, in whatever order they have them
/// (Schleimer, Wilkerson & Aiken 2003: a window of `least_tokens` - `gram` + 1 hashes); only where a sample
/// has one gram more than eight times, the later ones may be missed. No token is shared twice. The measure is
/// JPlag's average similarity (Prechelt, Malpohl & Philippsen 2002).
Similarities similarities(std::span<const CodeSample> samples,
                          const std::map<std::string, std::string>& given, std::size_t known,
                          const SimilarityOptions& options);

}  // namespace rt
