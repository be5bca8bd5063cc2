// Why a scene's parts were kept or left out, as `course render` and `course explain` print it for machines.
#pragma once

#include "common/render/explain.hpp"

#include <nlohmann/json.hpp>

#include <vector>

namespace rt {

/// [{"what","why"}].
inline nlohmann::ordered_json reasons_json(const std::vector<Reason>& reasons) {
    auto list = nlohmann::ordered_json::array();
    for (const Reason& reason : reasons) list.push_back({{"what", reason.what}, {"why", reason.why}});
    return list;
}

}  // namespace rt
