// Answers on the descriptor that it was given, in the scratch directory, with its own exit status.
#include <unistd.h>

#include <cctype>
#include <cstdio>

int main() {
    char letter;
    while (read(3, &letter, 1) == 1 && letter != '.') {
        letter = static_cast<char>(std::toupper(letter));
        if (write(3, &letter, 1) != 1) return 1;
    }
    std::fputs("to the errors", stderr);
    return 7;
}
