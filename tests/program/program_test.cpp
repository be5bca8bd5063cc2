// The program from outside: exit status, one line for what is wrong, JSON and nothing else.
#include "common/image/file.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/project.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <nlohmann/json.hpp>

#include <sys/stat.h>

#include <algorithm>

using namespace rt;
using nlohmann::json;

namespace {

struct Outcome {
    int status = 0;
    std::string out;     ///< standard output
    std::string errors;  ///< standard error
};

/// Runs the program in the scratch directory of this file's tests.
Outcome course(const std::string& arguments) {
    const std::filesystem::path directory = std::filesystem::path(test::scratch_directory()) / "program";
    std::filesystem::create_directories(directory);
    const std::string program = (this_project().build / "bin" / "course").string();
    const std::string command =
        "cd '" + directory.string() + "' && '" + program + "' " + arguments + " 2>errors";
    ProcessOptions options;
    options.merge_errors = false;
    options.output_limit = 1 << 26;
    const ProcessResult result = run_process({"sh", "-c", command}, options);
    return {result.signal == 0 ? result.exit_code : -result.signal, result.output,
            read_file(directory / "errors")};
}

std::filesystem::path in_scratch(const std::string& name) {
    return std::filesystem::path(test::scratch_directory()) / "program" / name;
}

/// Status 2, nothing on standard output, and this one line on standard error.
void check_refused(const std::string& arguments, const std::string& line) {
    INFO("arguments := " << arguments);
    const Outcome outcome = course(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.errors == line + "\n");
}

std::vector<std::string> keys(const json& object) {
    std::vector<std::string> names;
    for (const auto& [key, value] : object.items()) names.push_back(key);
    return names;
}

using Keys = std::vector<std::string>;

void write_scene(const std::string& name, const std::string& more = "") {
    test::write(in_scratch(name), "size 8 4\ncamera 0 0 4 0 0 0 0 1 0 45\n" + more);
}

}  // namespace

TEST_CASE("unknown commands and options get a suggestion") {
    check_refused("rendr",
                  "there is no command 'rendr'; did you mean 'render'? (./course --help shows what "
                  "there is)");
    check_refused("qqqqqqqq", "there is no command 'qqqqqqqq' (./course --help shows what there is)");
    check_refused(
        "render x.scene --solution",
        "there is no option '--solution'; did you mean '--solutions'? (./course render --help shows what "
        "there is)");
    check_refused("--jsn",
                  "there is no option '--jsn'; did you mean '--json'? (./course --help shows what there "
                  "is)");
}

TEST_CASE("to watch takes a terminal") {
    check_refused("check --watch", "--watch needs a terminal to show things and to take keys");
}

TEST_CASE("a command line that lacks something is refused in one line") {
    for (const char* wrong :
         {"render", "hint", "compare one.png", "render x.scene --threads zero",
          "render x.scene --mine --solutions", "compare a b --within 300", "check --watch --json",
          "check --watch --solutions", "compare a b --scene x.scene"}) {
        INFO("arguments := " << wrong);
        const Outcome outcome = course(wrong);
        CHECK(outcome.status == 2);
        CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
        CHECK(outcome.errors.find("--help shows how") != std::string::npos);
    }
}

TEST_CASE("mutate tells of each chapter what became of its mutants") {
    const Outcome outcome = course("mutate 02.1 --sample 3 --json");
    CHECK(outcome.status == 0);
    const json chapters = json::parse(outcome.out)["chapters"];
    REQUIRE(chapters.size() == 1);
    CHECK(keys(chapters[0]) == Keys{"caught", "caught_by_other_step", "equivalent", "id", "not_compiled",
                                    "score", "stale", "survived"});
    CHECK(chapters[0]["id"] == "02_spheres");
    CHECK(chapters[0]["caught"].get<int>() + chapters[0]["not_compiled"].get<int>() == 3);
    CHECK(chapters[0]["score"] == 1);
    check_refused("mutate 2 --sample 0",
                  "--sample: '0' is not a whole number from 1 to 1000000 (./course mutate --help shows how)");
}

