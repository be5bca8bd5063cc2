s/using Shapes = List</&Ball, Placed<Ball>, /
/^inline constexpr ShapeWords words = /a\
template <>\
inline constexpr ShapeWords words<Ball>{"ball", "balls", {"97.1"}};\
template <>\
inline constexpr ShapeWords words<Placed<Ball>>{"placed ball", "placed balls", {"04.6", "97.1"}};
