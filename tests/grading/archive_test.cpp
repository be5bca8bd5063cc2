// Archives that students hand in: what is taken of them, and that no archive harms the grader.
#include "common/grading/archive.hpp"
#include "common/grading/class_list.hpp"
#include "common/grading/submission_times.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/random.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/terminal/process.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"
#include "tests/support.hpp"

namespace fs = std::filesystem;
using namespace rt;

namespace {

constexpr const char* camera = "chapters/01_ray_casting/camera.cpp";
constexpr const char* plane = "chapters/01_ray_casting/plane.cpp";

const std::vector<Chapter>& catalogue() {
    static const std::vector<Chapter> all = read_catalogue(this_project());
    return all;
}

std::vector<const Chapter*> first() { return {&catalogue().front()}; }

/// The best level that this machine can do.
Isolation level() {
    static const Isolation best = [] {
        for (const Level& level : probe())
            if (level.possible) return level.isolation;
        FAIL("this machine can have no boxes");
        return Isolation::None;
    }();
    return best;
}

/// A fresh directory in which archives are made.
struct Bench {
    fs::path place = fs::path(test::scratch_directory()) / "archives";

    Bench() {
        fs::remove_all(place);
        fs::create_directories(place);
    }
    void add(const std::string& file, const std::string& text) const {
        fs::create_directories((place / file).parent_path());
        write_file(place / file, text);
    }
    /// Runs a shell's command there.
    fs::path made(const std::string& name, const std::string& command) const {
        const ProcessResult result = run_process({"sh", "-c", "cd '" + place.string() + "' && " + command});
        INFO(result.output);
        REQUIRE(succeeded(result));
        return place / name;
    }
    fs::path zip(const std::string& name, const std::string& what) const {
        return made(name, "bsdtar --format zip -cf " + name + " " + what);
    }
};

Submission read(const fs::path& archive) { return read_archive(archive, first(), level()); }

std::string refusal(const fs::path& archive) {
    try {
        read(archive);
    } catch (const BadSubmission& bad) {
        const std::string line = bad.what();
        CHECK(line.find('\n') == std::string::npos);
        CHECK(line == archive.string() + ": " + bad.why);
        return bad.why;
    }
    return "taken";
}

}  // namespace

TEST_CASE("archives are read as the directories that were packed", "[archives]") {
    const Bench bench;
    bench.add(std::string("ada/") + camera, "one");
    bench.add(std::string("ada/") + plane, "two");
    bench.add("ada/build/notes.txt", "three");
    const std::map<std::string, std::string> both{{camera, "one"}, {plane, "two"}};

    CHECK(read(bench.zip("top.zip", "ada")).files == both);
    CHECK(read(bench.zip("no_top.zip", "-C ada chapters build")).files == both);
    CHECK(read(bench.zip("dot.zip", "-C ada .")).files == both);
    CHECK(read(bench.zip("alone.zip", "-C ada/chapters/01_ray_casting camera.cpp plane.cpp")).files == both);
    CHECK(read(bench.made("top.tar.gz", "tar czf top.tar.gz ada")).files == both);
    CHECK(read(bench.made("dot.tar.xz", "tar cJf dot.tar.xz ./ada")).files == both);

    bench.made("", "mv ada 'Müllers [Abgabe] *'");
    const Submission mueller = read(bench.zip("b.c.zip", "'Müllers [Abgabe] *'"));
    CHECK(mueller.files == both);
    CHECK(mueller.name == "b.c");
    CHECK(!mueller.submitted);
    CHECK(name_of_submission(bench.place / "top.tar.gz") == "top");
    // What was unpacked is a directory like any other.
    CHECK(read_handed_in(bench.place, first(), level()).files == both);
    CHECK(read_handed_in(bench.place / "b.c.zip", first(), level()).files == both);
}

