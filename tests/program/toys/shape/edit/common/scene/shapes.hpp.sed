/^\/\/\/ All points at distance `radius`/i\
/// A sphere by another name, but nothing is inside of it: a soap bubble.\
struct Ball {\
    Vec3 middle{0};\
    Real half_width = 1;\
};\

/^using FileShape/,/;/s/std::variant</&Ball, /
/^inline constexpr FileShapeWords file_words = /a\
template <>\
inline constexpr FileShapeWords file_words<Ball>{"ball", false};
