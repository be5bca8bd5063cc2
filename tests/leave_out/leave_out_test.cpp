// What a scene does not need costs nothing: the table that the program `leave_out` measures, judged.
#include "common/terminal/process.hpp"
#include "common/terminal/project.hpp"
#include "tests/catch.hpp"

#include <nlohmann/json.hpp>

#include <string>

using namespace rt;

namespace {

/// The measured cases; none where there is no valgrind to count instructions with.
const nlohmann::json& cases() {
    static const nlohmann::json measured = [] {
        const ProcessResult result = run_process({program(this_project(), "leave_out").string(), "--json"});
        if (result.exit_code == 2) {
            WARN(result.output);  // "leave_out: skipped: ..."
            return nlohmann::json::array();
        }
        INFO(result.output);
        REQUIRE(succeeded(result));
        nlohmann::json list = nlohmann::json::parse(result.output).at("cases");
        REQUIRE(list.size() >= 12);
        return list;
    }();
    return measured;
}

}  // namespace

TEST_CASE("a scene that does without a feature pays at most 1 % or 8 instructions a ray for it") {
    for (const auto& one : cases()) {
        if (!one.at("judged")) continue;
        const auto& instructions = one.at("instructions");
        INFO(one.at("feature") << ": " << instructions.dump());
        CHECK(instructions.at("general") <= instructions.at("limit"));
    }
}

TEST_CASE("the same scene with the feature would break that limit") {
    for (const auto& one : cases()) {
        const auto& instructions = one.at("instructions");
        INFO(one.at("feature") << ": " << instructions.dump());
        CHECK(instructions.at("with_feature") > instructions.at("limit"));
    }
}

TEST_CASE("leaving out changes neither the picture nor the number of rays") {
    for (const auto& one : cases()) {
        INFO(one.at("feature") << ": " << one.at("rays").dump());
        CHECK(one.at("same_picture") == true);
        CHECK(one.at("rays").at("general") == one.at("rays").at("minimal"));
        CHECK(one.at("rays").at("general").at("camera") == 64 * 48);
    }
}

TEST_CASE("a world keeps the bytes that its scene needs and no more") {
    for (const auto& one : cases()) {
        INFO(one.at("feature") << ": " << one.at("bytes").dump());
        CHECK(one.at("bytes").at("general") == one.at("bytes").at("minimal"));
    }
}
