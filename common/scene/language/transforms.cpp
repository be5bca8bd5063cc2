// Commands of the current transform and its stack.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"

namespace rt::language {

namespace {

void add_transform(Parser& parser, const TransformStep& step) {
    parser.scene.transforms.push_back({parser.transform, step, place_of(parser, parser.words[0])});
    parser.transform = static_cast<int>(parser.scene.transforms.size()) - 1;
}

void add_rotation(Parser& parser) {
    const Vec3 axis = direction(parser, 1, "the axis of a rotation");
    add_transform(parser, Rotate{axis, radians(number(parser, 4))});
}

/// At time 0 it turns by nothing; what never turns is no step.
void add_spin(Parser& parser) {
    const Vec3 axis = direction(parser, 1, "the axis of a spin");
    const Real angle = radians(number(parser, 4));
    if (angle == 0) return;
    add_transform(parser, Rotate{axis, 0});
    parser.scene.transforms.back().spin = angle;
}

void add_scaling(Parser& parser) {
    const Vec3 by = vec3(parser, 1);
    for (std::size_t i = 0; i < 3; ++i)
        if (by[static_cast<int>(i)] == 0)
            fail(parser, parser.words[i + 1], "a scale factor of 0 makes things flat; it must not be 0");
    add_transform(parser, Scale{by});
}

void pop_transform(Parser& parser) {
    if (parser.transform_stack.empty())
        fail(parser, parser.words[0], "'popTransform' without a 'pushTransform' before it");
    parser.transform = parser.transform_stack.back();
    parser.transform_stack.pop_back();
}

const CommandRow rows[] = {
    {{"translate", "x y z", "Multiply the current transform on the right by a translation.", "04"},
     [](Parser& p) { add_transform(p, Translate{vec3(p, 1)}); }},
    {{"rotate", "x y z degrees",
      "Likewise by a rotation about the axis (x, y, z), counterclockwise as seen from the axis's tip.", "04"},
     add_rotation},
    {{"scale", "x y z", "Likewise by a scaling; no factor may be 0.", "04"}, add_scaling},
    {{"spin", "x y z degrees",
      "Multiply the current transform on the right by a rotation that takes time: its angle grows evenly "
      "from 0 at time 0 to `degrees` at time 1, which may be several turns. Scales before it must be the "
      "same along all axes. `motion` moves the whole.",
      "12"},
     add_spin},
    {{"pushTransform", "", "Remember the current transform.", "04"},
     [](Parser& p) { p.transform_stack.push_back(p.transform); }},
    {{"popTransform", "", "Return to the transform remembered last.", "04"}, pop_transform},
};

}  // namespace

std::span<const CommandRow> transform_commands() { return rows; }

}  // namespace rt::language
