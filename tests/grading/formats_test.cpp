// Every format against its written schema; what students read holds nothing that is not theirs; and bytes of
// a student's program do no harm in any of them.
#include "common/grading/formats/formats.hpp"
#include "common/grading/grade_json.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/base64.hpp"
#include "tests/catch.hpp"
#include "tests/grading/examples.hpp"
#include "tests/grading/schema.hpp"
#include "tests/support.hpp"

#include <map>
#include <set>
#include <sstream>

using namespace rt;
using nlohmann::json;

namespace {

const std::string schemas = "tests/grading/schemas/";
const Moment today = test::moment("2027-03-05T00:00:00Z");

ShownGrade shown(const Grade& grade) { return shown_to_student(grade, {}, today, {"host17"}); }

/// As `troubled`, with what must not get out in the texts that students see.
Grade leaky() {
    Grade grade = test::troubled("ada");
    grade.isolation = "user on host17";
    grade.steps[1].failure->said = "/home/prof/course/x.cpp:5: on host17: 1 == 2\n" + test::nasty;
    return grade;
}

/// A submission of which nothing compiles.
Grade uncompiled() {
    Grade grade = test::perfect("bob");
    for (GradedStep& step : grade.steps) {
        step.verdict = Verdict::NotCompiled;
        step.earned = {};
        step.checks = {0, 7};
        step.failure = FailedCheck{"", "sphere.cpp:5:9: error: 'y' was not declared"};
    }
    return grade;
}

/// One that could not be read.
Grade not_taken() {
    Grade grade = test::perfect("dan");
    for (GradedStep& step : grade.steps) {
        step.verdict = Verdict::NotTaken;
        step.earned = {};
        step.checks = {};
        step.failure = FailedCheck{"", "what was handed in is encrypted"};
    }
    return grade;
}

/// One whose steps have every verdict that there is.
Grade every_verdict() {
    Grade grade = test::perfect("carol");
    const GradedStep step = grade.steps.back();
    for (const Verdict verdict : {Verdict::Failed, Verdict::Todo, Verdict::TimedOut, Verdict::TooMuchMemory,
                                  Verdict::NotCompiled, Verdict::NeedsStep, Verdict::NotTaken}) {
        grade.steps.push_back(step);
        grade.steps.back().id = "02." + std::to_string(grade.steps.size());
        grade.steps.back().verdict = verdict;
        grade.steps.back().earned = {};
    }
    return grade;
}

std::vector<Grade> examples() {
    return {test::perfect("ada"), leaky(), uncompiled(), every_verdict(), not_taken()};
}

/// What a format makes of all examples.
template <class Format>
std::vector<std::string> all(Format format) {
    std::vector<std::string> texts;
    for (const Grade& grade : examples()) texts.push_back(format(shown(grade)));
    return texts;
}

/// The document with one key of the first object in `list`, or of the whole, taken away.
std::string without(const std::string& document, const std::string& list, const std::string& key) {
    json root = json::parse(document);
    json& object = list.empty() ? root : root.at(list).at(0);
    REQUIRE(object.erase(key) == 1);
    return root.dump();
}

std::map<std::string, std::string> lines_of(const std::string& text) {
    std::map<std::string, std::string> values;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        values[line.substr(0, line.find('='))] = line.substr(line.find('=') + 1);
    return values;
}

std::string classroom50_text(const ShownGrade& grade) {
    return classroom50(grade, {"cs", "rays", "0123abc", "v1", "https://example.org/review"});
}

/// Everything that students may read of a grade, base64 decoded, in one text.
std::string all_formats(const Grade& grade) {
    const ShownGrade student = shown(grade);
    std::string text = gradescope(student) + classroom50_text(student) + prairielearn(student) +
                       autolab(student) + junit_xml({student});
    for (const auto& [name, value] : lines_of(github_classroom(student)))
        text += from_base64(value).value_or(value);
    return text;
}

/// RFC 4180 read strictly.
std::vector<std::vector<std::string>> read_csv(const std::string& text) {
    std::vector<std::vector<std::string>> rows;
    for (std::size_t at = 0; at < text.size();) {
        rows.emplace_back();
        for (bool more = true; more;) {
            std::string field;
            if (text[at] == '"') {
                for (++at; text[at] != '"' || text.at(at + 1) == '"'; ++at) {
                    if (text[at] == '"') ++at;
                    field += text[at];
                }
                ++at;
            } else {
                const std::size_t end = text.find_first_of(",\r", at);
                REQUIRE(end != std::string::npos);
                field = text.substr(at, end - at);
                REQUIRE(field.find('"') == std::string::npos);
                at = end;
            }
            rows.back().push_back(field);
            more = text.at(at) == ',';
            at += more ? 1 : 0;
        }
        REQUIRE(text.substr(at, 2) == "\r\n");
        at += 2;
    }
    return rows;
}

json table_of(const std::string& text) {
    const auto rows = read_csv(text);
    json table = json::array();
    for (std::size_t i = 1; i < rows.size(); ++i) {
        REQUIRE(rows[i].size() == rows[0].size());
        json row;
        for (std::size_t k = 0; k < rows[i].size(); ++k) row[rows[0][k]] = rows[i][k];
        table.push_back(row);
    }
    return table;
}

}  // namespace

