// The integrators that a scene may ask for, by their words.
#include "common/scene/integrators.hpp"

namespace rt {

std::optional<IntegratorChoice> integrator_named(std::string_view word) {
    if (word == rasterize_word) return IntegratorChoice{Integrator::Normals, Visibility::Rasterize};
    for (const IntegratorRow& row : integrators)
        if (row.name == word) return IntegratorChoice{row.value, Visibility::Rays};
    return std::nullopt;
}

std::vector<std::string_view> integrator_names() {
    std::vector<std::string_view> names;
    for (const IntegratorRow& row : integrators) names.push_back(row.name);
    names.push_back(rasterize_word);
    return names;
}

std::string integrators_with(bool IntegratorRow::*property) {
    std::vector<std::string_view> names;
    for (const IntegratorRow& row : integrators)
        if (row.*property) names.push_back(row.name);
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i)
        list.append(i == 0 ? "" : i + 1 < names.size() ? ", " : " and ").append(names[i]);
    return list;
}

}  // namespace rt
