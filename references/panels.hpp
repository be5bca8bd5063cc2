// Pictures side by side in one drawing, each with its words above it.
#pragma once

#include "common/image/format.hpp"
#include "common/terminal/base64.hpp"
#include "references/figures.hpp"

namespace rt::figures {

struct Panel {
    Image image;
    std::string words;
};

/// Draws the image with its top left corner at `corner`, each of its pixels `scale` pixels wide.
inline void picture(Svg& svg, Vec2 corner, const Image& image, Real scale = 1) {
    svg.body += "<image x=\"" + decimal(corner.x) + "\" y=\"" + decimal(corner.y) + "\" width=\"" +
                decimal(scale * image.width) + "\" height=\"" + decimal(scale * image.height) +
                "\" style=\"image-rendering: pixelated\" href=\"data:image/png;base64," +
                base64(format::png(image, Encoding::Srgb)) + "\"/>\n";
}

/// Panels of one size in rows.
inline Svg side_by_side(const std::vector<Panel>& panels, int columns, Real scale = 1) {
    const Real gap = 12, line = 30;
    const Vec2 step(scale * panels[0].image.width + gap, scale * panels[0].image.height + line + gap / 2);
    const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    Svg svg{.width = static_cast<int>(columns * step.x + gap),
            .height = static_cast<int>(rows * step.y + gap / 2)};
    for (int i = 0; i < static_cast<int>(panels.size()); ++i) {
        const Panel& panel = panels[static_cast<std::size_t>(i)];
        const Vec2 corner = Vec2(gap, line) + step * Vec2(i % columns, i / columns);
        text(svg, corner + Vec2(step.x - gap, -16) * Vec2(0.5, 0.5), panel.words,
             {.size = 19, .anchor = "middle", .bold = true});
        picture(svg, corner, panel.image, scale);
    }
    return svg;
}

}  // namespace rt::figures
