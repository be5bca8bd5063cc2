// How a material spreads light, at a place.
#include "common/render/finish.hpp"

#include <algorithm>

namespace rt {

Finish finish_at(const World& world, const Material& material) {
    if (material.finish < 0) return {};
    Finish finish = world.finishes[static_cast<std::size_t>(material.finish)];
    const auto multiply = [&](bool is_textured, Real& number, Interval range) {
        if (is_textured) number = std::clamp(number * material.finish_factor, range.min, range.max);
    };
    const TexturedFinish& textured = finish.textured;
    multiply(finish.kind == FinishKind::Coated ? textured.coat : textured.finish, finish.value,
             word_of(finish.kind).range);
    multiply(textured.gloss, finish.gloss, gloss_range);
    multiply(textured.translucency, finish.translucency, gloss_range);
    multiply(textured.roughness, finish.roughness, roughness_range);
    return finish;
}

}  // namespace rt