TEST_CASE("every command has help with an example") {
    const Outcome all = course("--help");
    CHECK(all.status == 0);
    for (const char* command :
         {"tour", "test", "list", "check", "hint", "reset", "solution", "render", "compare", "explain",
          "export", "report", "references", "exercises", "figures", "mutate", "handout"}) {
        INFO("command := " << command);
        CHECK(all.out.find(std::string("\n  ") + command) != std::string::npos);
        const Outcome help = course(std::string(command) + " --help");
        CHECK(help.status == 0);
        CHECK(help.out.find(std::string("Example:\n  ./course ") + command) != std::string::npos);
        CHECK(help.out.find("--json") != std::string::npos);
    }
}

TEST_CASE("wrong input is status 2 and leaves no picture") {
    write_scene("wrong.scene", "sphere 0 0 0 -1\n");
    const Outcome outcome = course("render wrong.scene --solutions -o wrong.png");
    CHECK(outcome.status == 2);
    CHECK(outcome.errors.find("wrong.scene:3:") == 0);
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
    CHECK_FALSE(std::filesystem::exists(in_scratch("wrong.png")));
    CHECK(course("render no-such-file.scene").status == 2);
    write_scene("right.scene");
    check_refused("render right.scene -o x.jpg", "x.jpg: pictures end in .png, .pfm or .hdr, not in '.jpg'");
    check_refused("render right.scene --size 10",
                  "--size: '10' is not a size; expected width and height from 1 to 65536, such as 640x480");
    check_refused("render right.scene --integrator normal",
                  "--integrator: there is no 'normal'; did you mean 'normals'?");
    check_refused("hint 99.1", course("hint 99").errors.substr(0, course("hint 99").errors.size() - 1));
}

TEST_CASE("numbers in options are decimal and finite, and no value is empty") {
    write_scene("options.scene", "integrator flat\nambient 1 0 0\nsphere 0 0 0 1\n");
    const std::string render = "render options.scene --solutions -o options.pfm ";
    const Outcome octal = course(render + "--spp 010 --size 020x010 --json");
    INFO(octal.errors);
    REQUIRE(octal.status == 0);
    CHECK(json::parse(octal.out)["samples_per_pixel"] == 10);
    CHECK(json::parse(octal.out)["width"] == 20);
    CHECK(course(render + "--threads 08").status == 0);  // no octal number at all
    std::filesystem::remove(in_scratch("options.pfm"));
    for (const char* wrong : {"--seconds nan",
                              "--seconds inf",
                              "--seconds -nan",
                              "--seconds 1e999",
                              "--seconds 0x1p3",
                              "--error nan",
                              "--error infinity",
                              "--error ''",
                              "--spp nan",
                              "--spp 0x10",
                              "--spp 1e3",
                              "--spp ''",
                              "--spp 0",
                              "--spp 99999999999999999999",
                              "--threads 1.5",
                              "--threads ' 2'",
                              "--seed nan",
                              "--seed -1",
                              "--seed 1e300",
                              "--seed ''",
                              "--size ''",
                              "--size '10 x 10'",
                              "--size 1e1x10",
                              "--integrator ''",
                              "-o ''",
                              "--size 9000x9000"}) {
        const Outcome outcome = course(render + wrong);
        INFO("arguments := " << wrong << "\n" << outcome.errors);
        CHECK(outcome.status == 2);
        CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
        CHECK_FALSE(std::filesystem::exists(in_scratch("options.pfm")));
    }
    for (const char* wrong :
         {"render ''", "export options.scene -o ''", "compare a.png ''", "compare a.png b.png --within nan",
          "compare a.png b.png --within 010x", "compare a.png b.png --page ''",
          "compare a.png b.png --diff ''", "trace options.scene nan 0", "trace options.scene 0 ''",
          "trace options.scene 0 0 --against ''", "hint ''", "tour -o ''", "report ''", "check ''"}) {
        const Outcome outcome = course(wrong);
        INFO("arguments := " << wrong << "\n" << outcome.errors);
        CHECK(outcome.status == 2);
        CHECK(outcome.out.empty());
        CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
        CHECK(outcome.errors.find("--help shows how") != std::string::npos);
    }
}

