// Numbers as colours.
#include "common/image/color_map.hpp"

#include "common/image/encoding.hpp"

namespace rt {

Vec3 magma(Real value) {
    // A polynomial near the map's 256 colours, by M. Zucker.
    constexpr Real coefficients[][3] = {{-0.002136485053939582, -0.000749655052795221, -0.005386127855323933},
                                        {0.2516605407371642, 0.6775232436837668, 2.494026599312351},
                                        {8.353717279216625, -3.577719514958484, 0.3144679030132573},
                                        {-27.66873308576866, 14.26473078096533, -13.64921318813922},
                                        {52.17613981234068, -27.94360607168351, 12.94416944238394},
                                        {-50.76852536473588, 29.04658282127291, 4.23415299384598},
                                        {18.65570506591883, -11.48977351997711, -5.601961508734096}};
    const Real t = displayable(value);
    Vec3 color(0);
    for (int i = 6; i >= 0; --i)
        color = color * t + Vec3(coefficients[i][0], coefficients[i][1], coefficients[i][2]);
    return {decode(color.x, Encoding::Srgb), decode(color.y, Encoding::Srgb),
            decode(color.z, Encoding::Srgb)};
}

}  // namespace rt
