// How much of their code people have in common, whatever it is called and wherever it stands.
#include "common/similarity/similarity.hpp"

#include "common/similarity/tiling.hpp"
#include "common/similarity/tokens.hpp"
#include "common/similarity/winnowing.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace rt {
namespace {

/// More of the same in one sample tell nothing more, and would take time.
constexpr int most_of_a_gram = 8;

/// A gram that stands for those around it.
struct Print {
    std::uint64_t hash = 0;
    std::size_t at = 0;  ///< of its first token
};

/// The tokens of some files, one after the other. Kind 0 is what is not compared, and what parts two files.
struct Sequence {
    std::vector<std::uint16_t> kinds;
    std::vector<int> lines;
    std::vector<std::pair<std::size_t, std::string>> files;  ///< where each begins, and its name
    std::vector<Print> prints;
    int own = 0;  ///< tokens that are compared
};

Sequence sequence_of(const std::map<std::string, std::string>& files) {
    Sequence sequence;
    for (const auto& [name, text] : files) {
        sequence.files.emplace_back(sequence.kinds.size(), name);
        for (const Token& token : tokens_of(text)) {
            sequence.kinds.push_back(token.kind);
            sequence.lines.push_back(token.line);
        }
        sequence.kinds.push_back(0);
        sequence.lines.push_back(0);
    }
    return sequence;
}

/// Calls `visit` with the begin and the end of each part without 0.
template <class Visit>
void for_parts(const std::vector<std::uint16_t>& kinds, Visit visit) {
    for (std::size_t begin = 0, end = 0; begin < kinds.size(); begin = end + 1) {
        for (end = begin; end < kinds.size() && kinds[end] != 0;) ++end;
        if (end > begin) visit(begin, end);
    }
}

std::vector<Print> prints_of(const Sequence& sequence, std::size_t gram, std::size_t window) {
    std::vector<Print> prints;
    std::unordered_map<std::uint64_t, int> count;
    const std::span<const std::uint16_t> kinds = sequence.kinds;
    for_parts(sequence.kinds, [&](std::size_t begin, std::size_t end) {
        const std::vector<std::uint64_t> hashes = hashes_of_grams(kinds.subspan(begin, end - begin), gram);
        for (const std::size_t at : winnowed(hashes, window))
            if (++count[hashes[at]] <= most_of_a_gram) prints.push_back({hashes[at], begin + at});
    });
    return prints;
}

/// All prints, to be asked who has one.
class PrintIndex {
public:
    void add(std::size_t sample, const std::vector<Print>& prints) {
        for (const Print& print : prints) places_[print.hash].emplace_back(sample, print.at);
    }

    /// Calls `visit` with the sample and the place of everybody who has it.
    template <class Visit>
    void for_all_with(std::uint64_t hash, Visit visit) const {
        if (const auto found = places_.find(hash); found != places_.end())
            for (const auto& [sample, at] : found->second) visit(sample, at);
    }

private:
    std::unordered_map<std::uint64_t, std::vector<std::pair<std::size_t, std::size_t>>> places_;
};

/// What was handed out, with all its grams.
struct Given {
    Sequence sequence;
    PrintIndex index;

