// A toy accelerator: only shapes whose boxes are met are asked.
#pragma once

#include "common/world/accelerators.hpp"

#include <string>

namespace rt {

/// What common/world/accelerators.hpp asks of every accelerator.
bool serves(const Boxes& boxes, const Ray& ray);
void search(const Boxes& boxes, const Ray& ray, Interval range, const Ask& ask);
std::size_t bytes_of(const Boxes& boxes);
std::string in_words(const Boxes& boxes);

}  // namespace rt
