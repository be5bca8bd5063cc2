// One finish of POV-Ray has one pigment for every term, where our materials have a colour for each. So a
// material becomes up to four layers of texture.
#include "common/povray/materials.hpp"

#include "common/povray/optics.hpp"

#include <utility>

namespace rt::povray {
namespace {

std::string highlight(const Material& m, Real strength) {
    if (m.highlight == Highlight::Phong)
        return fmt::format(" phong {} phong_size {}", number(strength), number(m.shininess));
    // POV-Ray's exponent is 1/roughness; the largest roughness stands for exponent 0.
    const Real roughness = m.shininess > 0 ? 1 / m.shininess : 1e30;
    return fmt::format(" specular {} roughness {}", number(strength), number(roughness));
}

bool has_fresnel(const Material& m) { return is_transparent(m) && m.fresnel != Fresnel::None; }

/// What POV-Ray must know to put a material's layers together.
struct Terms {
    bool diffuse, highlight;
    bool filtered;  ///< the highlight has a colour, which a layer of its own gives it
    bool bottom;    ///< something is left for the lowest layer
    Vec3 glow;
    Real strongest;  ///< channel of the highlight
    /// What each coloured layer lets through. Half is the more readable number. But conserve_energy also dims
    /// the light of layers below the one that reflects, and POV-Ray leaves out layers from which less than
    /// adc_bailout arrives. There the upper layers hide nothing that a 16-bit step could show.
    Real share;
};

Terms terms_of(const Scene& scene, const Material& m) {
    const bool lit = !scene.lights.empty();
    const bool highlight = lit && !is_black(m.specular), filtered = highlight && !is_grey(m.specular);
    return {.diffuse = lit && !is_black(m.diffuse),
            .highlight = highlight,
            .filtered = filtered,
            .bottom = filtered || is_transparent(m),
            .glow = m.ambient + m.emission,
            .strongest = max_component(m.specular),
            .share = has_fresnel(m) || scene.min_contribution > 0 ? 1 - 0x1p-16 : 0.5};
}

/// The layers so far, from the top. The strengths of those below make up for what the upper ones keep.
struct Layers {
    const Material& m;
    const Terms& terms;
    std::string top;  ///< belongs into the finish of the first
    Real over = 1;    ///< what they let through
    std::vector<std::string> texts{};

    void add(const std::string& pigment, const std::string& finish) {
        texts.push_back(fmt::format("texture {{ pigment {{ {} }} finish {{ ambient 0 {}{} }} }}", pigment,
                                    finish, std::exchange(top, "")));
    }

    void add_colored(const Vec3& color, bool is_last, std::string_view term) {
        const Real kept = is_last ? 1 : 1 - terms.share;
        add(patterned(color, m.checker, is_last ? "" : " transmit " + number(terms.share)),
            fmt::format("{} {}", term, number(1 / (kept * over))));
        if (!is_last) over *= terms.share;
    }

    /// The highlight, if it was filtered, and what shines through.
    void add_bottom() {
        std::string pigment = "rgb 0", finish = "diffuse 0";
        if (is_transparent(m)) {
            Vec3 through(0);
            for (int i = 0; i < 3; ++i)
                if (m.transmission[i] > 0)
                    through[i] =
                        m.transmission[i] / over / (terms.filtered ? m.specular[i] / terms.strongest : 1);
            pigment = rgb(through) + " filter 1";
        }
        if (terms.filtered) finish += highlight(m, terms.strongest / over);
        if (has_fresnel(m))
            finish +=
                fmt::format(" reflection {{ rgb 0, rgb {} fresnel }} conserve_energy", number(1 / over));
        add(pigment, finish);
    }
};

/// From the top: diffuse, emission, a filter that colours the highlight, and below it the highlight itself
/// and what shines through.
std::string texture(const Scene& scene, const Material& m) {
    const Terms terms = terms_of(scene, m);
    std::string top =
        has_fresnel(m) || is_black(m.specular) ? "" : fmt::format(" reflection {{ {} }}", rgb(m.specular));
    if (terms.highlight && !terms.filtered) top += highlight(m, m.specular.x);
    Layers layers{m, terms, std::move(top)};
    if (terms.diffuse) layers.add_colored(m.diffuse, is_black(terms.glow) && !terms.bottom, "diffuse");
    if (!is_black(terms.glow)) layers.add_colored(terms.glow, !terms.bottom, "diffuse 0 emission");
    if (terms.filtered) layers.add(rgb(m.specular / terms.strongest) + " filter 1", "diffuse 0");
    if (terms.bottom || layers.texts.empty()) layers.add_bottom();
    std::string text;
    for (auto layer = layers.texts.rbegin(); layer != layers.texts.rend(); ++layer)
        text += "  " + *layer + "\n";
    return text;
}

/// Calls write(i, material) for the materials that objects have.
template <class Write>
void visit_used(const Scene& scene, Write write) {
    std::vector<bool> used(scene.materials.size(), false);
    for (const Object& object : scene.objects) used[object.material] = true;
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        if (used[i]) write(i, scene.materials[i]);
}

}  // namespace

std::string patterned(const Vec3& color, const Checker& checker, std::string_view more) {
    if (checker.even == Vec3(1) && checker.odd == Vec3(1)) return rgb(color) + std::string(more);
    return fmt::format("checker {}{} {}{} scale {}", rgb(color * checker.even), more,
                       rgb(color * checker.odd), more, number(checker.size));
}

void write_materials(Writer& out) {
    visit_used(out.scene, [&](std::size_t i, const Material& m) {
        out.line("#declare Material{} =\n{}", i, texture(out.scene, m));
    });
}

void write_flat_materials(Writer& out) {
    visit_used(out.scene, [&](std::size_t i, const Material& m) {
        out.line("#declare Material{} =", i);
        out.line("  texture {{ pigment {{ {} }} finish {{ ambient 0 diffuse 0 emission 1 }} }}\n",
                 patterned(m.ambient + m.emission, m.checker));
    });
}

}  // namespace rt::povray
