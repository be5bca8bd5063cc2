// More samples where the colours of a pixel differ more.
#pragma once

#include "common/render/passes.hpp"

namespace rt {

/// Sets picture.counts, `mean` on average, from a pilot of so many samples a pixel that looks where colours
/// differ. The pilot's own samples are not part of the picture: a mean of samples that decided their number
/// would be biased (Kirk & Arvo 1991). Its rays count as the picture's.
void adapt_counts(SampledPicture& picture, int pilot, int mean);

}  // namespace rt