TEST_CASE("of an archive only regular files of exercises are taken", "[archives]") {
    const Bench bench;
    bench.add("secret", "the instructor's");
    bench.add(std::string("a/") + plane, "two");
    bench.made("", std::string("ln -s '") + (bench.place / "secret").string() + "' a/" + camera);
    const Submission linked = read(bench.made("link.tar", "tar cf link.tar a"));
    CHECK(linked.files == std::map<std::string, std::string>{{plane, "two"}});
    CHECK(linked.remarks == std::vector<std::string>{std::string(camera) + " is no regular file"});

    // Paths that lead out: neither is a place of an exercise.
    bench.add("camera.cpp", "one");
    for (const char* name : {"../../camera.cpp", "..", "x/../camera.cpp"}) {
        const std::string to = std::string("-P -s '|^camera.cpp|") + name + "|' camera.cpp";
        CHECK_THAT(refusal(bench.zip("out.zip", to)), Catch::StartsWith("has no file of an exercise"));
    }
    // A directory that is a link, and then a file in it.
    bench.made(
        "",
        "mkdir one two outside && ln -s ../outside one/chapters && mkdir -p two/chapters/01_ray_casting "
        "&& cp camera.cpp two/chapters/01_ray_casting");
    const fs::path through =
        bench.made("through.tar",
                   std::string("tar cf through.tar -C one chapters && tar rf through.tar -C two ") + camera);
    read(through);
    CHECK(fs::is_empty(bench.place / "outside"));

    bench.add(std::string("b/") + camera, "one");
    CHECK(refusal(bench.zip("two.zip", "a b")) == "has exercises in both a/ and b/");
    CHECK_THAT(refusal(bench.zip("none.zip", "secret")), Catch::StartsWith("has no file of an exercise"));
    bench.made("", "truncate -s 2M a/" + std::string(plane));
    CHECK_THAT(read(bench.zip("large.zip", "a")).remarks,
               Catch::VectorContains(std::string(plane) + " is larger than 1 MiB"));
}

TEST_CASE("what is no archive, encrypted, or unpacks to too much is refused in a line", "[archives]") {
    const Bench bench;
    bench.add("camera.cpp", "int a;\n");
    CHECK(refusal(bench.place / "camera.cpp") ==
          "cannot be unpacked: Error opening archive: Unrecognized archive format");
    CHECK_THROWS_WITH(read(bench.place / "nothing"), Catch::EndsWith(": No such file or directory"));
    CHECK(refusal(bench.zip("secret.zip", "--options zip:encryption --passphrase moon camera.cpp")) ==
          "is encrypted");
    bench.made("", "truncate -s 40M plane.cpp");
    CHECK(refusal(bench.zip("bomb.zip", "plane.cpp")) ==
          "cannot be unpacked: that wrote a file of more than 16 MiB");
    // A list that is as long as the names of thirty thousand files.
    const std::string name(200, 'x');
    bench.made("many.tar", "mkdir many && cd many && seq -f '" + name +
                               "%g' 30000 | xargs touch && tar cf ../many.tar .");
    CHECK(refusal(bench.place / "many.tar") == "cannot be unpacked: there are too many files in it");
}

TEST_CASE("no archive that is cut short or has wrong bits stops the grader", "[archives]") {
    const Bench bench;
    bench.add(std::string("ada/") + camera, std::string(5000, 'a'));
    bench.add(std::string("ada/") + plane, "two");
    Random random = random_for(17, 0, 0);
    int refused = 0, all = 0;
    for (const fs::path& whole :
         {bench.zip("whole.zip", "ada"), bench.made("whole.tgz", "tar czf whole.tgz ada")}) {
        const std::string text = read_file(whole);
        const fs::path damaged = bench.place / "damaged";
        for (int i = 0; i < 30; ++i, ++all) {
            std::string bytes = text;
            if (i % 2 == 0)
                bytes.resize(random_index(random, text.size()));
            else
                for (int bit = 0; bit < 4; ++bit)
                    bytes[random_index(random, text.size())] ^=
                        static_cast<char>(1 << random_index(random, 8));
            write_file(damaged, bytes);
            if (refusal(damaged) != "taken") ++refused;
        }
    }
    INFO(refused << " of " << all << " were refused");
    CHECK(refused > all / 4);
}

