// How the tests of this chapter print points: as all tests do.
#pragma once

#include "tests/show.hpp"
