// Where in a student's code a test program crashed, or was when its time was over.
#include "common/workbook/back_trace.hpp"

#include "common/terminal/process.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>

namespace rt {

namespace {

// So many calls of one function at once are no tree that is deep.
constexpr int endless = 80;

/// "rt::(anonymous namespace)::refine(int)::{lambda(int)#1}::operator()" is refine.
std::string plain_name(std::string name) {
    for (const std::string_view space : {"(anonymous namespace)::", "rt::"})
        for (auto at = name.find(space); at != std::string::npos; at = name.find(space))
            name.erase(at, space.size());
    name = name.substr(0, name.find('('));
    if (const auto type = name.rfind(' '); type != std::string::npos) name = name.substr(type + 1);
    return name == "operator" ? "a lambda" : name;
}

/// From "/…/chapters/02_spheres/sphere.cpp:31 (discriminator 2)"; a frame without a file if that is no
/// exercise.
Frame frame_of(const Project& project, const std::string& function, const std::string& place) {
    const std::string root = project.root.string() + "/";
    const auto colon = place.rfind(".cpp:");
    if (!place.starts_with(root + "chapters/") || colon == std::string::npos) return {};
    const char* number = place.data() + colon + std::string_view(".cpp:").size();
    Frame frame{plain_name(function), place.substr(root.size(), colon + 4 - root.size()), 0};
    std::from_chars(number, place.data() + place.size(), frame.line);
    return frame;
}

}  // namespace

std::vector<Frame> student_frames(const Project& project, std::string_view output) {
    std::vector<Frame> frames;
    std::string function;
    for (const std::string& line : split_lines(output)) {
        // An address, then for each call that was there a line with the function and one with the place.
        if (line.starts_with("0x")) {
            function.clear();
        } else if (function.empty()) {
            function = line;
        } else {
            const Frame frame = frame_of(project, function, line);
            if (!frame.file.empty()) frames.push_back(frame);
            function.clear();
        }
    }
    return frames;
}

std::string frames_in_words(const std::vector<Frame>& frames) {
    if (frames.empty()) return "";
    const Frame& inner = frames.front();
    const auto same = std::count_if(frames.begin(), frames.end(), [&](const Frame& frame) {
        return frame.function == inner.function && frame.file == inner.file;
    });
    const std::string place = inner.line > 0 ? fmt::format("{}:{}", inner.file, inner.line) : inner.file;
    return same >= endless ? fmt::format("{} called itself without end, {}", inner.function, place)
                           : fmt::format("in {}, {}", inner.function, place);
}

std::string stopped_in_words(const Project& project, const std::filesystem::path& program,
                             const std::vector<std::string>& addresses) {
    if (addresses.empty()) return "";
    // An endless recursion is at few different places.
    std::map<std::string, std::vector<Frame>> known;
    std::vector<std::string> command{"addr2line", "-a", "-f", "-i", "-C", "-e", program.string()};
    for (const std::string& address : addresses)
        if (known.emplace(address, std::vector<Frame>()).second) command.push_back("0x" + address);
    const ProcessResult told = run_process(command);
    if (!succeeded(told)) return "";

    std::string part;
    std::vector<std::string> asked(command.end() - static_cast<std::ptrdiff_t>(known.size()), command.end());
    std::size_t next = 0;
    const auto end_part = [&] {
        if (next > 0 && next <= asked.size())
            known[asked[next - 1].substr(2)] = student_frames(project, part);
        part.clear();
    };
    for (const std::string& line : split_lines(told.output)) {
        if (line.starts_with("0x")) {
            end_part();
            ++next;
        }
        part += line + "\n";
    }
    end_part();

    std::vector<Frame> frames;
    for (const std::string& address : addresses)
        frames.insert(frames.end(), known[address].begin(), known[address].end());
    return frames_in_words(frames);
}

std::string broken_rule(std::string_view printed) {
    const auto at = printed.find(": Assertion '");
    if (at == std::string_view::npos) return "";
    const std::string_view rule = printed.substr(at, printed.find('\n', at) - at);
    if (rule.find("size()") != std::string_view::npos || rule.find("< _Nm") != std::string_view::npos)
        return "an index is out of range";
    if (rule.find("empty()") != std::string_view::npos) return "the first or last of nothing was asked for";
    if (rule.find("_M_is_engaged()") != std::string_view::npos)
        return "the value of an empty optional was asked for";
    return "the standard library says" + std::string(rule.substr(1));
}

}  // namespace rt