TEST_CASE("what cannot be written is found before anything is rendered") {
    // The picture would take hours.
    write_scene("slow.scene", "size 4096 4096\nspp 60000\nsphere 0 0 0 1\n");
    test::write(in_scratch("kept.png"), "precious");
    std::filesystem::permissions(in_scratch("kept.png"), std::filesystem::perms::owner_read);
    std::filesystem::create_directories(in_scratch("directory.png"));
    const std::string render = "render slow.scene --solutions -o ";
    check_refused(render + "kept.png", "kept.png: cannot be written: it is read-only");
    check_refused(render + "directory.png", "directory.png: cannot be written: Is a directory");
    check_refused(render + "kept.png/a.png", "kept.png/a.png: cannot be written: Not a directory");
    check_refused(render + "none/a.png", "none/a.png: cannot be written: there is no directory 'none'");
    CHECK(read_file(in_scratch("kept.png")) == "precious");
    check_refused("render slow.scene --solutions --size 8192x8193",
                  "--size: '8192x8193' is 67117056 pixels; at most 67108864 are possible");
    check_refused("tour -o kept.png", "kept.png: cannot be made a directory: Not a directory");
    test::write(in_scratch("tour_kept/01_ray_casting/horizon.png"), "precious");
    std::filesystem::permissions(in_scratch("tour_kept/01_ray_casting/horizon.png"),
                                 std::filesystem::perms::owner_read);
    check_refused("tour -o tour_kept",
                  "tour_kept/01_ray_casting/horizon.png: cannot be written: it is read-only");
    check_refused("report -o kept.png leave-out", "kept.png: cannot be made a directory: Not a directory");
}

