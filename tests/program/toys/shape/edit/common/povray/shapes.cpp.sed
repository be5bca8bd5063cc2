/^\/\/ Plane ---/i\
// Ball\
\
std::string open_statement(const Scene\&, const Ball\& ball) {\
    return fmt::format("sphere {{ {}, {}", triple(ball.middle), number(ball.half_width));\
}\
\
std::string with_uv(const Scene\& scene, const Ball\& ball, const std::string\& transform) {\
    return without_uv(open_statement(scene, ball), transform);\
}\
\
Extent extent_of(const Scene\& scene, const Ball\& ball, const Mat4\& m) {\
    return extent_of(scene, Sphere{ball.middle, ball.half_width}, m);\
}\
\
void scale(Scene\&, Ball\& ball, Real factor) { ball.middle *= factor, ball.half_width *= factor; }\

