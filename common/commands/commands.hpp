// The commands of the program, one function and one file each; every function returns the exit status.
// All throw InputError for what the person has to put right: status 2.
#pragma once

#include "common/terminal/project.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt {

// ---------------------------------------------------------------- where am I

/// `course`: the chapters, and the one next action.
int run_status(bool json);

/// `course list`: chapters and steps with titles, hours, points and state.
int run_list(bool json);

// ---------------------------------------------------------------- learning

struct CheckCommand {
    std::vector<std::string> targets;  ///< "02", "02.1"; empty: the chapter in progress
    bool solutions = false;
    bool watch = false;  ///< go on, and check again what is saved
    bool json = false;
};

/// `course check`: 1 if a step that was asked for has not passed.
int run_check(const CheckCommand& command);

/// `course check --watch`: one step at a time, on a terminal, until all have passed or the person quits.
int run_watch(const CheckCommand& command);

/// `course hint NN.S`: one more hint each time, or all.
int run_hint(const std::string& step, bool all, bool json);

/// `course reset NN[.S]`: back to the exercise; what was there is kept in a backup beside it.
int run_reset(const std::string& target, bool json);

/// `course solution NN.S`: yours and the solution's; 1 before the step has passed, unless `spoil`.
int run_solution(const std::string& step, bool spoil, bool json);

/// `course book`: the lessons as a static site in a directory; empty: the build's.
int run_book(const std::filesystem::path& directory, bool json);

// ---------------------------------------------------------------- pictures

struct RenderCommand {
    std::filesystem::path scene;
    std::filesystem::path output;  ///< empty: what the scene says, else its name with .png
    std::string size;              ///< "WxH", or empty
    std::string integrator;        ///< or empty
    int threads = 0;
    std::optional<int> samples;         ///< a pixel
    std::optional<std::uint64_t> seed;  ///< of the random numbers
    std::optional<double> seconds;      ///< how long to go on with more samples
    std::optional<double> error;        ///< how small the RMS error shall be
    bool solutions = false;
    bool mine = false;
    bool preview = false;
    bool quiet = false;
    bool lenient = false;
    bool json = false;
    std::vector<std::string> arguments;  ///< the whole command line after the program's name
};

/// `course render SCENE`: 1 if the picture needs a step that is not started.
int run_render(const RenderCommand& command);

struct CompareCommand {
    std::filesystem::path image;
    std::filesystem::path reference;
    int within = 1;                 ///< of 255: differences up to this are the same to the eye
    std::filesystem::path diff;     ///< or empty
    std::filesystem::path page;     ///< or empty
    std::filesystem::path scene;    ///< of the pictures: the page shows rays; or empty
    std::string encoding = "srgb";  ///< of 8-bit files
    bool json = false;
    std::vector<std::string> arguments;  ///< as of RenderCommand
};

/// `course compare IMAGE REFERENCE`: 1 if they differ by more.
int run_compare(const CompareCommand& command);

struct ExplainCommand {
    std::filesystem::path scene;
    bool lenient = false;
    bool json = false;
    std::vector<std::string> arguments;  ///< as of RenderCommand
};

/// `course explain SCENE`.
int run_explain(const ExplainCommand& command);

struct TraceCommand {
    std::filesystem::path scene;
    int x = 0;            ///< pixel's column, from the left
    int y = 0;            ///< pixel's row, from the top
    std::string also;     ///< more pixels, as "3,4 5,6": then one JSON object has the trees of all; or empty
    std::string against;  ///< "solutions": the student's tree beside the solutions'; or empty
    std::string size;     ///< WxH: of the picture instead of the scene's; or empty
    bool mine = false;    ///< by the student's code, as far as it is begun
    bool lenient = false;
    bool json = false;
    std::vector<std::string> arguments;  ///< as of RenderCommand
};

/// `course trace SCENE X Y`: the ray tree of one pixel; 1 if the compared trees differ.
int run_trace(const TraceCommand& command);

struct ExportCommand {
    std::filesystem::path scene;
    std::filesystem::path output;
    bool lenient = false;
    bool json = false;
};

/// `course export SCENE -o FILE`: the scene for POV-Ray. Throws InputError also for what POV-Ray cannot
/// express.
int run_export(const ExportCommand& command);

// ---------------------------------------------------------------- the project

struct TourCommand {
    std::filesystem::path output;  ///< directory of the page; empty: `tour` in the build directory
    bool json = false;             ///< one JSON object on standard output instead of the table
    bool quiet = false;            ///< nothing on standard output, no progress
};

/// `course tour`: renders the scenes of all chapters with the implementation that is linked in, compares each
/// with its reference, writes the page and prints a table; 1 if a comparison fails.
int run_tour(const TourCommand& command, const Project& project = this_project());

struct ReportCommand {
    std::string what;              ///< "error-time", "stability" or "leave-out"; empty: all three
    std::filesystem::path output;  ///< directory of the page; empty: `report` in the build directory
    bool quick = false;            ///< fewer cases and samples: a minute or two instead of ten
    bool json = false;
};

/// `course report`: builds and runs the measuring programs, writes their data as CSV, has gnuplot draw them,
/// and writes the page; 1 if what was measured breaks a demand: a family with a wrong answer, a grid that
/// differs from brute force, a scene that pays for what it does not need. Throws InputError where gnuplot,
/// valgrind or the packages of the tests are missing.
int run_report(const ReportCommand& command);

