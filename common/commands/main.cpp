// The program `course`; with exercises in place of solutions, also `course_mine`.
#include "common/commands/commands.hpp"

int main(int argc, char** argv) { return rt::run_course(argc, argv); }
