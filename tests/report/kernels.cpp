// All kernels, one after the other.
#include "tests/report/kernels.hpp"

#include "tests/report/kernel.hpp"

namespace rt::report {

Kernels measure_kernels(const KernelOptions& options, const Told& told) {
    constexpr std::pair<void (*)(const KernelOptions&, Kernels&, const Told&), double> parts[] = {
        {measure_spheres, 0.3},
        {measure_triangles, 0.6},
        {measure_tori, 0.75},
        {measure_quadrics, 0.8},
        {measure_implicits, 0.9},
        {[](const KernelOptions& o, Kernels& kernels, const Told& t) { kernels.maps = measure_maps(o, t); },
         1},
    };
    Kernels kernels;
    double from = 0;
    for (const auto& part : parts) {
        const double to = part.second;
        part.first(options, kernels, [&](double done) {
            if (told) told(from + (to - from) * done);
        });
        from = to;
    }
    return kernels;
}

}  // namespace rt::report