TEST_CASE("Gradescope's results") {
    const std::vector<std::string> texts = all(gradescope);
    CHECK(test::against_schema(texts, schemas + "gradescope.schema.json") == "");
    CHECK(test::against_schema({without(texts[0], "tests", "status")}, schemas + "gradescope.schema.json") !=
          "");
    const json result = json::parse(texts[1]);
    double sum = 0, most = 0;
    for (const json& step : result["tests"]) {
        sum += step["score"].get<double>();
        most += step["max_score"].get<double>();
    }
    CHECK(sum == 17.5);
    CHECK(most == 25);  // 20 more are extra credit
    CHECK(result["tests"][1]["output_format"] == "html");
    CHECK(result["tests"][1]["output"].get<std::string>().find("<img src=\"data:image/png;base64,iVBOR") !=
          std::string::npos);
    CHECK(result["tests"][0]["status"] == "passed");
    CHECK(result["tests"][1]["status"] == "failed");
}

TEST_CASE("GitHub Classroom's runners") {
    std::vector<std::string> runners;
    for (const std::string& text : all(github_classroom)) {
        auto lines = lines_of(text);
        CHECK(lines["runners"] == "chapter-01,chapter-02");
        REQUIRE(lines.size() == 3);
        for (const char* name : {"chapter-01", "chapter-02"}) runners.push_back(*from_base64(lines[name]));
    }
    const std::string schema = schemas + "github_classroom.schema.json";
    CHECK(test::against_schema(runners, schema) == "");
    CHECK(test::against_schema({without(runners[0], "tests", "score")}, schema) != "");
    const json spheres = json::parse(runners[3]);  // of the second example
    CHECK(spheres["max_score"] == 15);
    CHECK(spheres["status"] == "error");
    CHECK(spheres["tests"][0]["score"] == 7.5);
    CHECK(spheres["tests"][0]["status"] == "fail");
    CHECK(json::parse(runners[0])["status"] == "pass");
}

TEST_CASE("Classroom 50's result") {
    const std::vector<std::string> texts = all(classroom50_text);
    CHECK(test::against_schema(texts, schemas + "classroom50.schema.json") == "");
    CHECK(test::against_schema({without(texts[0], "", "release")}, schemas + "classroom50.schema.json") !=
          "");
    const json result = json::parse(texts[1]);
    CHECK(result["score"] == 18);  // 10 + 7.5, whose half is rounded up
    CHECK(result["max-score"] == 25);
    CHECK(result["commit"] == "0123abc");
}

TEST_CASE("PrairieLearn's results") {
    const std::vector<std::string> texts = all(prairielearn);
    CHECK(test::against_schema(texts, schemas + "prairielearn.schema.json") == "");
    CHECK(test::against_schema({without(texts[0], "", "score")}, schemas + "prairielearn.schema.json") != "");
    CHECK(json::parse(texts[0])["score"] == 1);
    CHECK(json::parse(texts[1])["score"] == 0.7);  // 17.5 of 25
    CHECK(json::parse(texts[1])["gradable"] == true);
    CHECK(json::parse(texts[1])["tests"][1]["images"][0]["url"].get<std::string>().find(
              "data:image/png;base64,") == 0);
    const json nothing = json::parse(texts[2]);
    CHECK(nothing["gradable"] == false);
    REQUIRE(nothing["format_errors"].size() == 2);  // one a file
    CHECK(nothing["format_errors"][1] ==
          "chapters/02_spheres/sphere.cpp: sphere.cpp:5:9: error: 'y' was not declared");
    // What other files have earned stays.
    CHECK(json::parse(texts[3])["gradable"] == true);
    const json not_read = json::parse(texts[4]);
    CHECK(not_read["gradable"] == false);
    CHECK(not_read["format_errors"] == json::array({"what was handed in is encrypted"}));
}

