// Kept results are read back as they were, and parts of a class put together are the class.
#include "common/grading/grade_json.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"
#include "tests/support.hpp"

#include <algorithm>

using namespace rt;

namespace {

std::string error_of(const std::string& text) {
    return test::error_of([&] { read_grades("kept.json", text); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    REQUIRE(text.find(from) != std::string::npos);
    return text.replace(text.find(from), from.size(), to);
}

std::string merge_error(const std::vector<GradesFile>& files) {
    return test::error_of([&] { merged(files); });
}

}  // namespace

TEST_CASE("kept results are read back the same, whatever bytes they hold") {
    const std::vector<Grade> grades{test::perfect("ada"), test::troubled("b\xFF"
                                                                         "b")};
    const std::string text = grades_text(grades);
    CHECK(read_grades("kept.json", text) == grades);
    CHECK(grades_text(read_grades("kept.json", text)) == text);
    CHECK(read_grades("kept.json", grades_text({})).empty());

    Grade bare;
    bare.submission = "bare";
    CHECK(read_grades("kept.json", grades_text({bare})) == std::vector<Grade>{bare});
}

TEST_CASE("random bytes are read back the same") {
    test::Random random(1);
    const auto bytes = [&] {
        std::string text(random.index(40), ' ');
        for (char& c : text) c = static_cast<char>(random.index(256));
        return text;
    };
    for (int i = 0; i < test::cases(1000); ++i) {
        Grade grade = test::troubled("x" + bytes());
        grade.seconds = random.magnitude(-3, 6);
        grade.seed = random.engine();
        grade.steps[1].failure = FailedCheck{bytes(), bytes()};
        grade.steps[1].difference = bytes();
        REQUIRE(read_grades("kept.json", grades_text({grade})) == std::vector<Grade>{grade});
    }
}

TEST_CASE("kept results that are not of their form are refused with the place") {
    const std::string good = grades_text({test::troubled("ada")});
    CHECK(error_of(replaced(good, "\"late_percent\":50", "\"late_percent\":101"))
              .find(": grades/0/steps/2/late_percent: expected a whole number from 0 to 100") !=
          std::string::npos);
    CHECK(error_of(replaced(good, "\"earned\":7.5", "\"earned\":15.5"))
              .find(": grades/0/steps/1/earned: is more than what is possible") != std::string::npos);
    CHECK(error_of(replaced(good, "\"failed\"", "\"excellent\"")).find("verdict: is no verdict") !=
          std::string::npos);
    CHECK(error_of(replaced(good, "\"passed\":1,", "\"passed\":5,")).find("whole number from 0 to 4") !=
          std::string::npos);
    CHECK(error_of(replaced(good, "\"hint\"", "\"hints\"")).find("hints: is not known") != std::string::npos);
    CHECK(error_of(replaced(good, "iVBORw0KGgog", "iVBORw0KGgo")).find("expected base64") !=
          std::string::npos);
    CHECK(error_of(replaced(good, "\"02.2\"", "\"02.1\"")).find("id: is there twice") != std::string::npos);
    CHECK(error_of(replaced(good, "\"graded\":\"2027", "\"graded\":\"27")).find("expected a time") !=
          std::string::npos);
    CHECK(error_of(replaced(good, "\"version\":1", "\"version\":2")).find("kept.json:1:12: version: ") == 0);
    CHECK(error_of(good.substr(0, good.size() / 2)).find("kept.json:2:") == 0);
    CHECK(error_of("") != "");
}

TEST_CASE("a class in parts is the class, in whatever order they come") {
    std::vector<Grade> all;
    for (int i = 0; i < 12; ++i)
        all.push_back(i % 3 == 0 ? test::troubled("student" + std::to_string(i))
                                 : test::perfect("student" + std::to_string(i)));
    const std::string whole = grades_text(all);
    test::Random random(2);
    for (int i = 0; i < 20; ++i) {
        std::shuffle(all.begin(), all.end(), random.engine);
        std::vector<GradesFile> parts(4);
        for (std::size_t k = 0; k < parts.size(); ++k) parts[k].name = "part" + std::to_string(k);
        for (const Grade& grade : all) parts[random.index(parts.size())].grades.push_back(grade);
        CHECK(grades_text(merged(parts)) == whole);
        CHECK(grades_text(all) == whole);
    }
}

TEST_CASE("parts of a class are all there, each once, and are read back the same") {
    const std::vector<std::string> names{"cleo", "ada", "ben"};
    for (const char* no_part :
         {"", "1", "1/", "/2", "0/2", "3/2", "-1/2", "1/2/3", "a/b", "1/100001", " 1/2"})
        CHECK(test::error_of([&] { part_named(no_part, names); }).find(no_part) != std::string::npos);
    std::vector<GradesFile> parts;
    for (int number = 1; number <= 5; ++number) {
        const ClassPart part = part_named(std::to_string(number) + "/5", names);
        CHECK(part == part_named(std::to_string(number) + "/5", {"ada", "ben", "cleo"}));
        GradesFile file{"part" + std::to_string(number), {}, part};
        for (std::size_t i = 0; i < names.size(); ++i)
            if (is_in(part, i)) file.grades.push_back(test::perfect(names[i]));
        CHECK(file.grades.size() <= 1);  // of 3 submissions and 5 parts
        const GradesFile read = read_grades_file(file.name, grades_text(file.grades, part));
        CHECK(read.part == part);
        CHECK(read.grades == file.grades);
        parts.push_back(read);
    }
    CHECK(merged(parts).size() == 3);
    CHECK(merged({parts[4], parts[1], parts[3], parts[0], parts[2]}) == merged(parts));

    CHECK(merge_error({parts[0], parts[3]}) == "part1 is part 1 of 5, and there is no part 2, 3, 5");
    CHECK(merge_error({parts[0], parts[1], parts[0]}) == "part1 is part 1 of 5, and so is part1");
    CHECK(merge_error({parts[0], {"all", {}, {}}}) == "all is no part of a class, and part1 is part 1 of 5");
    CHECK(merge_error({parts[0], {"other", {}, part_named("2/6", names)}}) ==
          "other is part 2 of 6, and part1 is part 1 of 5");
    CHECK(merge_error({parts[0], {"other", {}, part_named("2/5", {"ada", "ben"})}}) ==
          "other is a part of other submissions than part1");
    CHECK(error_of(replaced(grades_text({}, parts[1].part), "\"number\":2", "\"number\":6"))
              .find("part/number: expected a whole number from 1 to 5") != std::string::npos);
}

TEST_CASE("whom a part lacks because the grader failed, the class lacks, unless another file has the mark") {
    const std::vector<std::string> lacks{"ben", "b\xFF"};
    const Grade ada = test::perfect("ada"), ben = test::perfect("ben");
    const GradesFile part = read_grades_file("1.json", grades_text({ada}, {}, {"ben", "b\xFF"}));
    CHECK(part.grades == std::vector<Grade>{ada});
    CHECK(part.not_marked == lacks);
    CHECK(not_marked_in({part, {"2.json", {}, {}, {"ben"}}}) == lacks);
    CHECK(not_marked_in({{"2.json", {ben}}, part}) == std::vector<std::string>{"b\xFF"});
    CHECK(not_marked_in({{"2.json", {ben}}}).empty());
}

TEST_CASE("a submission that is there twice, and parts of another class, are refused in one line") {
    const Grade ada = test::perfect("ada"), bob = test::perfect("bob");
    CHECK(merge_error({{"1.json", {ada}}, {"2.json", {bob, ada}}}) ==
          "2.json: the submission 'ada' is also in 1.json");
    CHECK(merge_error({{"1.json", {ada, bob, ada}}}) == "1.json: the submission 'ada' is there twice");
    CHECK(error_of(replaced(grades_text({ada, bob}), "\"bob\"", "\"ada\"")) ==
          "kept.json: the submission 'ada' is there twice");
    Grade other = bob;
    other.seed = 1;
    CHECK(merge_error({{"1.json", {ada}}, {"2.json", {other}}}) ==
          "2.json: the submission 'bob' was marked with another seed than 'ada' in 1.json");
    other = bob;
    other.rubric = "another";
    CHECK(merge_error({{"1.json", {ada}}, {"2.json", {other}}}).find("with another rubric than 'ada'") !=
          std::string::npos);
    other = bob;
    other.isolation = "none";
    CHECK(merge_error({{"1.json", {ada}}, {"2.json", {other}}})
              .find("at another level of isolation (none, not " + ada.isolation + ") than 'ada'") !=
          std::string::npos);
    other = bob;
    other.steps.pop_back();
    CHECK(merge_error({{"1.json", {ada}}, {"2.json", {other}}}).find("with other steps than 'ada'") !=
          std::string::npos);
    CHECK(merge_error({{"1.json", {test::perfect("a\x1B[2J"), test::perfect("a\x1B[2J")}}}) ==
          "1.json: the submission 'a\\x1b[2J' is there twice");
}
