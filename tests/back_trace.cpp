// Where a test program was when it crashed or was told to stop. A crashed program's heap may be broken and
// its stack full: the handler has a stack of its own, and calls nothing that takes memory.
#include "tests/back_trace.hpp"

#ifdef __linux__

#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>

namespace rt::test {

namespace {

constexpr int most_frames = 256;

std::array<char, 4096> report_file{};
std::array<char, 1 << 16> own_stack;
std::uintptr_t program_begin = 0, program_end = 0;

/// What the system tells first is the program itself; libraries follow.
int find_program(dl_phdr_info* module, std::size_t, void*) {
    program_begin = module->dlpi_addr;
    for (int i = 0; i < module->dlpi_phnum; ++i) {
        const auto& part = module->dlpi_phdr[i];
        if (part.p_type == PT_LOAD) program_end = program_begin + part.p_vaddr + part.p_memsz;
    }
    return 1;
}

/// A line of text in a fixed place.
struct Line {
    std::array<char, 32 * most_frames> text{};
    std::size_t size = 0;

    void add(const char* words) {
        while (*words != '\0' && size < text.size()) text[size++] = *words++;
    }
    void add_hexadecimal(std::uintptr_t number) {
        std::array<char, 2 * sizeof number + 1> digits{};
        std::size_t at = digits.size() - 1;
        do {
            digits[--at] = "0123456789abcdef"[number % 16];
            number /= 16;
        } while (number != 0);
        add(&digits[at]);
    }
};

extern "C" void write_where(int signal) {
    static Line line;
    static std::array<void*, most_frames> frames;
    const int count = backtrace(frames.data(), most_frames);
    line.add("{\"stopped_at\":[");
    // First come this function and what called it for the system, then the place itself. All further ones are
    // where calls return to, which may be the next line already.
    constexpr int place = 2;
    bool first = true;
    for (int i = place; i < count; ++i) {
        const auto address = reinterpret_cast<std::uintptr_t>(frames[static_cast<std::size_t>(i)]);
        if (address < program_begin || address >= program_end) continue;
        line.add(first ? "\"" : ",\"");
        line.add_hexadecimal(address - program_begin - (i == place ? 0 : 1));
        line.add("\"");
        first = false;
    }
    line.add("]}\n");
    const int file = open(report_file.data(), O_WRONLY | O_APPEND | O_CLOEXEC);
    if (write(file, line.text.data(), line.size) < 0) line.size = 0;  // then the place is not known
    std::signal(signal, SIG_DFL);
    raise(signal);
}

}  // namespace

void report_where_it_stops(const std::string& report) {
    if (report.size() >= report_file.size()) return;
    report.copy(report_file.data(), report.size());
    dl_iterate_phdr(find_program, nullptr);
    void* unused[1];
    backtrace(unused, 1);  // the first call loads a library, for which there is no time later

    stack_t stack{};
    stack.ss_sp = own_stack.data();
    stack.ss_size = own_stack.size();
    sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = write_where;
    action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND | SA_NODEFER);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGQUIT})
        sigaction(signal, &action, nullptr);
}

}  // namespace rt::test

#else

namespace rt::test {
void report_where_it_stops(const std::string&) {}
}  // namespace rt::test

#endif
