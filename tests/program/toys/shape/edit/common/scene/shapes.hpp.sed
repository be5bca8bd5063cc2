/^\/\/\/ All points at distance `radius`/i\
/// A sphere by another name.\
struct Ball {\
    Vec3 middle{0};\
    Real half_width = 1;\
};\

s/using FileShape = std::variant</&Ball, /
