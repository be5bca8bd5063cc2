// Programs that test a chapter draw what shows its steps, too: they are linked with the student's chapter, so
// that a picture costs no further build.
#include "common/pictures/step_picture.hpp"
#include "tests/own_options.hpp"

namespace {

const rt::test::OtherUse picture("--picture", rt::write_step_picture);
const rt::test::OtherUse pixel("--pixel", rt::write_step_pixel);

}  // namespace