TEST_CASE("one bad submission does not keep a class from being read", "[archives]") {
    const Bench bench;
    std::string text(4000, ' ');  // of which no archive makes less
    Random random = random_for(18, 0, 0);
    for (char& c : text) c = static_cast<char>(random_index(random, 256));
    bench.add("ada/camera.cpp", text);
    bench.add("nobody/notes.txt", "two");
    const fs::path whole = bench.zip("ben.zip", "ada"), cut_short = bench.place / "cleo.zip";
    const std::string bytes = read_file(whole);
    write_file(cut_short, bytes.substr(0, bytes.size() / 2));

    const ClassList list = class_list({bench.place / "nobody", cut_short, whole, bench.place / "ada"});
    CHECK(list.names == std::vector<std::string>{"ada", "ben", "cleo", "nobody"});
    const std::vector<Submission> read = read_class(list, {}, this_project(), first(), level());
    REQUIRE(read.size() == 4);
    for (const Submission& good : {read[0], read[1]}) {
        CHECK(good.files == std::map<std::string, std::string>{{camera, text}});
        CHECK(good.refused == "");
    }
    CHECK_THAT(read[2].refused, Catch::StartsWith("cannot be unpacked: "));
    CHECK(read[3].refused == std::string("has no file of an exercise, such as ") + camera);
    for (const Submission& bad : {read[2], read[3]}) CHECK(bad.files.empty());
    CHECK(digest_of(read[2]) != digest_of(read[3]));

    // A name that leads nowhere is the instructor's mistake.
    CHECK_THROWS_AS(
        read_class(class_list({whole, bench.place / "dan.zip"}), {}, this_project(), first(), level()),
        InputError);
    CHECK_THROWS_WITH(class_list({bench.place / "ada", bench.made("ada.zip", "cp ben.zip ada.zip")}),
                      Catch::EndsWith("two submissions of the same name"));
}

TEST_CASE("an instructor says when submissions were handed in", "[archives]") {
    const auto times = read_submission_times(
        "times.csv", "ada,2027-03-01T23:59:00+01:00\r\n\n\"Lovelace, \"\"A\"\"\",2027-03-01T10:00Z\n");
    CHECK(times == std::map<std::string, Moment>{{"ada", test::moment("2027-03-01T22:59:00Z")},
                                                 {"Lovelace, \"A\"", test::moment("2027-03-01T10:00Z")}});
    const auto wrong = [](const std::string& text) -> std::string {
        try {
            read_submission_times("times.csv", text);
        } catch (const InputError& error) {
            return error.what();
        }
        return "taken";
    };
    CHECK_THAT(wrong("ada 2027-03-01T10:00Z\n"),
               Catch::StartsWith("times.csv:1:1: expected a submission's name"));
    CHECK_THAT(wrong("ada,2027-03-01T10:00Z\nben,2027-03-01 10:00\n"),
               Catch::StartsWith("times.csv:2:5: expected a time"));
    CHECK(wrong("ada,2027-03-01T10:00Z\nada,2027-03-01T10:00Z\n") == "times.csv:2:1: ada is there twice");

    const fs::path file = fs::path(test::scratch_directory()) / "times.csv";
    write_file(file, "ada,2027-03-01T10:00Z\n");
    std::vector<Submission> submissions{{"ada", {}, {}}};
    tell_times(submissions, file);
    CHECK(submissions[0].submitted == test::moment("2027-03-01T10:00Z"));
    submissions.push_back({"ben", {}, {}});
    CHECK_THROWS_WITH(tell_times(submissions, file),
                      Catch::EndsWith("it does not say when ben was handed in"));
}
