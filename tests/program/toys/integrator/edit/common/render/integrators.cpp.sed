/^\/\/\/ The rendering half of a row\./i\
// silhouette\
\
Vec3 silhouette_color(const World\& world, const Ray\& ray, Stream\&) {\
    return closest_hit(world, ray, everything) ? Vec3(1) : background(world, ray.direction);\
}\
\
RayColor silhouette(const World\&) { return silhouette_color; }\

/^constexpr Renderer renderers\[\] = {/,/^};/s/^};/    {Integrator::Silhouette, silhouette},\
&/
