// Documents held against their written schemas.
#pragma once

#include "common/terminal/process.hpp"
#include "tests/support.hpp"

#include <fstream>
#include <string>
#include <vector>

namespace rt::test {

/// A file in the scratch directory with this text.
inline std::string scratch_file(const std::string& name, const std::string& text) {
    const std::string path = scratch_directory() + "/" + name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

/// What a validator says against these; nothing if it accepts them all. `schema` is a path from the root.
inline std::string against_schema(const std::vector<std::string>& documents, const std::string& schema) {
    std::vector<std::string> command{"jsonschema"};
    for (const std::string& document : documents) {
        command.push_back("-i");
        command.push_back(scratch_file("document" + std::to_string(command.size()) + ".json", document));
    }
    command.push_back(repository() + "/" + schema);
    const ProcessResult result = run_process(command);
    return succeeded(result) ? "" : "jsonschema refuses: " + result.output;
}

inline std::string against_xsd(const std::string& document, const std::string& schema) {
    const ProcessResult result =
        run_process({"xmllint", "--noout", "--nonet", "--schema", repository() + "/" + schema,
                     scratch_file("document.xml", document)});
    return succeeded(result) ? "" : "xmllint refuses: " + result.output;
}

}  // namespace rt::test
