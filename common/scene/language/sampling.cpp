// Commands that say where the samples of a pixel lie and what each counts.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"

namespace rt::language {

namespace {

constexpr Word<Sampler> samplers[] = {{"jittered", Sampler::Jittered},   {"random", Sampler::Random},
                                      {"regular", Sampler::Regular},     {"poisson", Sampler::Poisson},
                                      {"trapezoid", Sampler::Trapezoid}, {"centered", Sampler::Centered},
                                      {"sobol", Sampler::Sobol}};
constexpr Word<Filter> filters[] = {{"box", {FilterKind::Box, 0.5}},
                                    {"tent", {FilterKind::Tent, 1}},
                                    {"gaussian", {FilterKind::Gaussian, 1.5}},
                                    {"mitchell", {FilterKind::Mitchell, 2}}};

void set_samples(Parser& parser) {
    parser.scene.sampling.count =
        static_cast<int>(whole_setting(parser, "the number of samples", 1, most_samples));
}

void set_adaptive(Parser& parser) {
    parser.scene.sampling.adaptive = choice(parser, on_or_off);
    parser.adaptive_place = message_at(parser, parser.words[0].data(), "");
}

void set_seed(Parser& parser) {
    parser.scene.sampling.seed = static_cast<std::uint64_t>(whole_setting(parser, "the seed", 0, 0x1p53 - 1));
}

const CommandRow rows[] = {
    {{"spp", "n", "Samples a pixel, from 1 to 65536; default 1, which lies in the pixel's centre.", "08"},
     set_samples},
    {{"sampler", alternatives(samplers),
      "Where several samples lie: one at random in each of equal cells (default), all at random, in the "
      "middles of equal cells, at random but no two near each other, on the corners of cells with the "
      "trapezoid "
      "rule's weights, in the middles and one more at the centre, or on scrambled Sobol' points. What a "
      "sample needs besides, as points of the lens and of lights, is spread likewise.",
      "08"},
     [](Parser& p) { p.scene.sampling.sampler = choice(p, samplers); }},
    {{"adaptive", alternatives(on_or_off),
      "Whether pixels whose colours differ more get more of the samples; `spp` is then their mean number. "
      "For the samplers `jittered` and `random`; default off.",
      "08"},
     set_adaptive},
    {{"filter", alternatives(filters),
      "How much a sample counts for a pixel, by its distance from the centre along each axis: all in the "
      "pixel "
      "alike (default); less and less up to 1 pixel, or 1.5; the cubic of Mitchell and Netravali up to 2.",
      "08"},
     [](Parser& p) { p.scene.sampling.filter = choice(p, filters); }},
    {{"seed", "n", "Which random numbers are used, from 0 to 2^53 − 1; default 0.", "08"}, set_seed},
};

}  // namespace

std::span<const CommandRow> sampling_commands() { return rows; }

void require_adaptable_sampler(const Parser& parser) {
    const Sampling& sampling = parser.scene.sampling;
    if (!sampling.adaptive || sampling.sampler == Sampler::Jittered || sampling.sampler == Sampler::Random)
        return;
    throw InputError(parser.adaptive_place +
                     "'adaptive on' needs 'sampler jittered' or 'sampler random': the other patterns have a "
                     "given number of samples");
}

}  // namespace rt::language
