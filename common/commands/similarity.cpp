// `course similarity`: what submissions share with each other, with the solution and with the variants.
#include "common/commands/commands.hpp"
#include "common/grading/class_list.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/similarity/similarity_formats.hpp"
#include "common/workbook/chosen_chapters.hpp"

#include <fmt/format.h>

#include <map>

namespace rt {

namespace fs = std::filesystem;

namespace {

using Format = std::string (*)(const std::vector<ChapterSimilarity>&);

Format format_of(const fs::path& output) {
    static const std::map<fs::path, Format> formats{
        {".html", similarity_page}, {".csv", similarity_csv}, {".json", similarity_json}};
    const auto found = formats.find(output.extension());
    if (found == formats.end())
        throw InputError(
            fmt::format("{}: expected a name that ends in .html, .csv or .json", printable(output.string())));
    return found->second;
}

}  // namespace

int run_similarity(const SimilarityCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Format format = command.output.empty() ? similarity_text : format_of(command.output);
    if (!command.output.empty()) require_writable(command.output);
    const std::vector<const Chapter*> asked = named_chapters(chapters, command.chapters);
    const std::vector<Submission> submissions =
        read_class(class_list(command.submissions), {}, project, asked, isolation_named(command.isolation));

    SimilarityOptions options;
    options.least_similarity = command.least / 100.0;
    const std::vector<ChapterSimilarity> report = similarity_report(project, asked, submissions, options);
    if (!command.output.empty()) write_file(command.output, format(report));
    if (command.json)
        fmt::print("{}", similarity_json(report));
    else if (command.output.empty())
        fmt::print("{}", format(report));
    return 0;
}

}  // namespace rt