TEST_CASE("no command writes over what it reads") {
    write_scene("input.scene", "mesh input.obj\n");
    test::write(in_scratch("input.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string scene = read_file(in_scratch("input.scene")), mesh = read_file(in_scratch("input.obj"));
    write_image(in_scratch("input.png"), make_image(2, 2));
    const std::string picture = read_file(in_scratch("input.png"));
    const auto link = [](const char* to, const char* name) {
        std::filesystem::remove(in_scratch(name));
        std::filesystem::create_hard_link(in_scratch(to), in_scratch(name));
    };
    link("input.scene", "scene.png");
    link("input.obj", "mesh.png");
    link("input.png", "picture.html");

    check_refused("export input.scene -o input.scene",
                  "input.scene: cannot be written: it is 'input.scene', which is read here");
    check_refused("export input.scene -o ./input.obj",
                  "./input.obj: cannot be written: it is 'input.obj', which is read here");
    check_refused("render input.scene --solutions -o scene.png",
                  "scene.png: cannot be written: it is 'input.scene', which is read here");
    check_refused("render input.scene --solutions -o mesh.png",
                  "mesh.png: cannot be written: it is 'input.obj', which is read here");
    check_refused("compare input.png input.png --diff input.png",
                  "input.png: cannot be written: it is 'input.png', which is read here");
    check_refused("compare input.png input.png --page picture.html",
                  "picture.html: cannot be written: it is 'input.png', which is read here");
    check_refused("compare input.png input.png --page a.png --diff ./a.png",
                  "a.png: --diff and --page cannot be one file");
    // A reference by another name; a tour that wrote it after all would only break the link.
    std::filesystem::create_directories(in_scratch("tour/02_spheres"));
    std::filesystem::remove(in_scratch("tour/02_spheres/far.png"));
    const std::string far = (this_project().root / "references" / "02_spheres" / "far.png").string();
    std::filesystem::create_hard_link(far, in_scratch("tour/02_spheres/far.png"));
    check_refused("tour -o tour",
                  "tour/02_spheres/far.png: cannot be written: it is '" + far + "', which is read here");
    CHECK(read_file(in_scratch("input.scene")) == scene);
    CHECK(read_file(in_scratch("input.obj")) == mesh);
    CHECK(read_file(in_scratch("input.png")) == picture);
    CHECK(course("export input.scene -o input.pov").status == 0);
}

TEST_CASE("what could not be said is status 2") {
    write_scene("said.scene", "integrator flat\nsphere 0 0 0 1\n");
    const std::string render = "render said.scene --solutions -o said.pfm ";
    for (const std::string arguments :
         {"list", "list --json", "", "--help", "explain said.scene", "explain said.scene --json",
          "solution 02.1 --spoil", "trace said.scene 1 1", "compare said.pfm said.pfm",
          "render said.scene --solutions -o said.pfm --preview --quiet"}) {
        REQUIRE(course(render).status == 0);
        INFO("arguments := " << arguments);
        CHECK(course(arguments).status == 0);
        const Outcome full = course(arguments + " >/dev/full");
        CHECK(full.status == 2);
        CHECK(full.errors == "standard output: cannot be written: No space left on device\n");
        const Outcome closed = course(arguments + " >&-");
        CHECK(closed.status == 2);
        CHECK(closed.errors == "standard output: cannot be written: Bad file descriptor\n");
    }
    // The helper has a standard error of its own after the arguments, so these have another shell around
    // them.
    const auto without_errors = [](const std::string& arguments, const std::string& where) {
        return run_process({"sh", "-c",
                            "cd '" + in_scratch("").string() + "' && '" +
                                (this_project().build / "bin" / "course").string() + "' " + arguments +
                                where});
    };
    for (const std::string where : {" 2>&-", " 2>/dev/full", " >&- 2>&-", " <&- >&- 2>&-"}) {
        INFO("where := " << where);
        std::filesystem::remove(in_scratch("said.pfm"));
        const ProcessResult rendered = without_errors(render, where);
        CHECK(rendered.signal == 0);
        CHECK(rendered.exit_code == 2);  // the summary was not said
        const Image picture = read_image(in_scratch("said.pfm"));
        CHECK(picture.width == 8);  // and is not in the picture
        for (const char* wrong : {"rendr", "render none.scene", "render"}) {
            const ProcessResult refused = without_errors(wrong, where);
            CHECK(refused.signal == 0);
            CHECK(refused.exit_code == 2);
        }
    }
    CHECK(without_errors(render + "--quiet", " >&- 2>&-").exit_code == 0);  // nothing was to be said
}

TEST_CASE("names that are not UTF-8 or would steer the terminal are shown escaped") {
    const std::string name = "caf\xe9\x1b[2J\n.scene", picture = "\xff.pfm";
    write_scene(name, "integrator flat\nsphere 0 0 0 1\n");
    const Outcome rendered = course("render '" + name + "' --solutions -o '" + picture + "'");
    CHECK(rendered.status == 0);
    CHECK(rendered.errors.starts_with("\\xff.pfm  8 × 4"));
    const Outcome as_json = course("render '" + name + "' --solutions --json -o '" + picture + "'");
    INFO(as_json.errors);
    REQUIRE(as_json.status == 0);
    CHECK(json::parse(as_json.out)["output"] == "\\xff.pfm");
    const Outcome explained = course("explain '" + name + "' --json");
    REQUIRE(explained.status == 0);
    CHECK(json::parse(explained.out)["scene"] == "caf\\xe9\x1b[2J\n.scene");
    check_refused("render '" + name + ".none'",
                  "caf\\xe9\\x1b[2J\\n.scene.none: there is no such file; did you mean "
                  "'caf\\xe9\\x1b[2J\\n.scene'?");
    check_refused("'\xe9'", "there is no command '\\xe9' (./course --help shows what there is)");
    CHECK(course("render --spp '\xe9\x1b' '" + name + "'").errors.find("'\\xe9\\x1b'") != std::string::npos);
    CHECK(course("compare '" + picture + "' '" + picture + "' --page '\xfe.html'").status == 0);
    CHECK(is_utf8(read_file(in_scratch("\xfe.html"))));
}

TEST_CASE("endless inputs and pipes without a writer are refused") {
    const std::filesystem::path pipe = in_scratch("pipe.scene");
    std::filesystem::remove(pipe);
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    check_refused("render pipe.scene", "pipe.scene: cannot be read: nobody writes into this pipe");
    check_refused("render /dev/zero", "/dev/zero: cannot be read: it is a device, not a file");
    write_scene("endless.scene", "mesh /dev/zero\n");
    check_refused("render endless.scene",
                  "endless.scene:3:6: mesh /dev/zero: cannot be read: it is a device, not a file");
    write_scene("piped.scene", "integrator flat\nsphere 0 0 0 1\n");
    CHECK(course("render /dev/stdin --solutions -o piped.pfm <piped.scene").status == 0);
    CHECK(run_process({"bash", "-c",
                       "cd '" + in_scratch("").string() + "' && '" +
                           (this_project().build / "bin" / "course").string() +
                           "' render <(sleep 0.2; cat piped.scene) --solutions -o piped.pfm"})
              .exit_code == 0);
}

TEST_CASE("render writes what the scene says, and JSON in the documented form") {
    write_scene("ball.scene", "integrator flat\nambient 1 0 0\nsphere 0 0 0 1\n");
    const Outcome outcome = course("render ball.scene --solutions --json -o ball.pfm --size 16x8");
    INFO(outcome.errors);
    REQUIRE(outcome.status == 0);
    const json object = json::parse(outcome.out);
    CHECK(keys(object) == Keys{"cpu_seconds", "height", "left_out", "output", "random_numbers", "rays",
                               "rms_error", "samples_per_pixel", "seconds", "width"});
    CHECK(object["output"] == "ball.pfm");
    CHECK(object["width"] == 16);
    CHECK(object["rms_error"].is_null());
    CHECK(object["samples_per_pixel"] == 1);
    CHECK(object["random_numbers"] == 0);
    CHECK(object["rays"]["camera"] == 16 * 8);
    CHECK(object["left_out"].is_array());
    const Image image = read_image(in_scratch("ball.pfm"));
    CHECK(pixel(image, 8, 4) == Vec3(1, 0, 0));
    CHECK(pixel(image, 0, 0) == Vec3(0));

    std::filesystem::remove(in_scratch("ball.png"));
    CHECK(course("render ball.scene --solutions --quiet").errors.empty());
    CHECK(std::filesystem::exists(in_scratch("ball.png")));
}

TEST_CASE("every name that a scene gives its picture ends in a picture") {
    const auto rendered = [](const std::string& output, const std::string& picture,
                             const std::string& warning) {
        INFO(output);
        write_scene("named.test", "output " + output + "\nsphere 0 0 0 1\n");
        std::filesystem::remove_all(in_scratch(picture));
        const Outcome outcome = course("render named.test --solutions --quiet");
        CHECK(outcome.status == 0);
        CHECK(outcome.errors == warning);
        CHECK(std::filesystem::exists(in_scratch(picture)));
    };
    const auto becomes = [](const std::string& output, const std::string& picture) {
        return "named.test:3:8: pictures are written as .png, .pfm or .hdr: '" + output + "' becomes '" +
               picture + "'\n";
    };
    rendered("a.png", "a.png", "");
    rendered("A.PNG", "A.PNG", "");
    rendered("b.Pfm", "b.Pfm", "");
    rendered("c.bmp", "c.png", becomes("c.bmp", "c.png"));
    rendered("d", "d.png", becomes("d", "d.png"));
    std::filesystem::remove_all(in_scratch("made"));
    rendered("made/here/e.png", "made/here/e.png", "");
    rendered("made/f.tga", "made/f.png", becomes("made/f.tga", "made/f.png"));

    const auto refused = [](const std::string& output, const std::string& what) {
        write_scene("named.test", "output " + output + "\n");
        check_refused("render named.test --solutions", "named.test:3:8: " + what);
        CHECK(course("render named.test --solutions --quiet -o other.png").status == 0);
    };
    refused("../nowhere/a.png", "there is no folder '../nowhere'; -o FILE writes the picture elsewhere");
    refused("/nowhere/a.png", "there is no folder '/nowhere'; -o FILE writes the picture elsewhere");
    refused("a.png/b.png", "there is no folder 'a.png'; -o FILE writes the picture elsewhere");
    refused("made/", "'made/' names no file; -o FILE says where the picture goes");
    // What a person says on the command line is meant.
    check_refused("render named.test --solutions -o a.bmp",
                  "a.bmp: pictures end in .png, .pfm or .hdr, not in '.bmp'");
}

TEST_CASE("every command that reads a scene can read it leniently") {
    write_scene("other.test", "russianroulette on\nintegrator pathtracer\nmaxdepth -1\nsphere 0 0 0 1 2\n");
    const std::string commands[] = {"render other.test --solutions --quiet", "explain other.test",
                                    "trace other.test 4 2", "export other.test -o other.pov"};
    for (const std::string& command : commands) {
        INFO(command);
        check_refused(command, "other.test:3:1: unknown command 'russianroulette'; it comes with chapter 14");
        const Outcome lenient = course(command + " --lenient");
        CHECK(lenient.status == 0);
        CHECK(std::count(lenient.errors.begin(), lenient.errors.end(), '\n') == 4);
        for (const char* place :
             {"other.test:3:1: ", "other.test:4:12: ", "other.test:5:10: ", "other.test:6:16: "})
            CHECK(lenient.errors.find(place) != std::string::npos);
    }
}

TEST_CASE("render takes samples until there are enough, the error is small or time is over") {
    write_scene("edge.scene", "integrator flat\nambient 1 0 0\nsphere 0 0 0 1\n");
    const auto rendered = [](const std::string& options) {
        const Outcome outcome =
            course("render edge.scene --solutions --json -o edge.pfm --size 40x30 " + options);
        INFO(outcome.errors);
        REQUIRE(outcome.status == 0);
        return json::parse(outcome.out);
    };
    const json given = rendered("--spp 9");
    CHECK(given["samples_per_pixel"] == 9);
    CHECK(given["rms_error"].get<double>() > 0);
    const std::string one = read_file(in_scratch("edge.pfm"));
    rendered("--spp 9 --seed 1");
    CHECK(read_file(in_scratch("edge.pfm")) != one);
    rendered("--spp 9 --seed 0");
    CHECK(read_file(in_scratch("edge.pfm")) == one);
    CHECK(rendered("--error 0.01")["rms_error"].get<double>() <= 0.01);
    // How long enough is, a busy machine decides.
    double samples = 0;
    for (double seconds = 0.02; samples <= 1 && seconds < 10; seconds *= 4)
        samples = rendered("--seconds " + std::to_string(seconds))["samples_per_pixel"].get<double>();
    CHECK(samples > 1);
    CHECK(course("render edge.scene --solutions --spp 9 -o edge.pfm")
              .errors.find("9 samples a pixel, RMS error about ") != std::string::npos);

    check_refused("render edge.scene --spp 4 --error 0.1",
                  "--spp excludes --error (./course render --help shows how)");
    check_refused("render edge.scene --integrator rasterize --seconds 1",
                  "--seconds and --error: scan conversion takes one sample a pixel, and is done then");
}

TEST_CASE("the same picture comes out with any number of threads") {
    write_scene("threads.scene", "integrator normals\nsphere 0 0 0 1\n");
    CHECK(course("render threads.scene --solutions --threads 1 -o one.pfm --size 100x70").status == 0);
    CHECK(course("render threads.scene --solutions --threads 3 -o three.pfm --size 100x70").status == 0);
    const bool equal = read_file(in_scratch("one.pfm")) == read_file(in_scratch("three.pfm"));
    CHECK(equal);
}

TEST_CASE("compare has a status, JSON in the documented form, and a page") {
    Image image = make_image(4, 3);
    write_image(in_scratch("black.pfm"), image);
    pixel(image, 2, 1) = Vec3(1, 0, 0);
    pixel(image, 3, 1) = Vec3(0, 0, 0.001);  // 3.3/255 as the display shows it: 255 · 12.92 · 0.001
    write_image(in_scratch("dot.pfm"), image);
    write_image(in_scratch("small.pfm"), make_image(2, 2));

    CHECK(course("compare black.pfm black.pfm").status == 0);
    const Outcome outcome = course("compare dot.pfm black.pfm --json --page page.html --diff diff.png");
    CHECK(outcome.status == 1);
    const json object = json::parse(outcome.out);
    CHECK(keys(object) == Keys{"flip", "height", "max", "mean", "psnr", "rmse", "same", "shown_max", "ssim",
                               "width", "within", "within16", "worst"});
    CHECK(object["same"] == false);
    CHECK(object["max"] == 1);
    CHECK(object["worst"] == json{{"x", 2}, {"y", 1}});
    CHECK(object["within"]["2"] == Approx(10.0 / 12));
    CHECK(object["within"]["10"] == Approx(11.0 / 12));
    CHECK(keys(object["within"]) == Keys{"1", "10", "2"});
    CHECK(object["flip"] > 0.01);
    CHECK(object["ssim"].is_null());  // no window of 11 × 11 pixels fits into them
    CHECK(std::filesystem::file_size(in_scratch("page.html")) > 0);
    CHECK(read_image(in_scratch("diff.png")).width == 4);

    const Outcome equal = course("compare black.pfm black.pfm --json --within 3");
    CHECK(json::parse(equal.out)["psnr"].is_null());
    CHECK(json::parse(equal.out)["within"]["3"] == 1);
    CHECK(course("compare dot.pfm black.pfm --within 255").status == 0);
    check_refused(
        "compare small.pfm black.pfm",
        "small.pfm has 2 x 2 pixels and black.pfm has 4 x 3; only images of one size can be compared");
    CHECK(course("compare none.pfm black.pfm").status == 2);
}

TEST_CASE("compare's page has rays of the scene that it is told") {
    write_scene("rays.scene", "ambient 1 0 0\nsphere 0 0 0 1\n");
    REQUIRE(course("render rays.scene --solutions -o rays.pfm").status == 0);
    CHECK(course("compare rays.pfm rays.pfm --page rays.html --scene rays.scene").status == 0);
    CHECK(read_file(in_scratch("rays.html")).find("hits the sphere of line 4") != std::string::npos);
    write_image(in_scratch("small.pfm"), make_image(2, 2));
    check_refused("compare small.pfm small.pfm --page rays.html --scene rays.scene",
                  "rays.scene has 8 x 4 pixels and small.pfm has 2 x 2: it is not the scene of this picture");
    check_refused("compare rays.pfm rays.pfm --page rays.scene --scene rays.scene",
                  "rays.scene: cannot be written: it is 'rays.scene', which is read here");
    CHECK(course("compare rays.pfm rays.pfm --scene rays.scene").status == 2);
    const json trees = json::parse(course("trace rays.scene 4 2 --json --also '0,0 3,1'").out)["trees"];
    REQUIRE(trees.size() == 3);
    CHECK(trees[2]["x"] == 3);
    CHECK(trees[1]["rays"][0]["hit"] == false);
}

TEST_CASE("compare judges pictures of 8 bits by their 8 bits") {
    Image image = make_image(2, 1);
    write_image(in_scratch("black.png"), image, Encoding::Linear);
    pixel(image, 1, 0) = Vec3(1 / Real(255));  // the darkest step of a linear file: 13 of 255 in sRGB's curve
    write_image(in_scratch("step.png"), image, Encoding::Linear);
    write_image(in_scratch("step.pfm"), image);
    for (const char* pictures : {"step.png black.png", "step.pfm black.png", "black.png step.pfm"}) {
        INFO("pictures := " << pictures);
        const Outcome outcome = course(std::string("compare --encoding linear --json ") + pictures);
        CHECK(outcome.status == 0);
        CHECK(json::parse(outcome.out)["within"]["1"] == 1);
        CHECK(json::parse(outcome.out)["max"] == Approx(1 / Real(255)));
    }
    CHECK(json::parse(
              course("compare --encoding linear --json step.png step.pfm --within 0").out)["within"]["0"] ==
          1);
    CHECK(json::parse(course("compare --json step.png black.png").out)["within"]["1"] == 1);
}

TEST_CASE("explain says what was kept, what was left out, and which chapters draw it") {
    write_scene("explained.scene", "integrator normals\nsphere 0 0 0 1\n");
    const Outcome outcome = course("explain explained.scene --json");
    REQUIRE(outcome.status == 0);
    const json object = json::parse(outcome.out);
    CHECK(keys(object) == Keys{"bytes", "chapters", "kept", "left_out", "scene"});
    CHECK(object["chapters"] == json{"01", "02"});
    CHECK_FALSE(object["left_out"].empty());
    CHECK(course("explain explained.scene").out.find("Left out") != std::string::npos);
}

TEST_CASE("list and status tell the chapters as JSON") {
    const json list = json::parse(course("list --json").out);
    REQUIRE(list["chapters"].size() >= 3);
    const json& step = list["chapters"][1]["steps"][0];
    CHECK(list["chapters"][1]["id"] == "02_spheres");
    CHECK(list["chapters"][1]["hours"] == 4);
    CHECK(keys(step) == Keys{"id", "message", "points", "state", "title"});
    CHECK(keys(json::parse(course("--json").out)) == Keys{"chapters", "next"});
    CHECK(course("list").out.find("02.1") != std::string::npos);
    CHECK(course("list").out.find("02  Spheres  about 4 hours") != std::string::npos);
    CHECK(course("").out.find("Next:") != std::string::npos);
}

TEST_CASE("nothing is coloured where no person looks") {
    for (const char* command : {"", "list", "rendr"}) {
        const Outcome outcome = course(command);
        CHECK((outcome.out + outcome.errors).find('\033') == std::string::npos);
    }
}

TEST_CASE("a solution is shown without its marks") {
    const Outcome spoilt = course("solution 02.1 --spoil --json");
    CHECK(spoilt.status == 0);
    const json object = json::parse(spoilt.out);
    CHECK(object["step"] == "02.1");
    REQUIRE(object["solution"].size() == 1);
    CHECK(object["solution"][0]["text"].get<std::string>().find("[exercise") == std::string::npos);
    CHECK(object["solution"][0]["text"].get<std::string>().find("solve_quadratic(") != std::string::npos);
}

TEST_CASE(
    "a tree says how surfaces spread light: finishes, the sky, lobes and facets, by the numbers there") {
    const std::string wall =
        "ambient 0 0 0\ndirectional 0 0 1 1 1 1\ndiffuse 1 1 1\nstripes .5 1 1 .5 1 1 1\n";
    const auto trace = [&](const std::string& text) {
        write_scene("spread.scene", wall + text + "disc 0 0 0 0 0 1 9\n");
        const Outcome outcome = course("trace spread.scene 4 2");
        CHECK(outcome.status == 0);
        return outcome.out;
    };
    const auto says = [](const std::string& text, const std::string& line) {
        INFO(text << "says not: " << line);
        CHECK(text.find(line + "\n") != std::string::npos);
    };
    const std::string plain = trace("");
    CHECK(plain.find("finish") == std::string::npos);
    CHECK(plain.find("lobe") == std::string::npos);
    says(trace("finish metal .8\n"), "  finish metal, roughness 0.8");
    const std::string matte = trace("finish matte .8\ntextured finish\n");
    says(matte, "  finish matte, roughness 0.4");
    CHECK(matte.find(" of it visible, lobe (0.") != std::string::npos);
    says(trace("finish coated 3\ntextured coat\n"), "  finish coated, index of refraction 1.5");
    says(trace("skyGradient .5 .5 .5 .5 .5 .5 .5 .5 .5\nskylight on\n"),
         "  light from the sky adds (0.25, 0.5, 0.5)");
    says(trace("specular .5 .5 .5\ngloss 40\ntextured gloss\n"), "  spreads mirrored rays as cos^20");
    says(trace("specular .5 .5 .5\nbrdf ggx\nroughness .6\n"), "  sends rays on by facets, alpha 0.6");
    const json tree = json::parse(course("trace spread.scene 4 2 --json").out);
    CHECK(tree["rays"][0]["facets"].get<double>() == 0.6);
}

TEST_CASE("the tree of a ray between two mirrors is as long as a person can use, and says that it goes on") {
    write_scene(
        "mirrors.scene",
        "maxdepth 1000000\nspecular 1 1 1\nplane 0 0 -1 0 0 1\nplane 0 0 5 0 0 -1\nbackground 1 1 1\n");
    const Outcome text = course("trace mirrors.scene 4 2");
    REQUIRE(text.status == 0);
    CHECK(text.out.size() < 10'000'000);
    CHECK(text.out.find("The tree goes on: these are its first 10000 rays.\n") != std::string::npos);
    // 16 levels of four columns are the most.
    CHECK(text.out.find("\n" + std::string(65, ' ') + "r") == std::string::npos);
    CHECK(text.out.find("\n" + std::string(64, ' ') + "reflection ray of depth 9999 ") != std::string::npos);
    write_scene("ball.scene", "sphere 0 0 0 1\n");
    CHECK(json::parse(course("trace ball.scene 4 2 --json").out)["complete"] == true);
}
