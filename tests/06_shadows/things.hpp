// Worlds of a few shapes.
#pragma once

#include "chapters/06_shadows/shadow.hpp"
#include "common/render/compile.hpp"

#include <utility>
#include <variant>
#include <vector>

namespace rt::test {

/// A shape and which part of light it lets through.
struct Thing {
    std::variant<Sphere, Plane> shape;
    Vec3 transmission{0};
};

inline World world_of(const std::vector<Thing>& things) {
    Scene scene;
    for (const auto& [shape, transmission] : things) {
        Object object{
            .shape = Sphere{}, .material = static_cast<std::uint32_t>(scene.materials.size()), .place = {}};
        std::visit([&](const auto& one) { object.shape = one; }, shape);
        scene.objects.push_back(object);
        scene.materials.emplace_back();
        scene.materials.back().transmission = transmission;
    }
    return compile(scene);
}

}  // namespace rt::test
