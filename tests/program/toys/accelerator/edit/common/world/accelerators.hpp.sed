s/^#include "common\/world\/grid.hpp"/#include "common\/world\/boxes.hpp"\
&/
s/^using Accelerator = std::variant<Nothing, Grid/&, Boxes/
