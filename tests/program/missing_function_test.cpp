// A function that is not there any more: what the linker says of it, in a student's words.
#include "common/workbook/missing_function.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

using namespace rt;

namespace {

struct Tree {
    Project project = test::sandbox("missing_function");
    std::vector<Chapter> chapters;
    Tree() {
        test::add_chapter(project, "02_spheres", test::good_chapter);
        test::write(project.root / "chapters/02_spheres/x.hpp",
                    "namespace rt {\n\n"
                    "/// [02.1] Uses closest(1).\n/// More.\nRoots roots(Real a, Real b);\n\n"
                    "/// [02.1] Of a plane.\nstd::optional<Hit> hit(const Plane& plane, const Ray& ray);\n\n"
                    "/// [02.2] Of a sphere.\nstd::optional<Hit> hit(const Sphere& sphere,\n"
                    "                       const Ray& ray);\n\n"
                    "/// No step's.\nint number();\n\n"
                    "inline int twice(int n) {\n    return number() * n;\n}\n\n}\n");
        chapters = read_catalogue(project);
    }
    std::string words(const std::string& line) const { return missing_in_words(project, chapters, line); }
};

}  // namespace

TEST_CASE("the step of a missing function is told, and how it comes back") {
    const Tree tree;
    CHECK(tree.words(
              "/usr/bin/ld: x_test.cpp.o: in function `f()': x_test.cpp:(.text+0x2a): undefined reference to "
              "`rt::roots(double, double)'") ==
          "chapters/02_spheres/x.cpp has no function Roots roots(Real a, Real b) of step 02.1; if it was "
          "deleted, "
          "./course reset 02.1 puts it back, and changes nothing else");
    CHECK(tree.words("x.o:x.cpp:function rt::g(): error: undefined reference to 'rt::roots(double, double)'")
              .find("of step 02.1") != std::string::npos);
    CHECK(tree.words("ld.lld: error: undefined symbol: rt::roots(double, double)").find("of step 02.1") !=
          std::string::npos);
}

TEST_CASE("of functions of one name it is the one with these parameters") {
    const Tree tree;
    const std::string before = "undefined reference to `rt::hit(rt::", after = " const&, rt::Ray const&)'";
    CHECK(tree.words(before + "Sphere" + after).find("Sphere& sphere, const Ray& ray) of step 02.2") !=
          std::string::npos);
    CHECK(tree.words(before + "Plane" + after).find("of step 02.1") != std::string::npos);
}

TEST_CASE("what is no step's, or nobody's, is told, too") {
    const Tree tree;
    CHECK(tree.words("undefined reference to `rt::number()'") ==
          "chapters/02_spheres has no function int number() any more; ./course reset 02 brings the chapter "
          "back");
    CHECK(tree.words("undefined reference to `rt::helper(int)'") ==
          "the function rt::helper(int) is called, and nowhere written");
    CHECK(tree.words("multiple definition of `rt::number()'").empty());
}