    Given(const std::map<std::string, std::string>& files, std::size_t gram) : sequence(sequence_of(files)) {
        index.add(0, prints_of(sequence, gram, 1));
    }
};

/// Leaves a sample what is its own, and long enough to be compared.
void take_out(Sequence& sample, const Given& given, const SimilarityOptions& options) {
    std::vector<std::pair<std::size_t, std::size_t>> begun;
    for (const Print& print : prints_of(sample, options.gram, 1))
        given.index.for_all_with(print.hash,
                                 [&](std::size_t, std::size_t at) { begun.emplace_back(print.at, at); });
    const auto forget = [&](std::size_t begin, std::size_t count) {
        std::fill_n(&sample.kinds[begin], count, std::uint16_t{0});
    };
    for (const SharedRun& run : shared_runs(sample.kinds, given.sequence.kinds, begun, options.gram))
        forget(run.first, run.length);
    for_parts(sample.kinds, [&](std::size_t begin, std::size_t end) {
        if (end - begin < options.least_tokens)
            forget(begin, end - begin);
        else
            sample.own += static_cast<int>(end - begin);
    });
}

CodePlace place_of(const Sequence& sequence, std::size_t begin, std::size_t length) {
    const auto behind = std::find_if(sequence.files.begin(), sequence.files.end(),
                                     [&](const auto& file) { return file.first > begin; });
    return {std::prev(behind)->second, sequence.lines[begin], sequence.lines[begin + length - 1]};
}

/// A pair whose places are still to be looked up: of most pairs nobody asks for them.
struct FoundPair {
    SimilarPair pair;
    std::vector<SharedRun> runs;
};

FoundPair found_pair(std::size_t first, std::size_t second, const std::vector<Sequence>& sequences,
                     std::vector<SharedRun> runs) {
    SimilarPair pair{first, second, 0, 0, 0, 0, {}};
    for (const SharedRun& run : runs) pair.shared += static_cast<int>(run.length);
    const int first_own = sequences[first].own, second_own = sequences[second].own;
    pair.similarity = 2.0 * pair.shared / (first_own + second_own);
    pair.part_of_first = static_cast<double>(pair.shared) / first_own;
    pair.part_of_second = static_cast<double>(pair.shared) / second_own;
    return {std::move(pair), std::move(runs)};
}

/// Of a sample all pairs with later ones.
std::vector<FoundPair> pairs_with(std::size_t sample, const std::vector<Sequence>& sequences,
                                  const PrintIndex& index, std::size_t least_tokens) {
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> begun(sequences.size());
    for (const Print& print : sequences[sample].prints)
        index.for_all_with(print.hash, [&](std::size_t other, std::size_t at) {
            if (other > sample) begun[other].emplace_back(print.at, at);
        });
    std::vector<FoundPair> pairs;
    for (std::size_t other = sample + 1; other < sequences.size(); ++other)
        if (sequences[sample].own > 0 && sequences[other].own > 0)
            pairs.push_back(found_pair(
                sample, other, sequences,
                shared_runs(sequences[sample].kinds, sequences[other].kinds, begun[other], least_tokens)));
    return pairs;
}

/// Sorts the pairs, and looks up the places of those that are listed.
std::vector<SimilarPair> listed(std::vector<FoundPair>& found, const std::vector<Sequence>& sequences,
                                std::size_t most) {
    std::stable_sort(found.begin(), found.end(), [](const FoundPair& a, const FoundPair& b) {
        return a.pair.similarity > b.pair.similarity;
    });
    if (found.size() > most) found.resize(most);
    std::vector<SimilarPair> pairs;
    for (FoundPair& each : found) {
        SimilarPair pair = std::move(each.pair);
        for (const SharedRun& run : each.runs)
            pair.parts.push_back({place_of(sequences[pair.first], run.first, run.length),
                                  place_of(sequences[pair.second], run.second, run.length),
                                  static_cast<int>(run.length)});
        pairs.push_back(std::move(pair));
    }
    return pairs;
}

/// The upper one of two.
double median_of(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

Similarities similarities(std::span<const CodeSample> samples,
                          const std::map<std::string, std::string>& files, std::size_t known,
                          const SimilarityOptions& options) {
    const Given given(files, options.gram);
    Similarities result;
    std::vector<Sequence> sequences;
    PrintIndex index;
    for (const CodeSample& sample : samples) {
        Sequence sequence = sequence_of(sample.files);
        take_out(sequence, given, options);
        sequence.prints = prints_of(sequence, options.gram, options.least_tokens + 1 - options.gram);
        index.add(sequences.size(), sequence.prints);
        result.tokens.push_back(sequence.own);
        sequences.push_back(std::move(sequence));
    }
    std::vector<double> all;
    std::vector<FoundPair> similar;
    for (std::size_t sample = 0; sample + known < samples.size(); ++sample)
        for (FoundPair& found : pairs_with(sample, sequences, index, options.least_tokens)) {
            all.push_back(found.pair.similarity);
            if (all.back() >= options.least_similarity) similar.push_back(std::move(found));
        }
    result.compared = all.size();
    result.similar = similar.size();
    result.pairs = listed(similar, sequences, options.most_pairs);
    result.median = median_of(std::move(all));
    return result;
}

}  // namespace rt