struct GradeCommand {
    std::vector<std::filesystem::path> submissions;  ///< a directory or an archive each; or parts are merged
    std::filesystem::path submitted;                 ///< when they were handed in; or none
    std::vector<std::string> chapters;               ///< their numbers; all if there are none
    std::filesystem::path rubric;                    ///< a grading.json; none: the chapters' points
    std::optional<std::uint64_t> seed;               ///< of the random cases; none: the class's own
    std::string isolation = "bwrap";
    std::string on;  ///< the engine whose script is written, instead of marking anything; empty: none
    int parts = 0;   ///< of the script; 0: the usual ones
    std::vector<std::string> part_options;  ///< all but these two and the results, as words of a command line
    std::string part;                       ///< "2/7": of the submissions only these; empty: all
    std::vector<std::filesystem::path> merge;  ///< parts' results, which become the class's
    std::string format;                        ///< empty: csv, or json for a part
    std::filesystem::path output;              ///< none: standard output
};

/// `course grade`: marks submissions and writes the results. What was marked before is not marked again. Of
/// parts the results are the same bytes as of the whole, but for the times that marks say of themselves. With
/// an engine it writes the script that has the parts marked there, and marks nothing.
int run_grade(const GradeCommand& command);

struct SimilarityCommand {
    std::vector<std::filesystem::path> submissions;  ///< as of GradeCommand
    std::vector<std::string> chapters;               ///< their numbers; all if there are none
    std::string isolation = "bwrap";                 ///< of the boxes in which archives are opened
    int least = 70;                                  ///< per cent, of a pair that is listed
    std::filesystem::path output;  ///< .html, .csv or .json; none: the most similar on standard output
    bool json = false;
};

/// `course similarity`: what submissions share with each other, with the solution and with the variants.
int run_similarity(const SimilarityCommand& command);

struct AutograderCommand {
    std::filesystem::path archive;      ///< what is made; or none
    bool prepare = false;               ///< or all that marking needs is built: in Gradescope's image
    std::filesystem::path place;        ///< or what is there is marked: Gradescope's directory
    std::vector<std::string> chapters;  ///< as of GradeCommand, here and below
    std::filesystem::path rubric;
    std::optional<std::uint64_t> seed;
    std::string isolation = "user";
    bool json = false;
};

/// `course autograder FILE`: the archive that is uploaded to Gradescope (common/grading/autograder.hpp).
int run_autograder(const AutograderCommand& command);

struct ReferencesCommand {
    bool make = false;    ///< write what changed
    std::string chapter;  ///< number; empty: all
    bool json = false;    ///< one JSON object on standard output instead of the table
    bool quiet = false;   ///< nothing on standard output, no progress
};

/// `course references`: exports the scenes, renders them with POV-Ray and compares text and pixels with the
/// files of the repository; also the thumbnails that the README shows; 1 if any differ and were not written.
/// Throws InputError if POV-Ray is not installed.
int run_references(const ReferencesCommand& command, const Project& project = this_project());

struct RandomReferencesCommand {
    std::uint64_t count = 0;  ///< scenes
    std::uint64_t first = 0;  ///< number of the first
    bool json = false;        ///< one JSON object on standard output instead of the table
};

/// `course references --random N`: makes up scenes, exports them and compares POV-Ray's pictures with ours by
/// the gate of the tour: each is equal, or the export refuses it. Those that differ are left in
/// build/references/random; 1 if any differs, or if more are refused than equal. Throws InputError if POV-Ray
/// is not installed.
int run_random_references(const RandomReferencesCommand& command, const Project& project = this_project());

/// `course test`: every test of the project; 1 if any fails.
int run_test(bool quick, bool json);

struct MutateCommand {
    std::vector<std::string> targets;  ///< "02", "02.1"; empty: all chapters
    int sample = 0;                    ///< so many mutants of each chapter; 0: all
    bool json = false;
};

/// `course mutate`: changes the solutions at one place at a time and runs the tests
/// (common/evidence/mutants.hpp); 1 if they do not notice one that is not listed as equivalent, or if a list
/// is wrong.
int run_mutate(const MutateCommand& command);

/// `course exercises`: 1 if an exercise differs from what its solution generates; `make` writes it instead.
int run_exercises(bool make, bool json);

/// `course figures [NN]`: 1 if a figure differs from the one that its program draws; `make` writes it
/// instead.
int run_figures(const std::string& chapter, bool make, bool json);

struct HandoutCommand {
    std::filesystem::path directory;
    std::string chapters;         ///< "1-5"; empty: all, or in an update those that the handout has
    std::filesystem::path about;  ///< the class: its names and dates; empty: none, or in an update as before
    bool update = false;          ///< an existing handout, or a student's copy of one
    bool json = false;
};

/// `course handout DIR`: a tree for students (common/handout/handout.hpp).
int run_handout(const HandoutCommand& command);

/// `course new NN_name`: makes a new chapter's column.
int run_new(const std::string& name, bool json);

/// The program: reads the command line and calls one of the above. Never throws.
int run_course(int argc, char** argv);

}  // namespace rt
