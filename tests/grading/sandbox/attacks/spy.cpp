// spy TEXT: says how many processes it can see, and where in /proc the text stands.
#include <dirent.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

int main(int, char** arguments) {
    int count = 0;
    if (DIR* list = opendir("/proc"))
        while (const dirent* entry = readdir(list)) {
            if (std::atoi(entry->d_name) <= 0) continue;
            ++count;
            for (const char* name : {"/environ", "/cmdline", "/mountinfo"}) {
                const std::string path = std::string("/proc/") + entry->d_name + name;
                std::ifstream in(path, std::ios::binary);
                const std::string text(std::istreambuf_iterator<char>(in), {});
                if (text.find(arguments[1]) != std::string::npos) std::puts(path.c_str());
            }
        }
    std::printf("%d\n", count);
}
