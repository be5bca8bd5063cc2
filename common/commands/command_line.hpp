// The command line: CLI11's description of it, and what it has filled in.
#pragma once

#include "common/commands/commands.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

namespace rt {

struct CommandLine {
    CLI::App app{"A ray tracing course: chapters to write, tests that judge them, scenes that show them.",
                 "./course"};
    /// What the chosen command will do, once the whole line has been understood; returns the exit status.
    std::function<int()> action = [this] { return run_status(json); };

    bool json = false, all = false, spoil = false, quick = false, make = false;
    std::string step, chapter;
    std::filesystem::path directory;
    CheckCommand check;
    RenderCommand render;
    ReportCommand report;
    CompareCommand compare;
    ExplainCommand explain;
    TraceCommand trace;
    ExportCommand export_scene;
    TourCommand tour;
    GradeCommand grade;
    SimilarityCommand similarity;
    ReferencesCommand references;
    RandomReferencesCommand random;
    MutateCommand mutate;
    HandoutCommand handout;
    AutograderCommand autograder;
};

/// Describes all commands to `line.app`, which fills in `line` when it parses. `line` must stay where it is.
void describe_commands(CommandLine& line);

}  // namespace rt
