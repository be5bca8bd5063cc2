/^    Vec3 emission{0};/a\
    Real brightness = 1;  ///< factor on ambient and emission
