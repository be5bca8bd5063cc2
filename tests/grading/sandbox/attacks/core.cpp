// Dies with a memory that somebody might like to read.
#include <cstdlib>

int main() { std::abort(); }