TEST_CASE("PrairieLearn's results are never larger than it takes") {
    Grade grade = test::troubled("ada");
    grade.steps[0].difference.assign(400'000, 'a');
    grade.steps[1].difference.assign(600'000, 'b');
    const std::string text = prairielearn(shown(grade));
    CHECK(text.size() <= most_prairielearn);
    const json result = json::parse(text);
    CHECK(result["tests"][0]["images"].size() == 1);
    CHECK(result["tests"][1]["images"].empty());
    CHECK(result["tests"][1]["message"].get<std::string>().find("the difference picture is left out") !=
          std::string::npos);
    CHECK(test::against_schema({text}, schemas + "prairielearn.schema.json") == "");

    const GradedStep step = test::troubled("ada").steps[1];
    grade.steps.assign(300, step);
    for (GradedStep& one : grade.steps) one.failure->said.assign(5000, '\\');
    CHECK(prairielearn(shown(grade)).size() <= most_prairielearn);
}

TEST_CASE("Autolab's last two lines") {
    std::vector<std::string> feedback, scores;
    for (const std::string& text : all(autolab)) {
        std::istringstream lines(text);
        std::string first, second, third;
        std::getline(lines, first);
        std::getline(lines, second);
        CHECK_FALSE(std::getline(lines, third));
        feedback.push_back(first);
        scores.push_back(second);
    }
    CHECK(test::against_schema(feedback, schemas + "autolab_feedback.schema.json") == "");
    CHECK(test::against_schema(scores, schemas + "autolab.schema.json") == "");
    CHECK(test::against_schema({without(scores[0], "", "scores")}, schemas + "autolab.schema.json") != "");
    CHECK(scores[1] == R"({"scores":{"01.1":10,"02.1":7.5,"02.2":0}})");
    const json second = json::parse(feedback[1]);
    CHECK(second["stages"] == json({"Chapter 01", "Chapter 02"}));
    CHECK(second["Chapter 02"]["02.1 The roots"]["passed"] == false);
    CHECK(second["Chapter 01"]["01.1 The axes"] == json({{"passed", true}}));
}

TEST_CASE("JUnit's XML") {
    std::vector<ShownGrade> students;
    for (const Grade& grade : examples()) students.push_back(shown(grade));
    const std::string text = junit_xml(students);
    CHECK(test::against_xsd(text, schemas + "junit.xsd") == "");
    CHECK(test::against_xsd("<testsuites><testsuite/></testsuites>", schemas + "junit.xsd") != "");
    CHECK(test::against_xsd(junit_xml({}), schemas + "junit.xsd") == "");
    CHECK(text.find("<testsuite name=\"carol\" tests=\"10\" failures=\"1\" errors=\"4\" skipped=\"2\"") !=
          std::string::npos);
    CHECK(text.find("<property name=\"earned\" value=\"17.5\"/>") != std::string::npos);
}

TEST_CASE("CSV: a row a submission, a column a step") {
    Grade grade = leaky();
    grade.submission = "=HYPERLINK(\"http://x\";A1), \xFF\nnew line";
    const std::vector<Grade> grades{test::perfect("-ada"), grade};
    const std::string text = csv(grades);
    const json table = table_of(text);
    CHECK(test::against_schema({table.dump()}, schemas + "csv.schema.json") == "");
    json wrong = table;
    wrong[0]["submission"] = "=1+1";
    CHECK(test::against_schema({wrong.dump()}, schemas + "csv.schema.json") != "");
    REQUIRE(table.size() == 2);
    CHECK(table[0]["submission"] == "'-ada");
    CHECK(table[1]["submission"] == "'=HYPERLINK(\"http://x\";A1), \\xff\\nnew line");
    CHECK(table[1]["earned"] == "17.5");
    CHECK(table[1]["02.1"] == "7.5");
    CHECK(table[1]["not passed"] == "02.1 failed, 02.2 crashed");
    CHECK(table[1]["seed"] == "18446744073709551615");
    CHECK(read_csv(csv({})).size() == 1);
}

TEST_CASE("the instructor's page") {
    std::vector<Grade> grades{leaky(), test::perfect("bob")};
    grades[1].submission = "<script>alert(1)</script>\" onclick=\"x";
    std::string page = class_page(grades);
    // Well-formed as XML, too, so no text has broken out of its place; only that this character is no part of
    // XML.
    const std::string noncharacter = "\xEF\xBF\xBE";
    for (auto at = page.find(noncharacter); at != std::string::npos; at = page.find(noncharacter))
        page.erase(at, noncharacter.size());
    const ProcessResult lint =
        run_process({"xmllint", "--noout", "--nonet", test::scratch_file("class.html", page)});
    CHECK(lint.output == "");
    CHECK(succeeded(lint));
    const auto count = [&](const std::string& text) {
        int found = 0;
        for (auto at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
        return found;
    };
    CHECK(count("<script>") == 1);  // ours
    CHECK(count("</script>") == 1);
    CHECK(count("onclick=\"") == 0);
    CHECK(count("://") == 0);                      // nothing is loaded from elsewhere,
    CHECK(count("Content-Security-Policy") == 1);  // and could not be
    CHECK(count("<article class=\"card behind student\"") == 2);
    CHECK(count("href=\"#student-1\"") >= 3);
    CHECK(count("two roots of a far sphere") >= 2);  // the table of mistakes and the student's page
    CHECK(count("the secret check") >= 2);           // the instructor may see it
    CHECK(count("=1+1 \\xff\\xc3( \\x1b[31m\\x01 &lt;/script&gt;&lt;b&gt;&amp;amp; ]]&gt;") >= 1);
    CHECK(count("src=\"data:image/png;base64,iVBOR") == 1);
    CHECK(class_page({not_taken()}).find("<td>all</td><td>not taken</td>") != std::string::npos);
    CHECK(class_page(grades).find("the grader failed") == std::string::npos);
    CHECK(class_page(grades, {"ben", "<cleo>"}).find("the grader failed</dt><dd>ben, &lt;cleo&gt;</dd>") !=
          std::string::npos);
    CHECK_NOTHROW(class_page({}));
}

TEST_CASE("what students read holds nothing of hidden checks, of directories, of the machine, nor the seed") {
    const std::string text = all_formats(leaky());
    for (const char* secret :
         {"secret", "42.5", "/home", "prof", "host17", "18446744073709551615", "fedcba9876543210"}) {
        INFO(secret);
        CHECK(text.find(secret) == std::string::npos);
    }
    // The same search finds them where nothing is taken away.
    const std::string kept = to_json(leaky()).dump();
    for (const char* secret : {"secret", "42.5", "18446744073709551615", "fedcba9876543210"})
        CHECK(kept.find(secret) != std::string::npos);
    CHECK(text.find("Some hidden check does not pass.") != std::string::npos);
}

TEST_CASE("bytes of a student's program come out as text") {
    const ShownGrade student = shown(leaky());
    const std::string wanted = printable(test::nasty);
    CHECK(json::parse(prairielearn(student))["tests"][1]["output"].get<std::string>().find(wanted) !=
          std::string::npos);
    CHECK(all_formats(leaky()).find('\x1B') == std::string::npos);
    CHECK(is_utf8(all_formats(leaky())));
    CHECK(is_utf8(class_page({leaky()})));
    CHECK(junit_xml({student}).find("\\ufffe\\x00zero") != std::string::npos);
    CHECK(gradescope(student).find("</script>") == std::string::npos);
}

TEST_CASE("before their date students see no marks: Gradescope keeps them back, the others are refused") {
    FormatRequest request;
    request.grades = {test::perfect("ada")};
    request.rubric.marks_from = today;
    request.at = today - std::chrono::seconds(1);
    const json kept_back = json::parse(find_format("gradescope").text(request));
    CHECK(kept_back["visibility"] == "after_published");
    CHECK(kept_back["tests"][0]["visibility"] == "after_published");
    for (const char* name : {"junit", "github-classroom", "classroom50", "prairielearn", "autolab"}) {
        INFO(name);
        CHECK(test::error_of([&] {
                  find_format(name).text(request);
              }).find("students may not see marks before 2027-03-05T00:00:00Z; ") == 0);
    }
    for (const char* name : {"html", "csv"}) CHECK_FALSE(find_format(name).text(request).empty());
    request.at = today;
    for (const Format& format : formats()) CHECK_FALSE(format.text(request).empty());
    CHECK(json::parse(find_format("gradescope").text(request))["visibility"] == "visible");
}

TEST_CASE("formats by their names") {
    std::set<std::string_view> names;
    for (const Format& format : formats()) CHECK(names.insert(format.name).second);
    CHECK(test::error_of([] { find_format("moodle"); }) ==
          "there is no format 'moodle'; there are html, csv, json, junit, gradescope, github-classroom, "
          "classroom50, prairielearn, autolab");
    FormatRequest request;
    request.grades = {test::perfect("ada"), test::perfect("bob")};
    CHECK(test::error_of([&] { find_format("autolab").text(request); }) ==
          "this format is for one submission, and there are 2; csv, html and junit are for a class");
}

TEST_CASE("kept results are as their schema says") {
    Grade bytes = every_verdict();
    bytes.submission = "\xFF";
    std::vector<Grade> grades = examples();
    const std::string text = grades_text({grades[0]}), schema = "common/grading/grades.schema.json";
    CHECK(test::against_schema({text, grades_text({grades[1]}), grades_text({grades[2]}),
                                grades_text({bytes}), grades_text({}), grades_text({}, ClassPart{2, 7, "f"}),
                                grades_text({grades[0]}, {}, {"ben", "\xFF"})},
                               schema) == "");
    CHECK(test::against_schema({without(text, "grades", "seed")}, schema) != "");
}
