// Words that other programs use for what this language calls otherwise, and words of chapters to come.
// Spelling finds what is misspelt (suggest.hpp); these tables find what is called otherwise.
#include "common/scene/elsewhere.hpp"

#include "common/scene/suggest.hpp"

#include <algorithm>

namespace rt {

namespace {

/// A word, and what it is called here; of two names each is quoted.
struct Synonym {
    std::string_view word, here;
};

constexpr Synonym commands[] = {
    // The picture
    {"resolution", "size"},
    {"imagesize", "size"},
    {"viewport", "size"},
    {"film", "size"},
    {"filename", "output"},
    {"outfile", "output"},
    {"lookat", "camera"},
    {"eye", "camera"},
    {"view", "camera"},
    {"ortho", "orthographic"},
    {"renderer", "integrator"},
    {"bgcolor", "background"},
    {"sky", "background' or 'skyGradient"},
    {"envmap", "environment"},
    {"skybox", "environment"},
    {"hdri", "environment"},
    {"samples", "spp"},
    {"samplesperpixel", "spp"},
    {"sampleCount", "spp"},
    {"supersample", "spp"},
    {"supersampling", "spp"},
    {"antialias", "spp"},
    {"antialiasing", "spp"},
    {"aa", "spp"},
    {"depth", "maxdepth"},
    {"bounces", "maxdepth"},
    {"maxbounces", "maxdepth"},
    {"recursion", "maxdepth"},
    {"recursiondepth", "maxdepth"},
    {"acceleration", "accelerator"},
    // Shapes
    {"ball", "sphere"},
    {"triangle", "tri"},
    {"face", "tri"},
    {"triangleNormal", "trinormal"},
    {"smoothTriangle", "trinormal"},
    {"quad", "polygon"},
    {"poly", "polygon"},
    {"obj", "mesh"},
    {"model", "mesh"},
    {"trimesh", "mesh"},
    {"halfspace", "plane"},
    {"floor", "plane"},
    {"move", "translate"},
    {"push", "pushTransform"},
    {"pushMatrix", "pushTransform"},
    {"pop", "popTransform"},
    {"popMatrix", "popTransform"},
    // Materials
    {"ka", "ambient"},
    {"kd", "diffuse"},
    {"ks", "specular"},
    {"ke", "emission"},
    {"kt", "transmission"},
    {"colour", "diffuse"},
    {"color", "diffuse"},
    {"albedo", "diffuse"},
    {"emissive", "emission"},
    {"reflection", "specular"},
    {"reflective", "specular"},
    {"reflectivity", "specular"},
    {"mirror", "specular"},
    {"phong", "shininess"},
    {"exponent", "shininess"},
    {"refraction", "transmission' or 'ior"},
    {"refractive", "transmission' or 'ior"},
    {"glass", "transmission' or 'ior"},
    {"transparency", "transmission"},
    {"transparent", "transmission"},
    {"opacity", "transmission"},
    {"refractiveIndex", "ior"},
    {"indexOfRefraction", "ior"},
    {"eta", "ior"},
    {"map", "texture"},
    {"textureMap", "texture"},
    {"image", "texture"},
    {"bump", "bumps"},
    {"material", "finish"},
    // Lights
    {"light", "point' or 'directional"},
    {"lightsource", "point' or 'directional"},
    {"pointLight", "point"},
    {"spotLight", "point"},
    {"directionalLight", "directional"},
    {"distantLight", "directional"},
    {"sun", "directional"},
    {"falloff", "attenuation"},
    {"areaLight", "quadLight"},
    {"rectLight", "quadLight"},
    {"diskLight", "discLight"},
    // What blurs
    {"dof", "lens"},
    {"depthOfField", "lens"},
    {"focus", "lens"},
    {"focalBlur", "lens"},
    {"blades", "aperture"},
    {"velocity", "motion"},
    {"motionBlur", "motion"},
    {"angularVelocity", "spin"},
    {"turn", "rotate' or 'spin"},
    {"glossiness", "gloss"},
};

constexpr Synonym choices[] = {
    {"integrator whitted", "raytrace"},
    {"integrator recursive", "raytrace"},
    {"integrator zbuffer", "rasterize"},
    {"encoding gamma", "srgb"},
    {"encoding none", "linear"},
    {"sampler stratified", "jittered"},
    {"sampler uniform", "random"},
    {"sampler independent", "random"},
    {"sampler grid", "regular"},
    {"sampler halton", "sobol"},
    {"sampler lowdiscrepancy", "sobol"},
    {"filter triangle", "tent"},
    {"shadows yes", "on"},
    {"shadows no", "off"},
    {"shadows true", "on"},
    {"shadows false", "off"},
    {"shadows 1", "on"},
    {"shadows 0", "off"},
    {"textured color", "diffuse"},
    {"textured colour", "diffuse"},
    {"textured albedo", "diffuse"},
    {"textured kd", "diffuse"},
    {"textured reflection", "specular"},
    {"textured mirror", "specular"},
    {"textured exponent", "shininess"},
    {"textured glossiness", "gloss"},
    {"textured alpha", "roughness"},
    {"textured clearcoat", "coat"},
};

/// A word, and the chapter that brings it.
struct Later {
    std::string_view word, chapter;
};

constexpr Later later[] = {
    {"accelerator octree", "13"}, {"accelerator kdtree", "13"},    {"accelerator bsp", "13"},
    {"accelerator binary", "13"}, {"integrator pathtracer", "14"}, {"nexteventestimation", "14"},
    {"importancesampling", "14"}, {"russianroulette", "14"},
};

/// A word that means something, and why it is not to be had here.
struct Refused {
    std::string_view word, why;
};

constexpr Refused refused[] = {
    {"textured ior", "a body has one index of refraction, by which light bends where it enters and leaves"},
};

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_letter);
}

template <std::size_t N>
std::string meaning(std::string_view word, const Synonym (&synonyms)[N]) {
    for (const auto& [other, here] : synonyms)
        if (same_word(word, other)) return "; did you mean '" + std::string(here) + "'?";
    for (const auto& [other, chapter] : later)
        if (same_word(word, other)) return "; it comes with chapter " + std::string(chapter);
    for (const auto& [other, why] : refused)
        if (same_word(word, other)) return "; " + std::string(why);
    return "";
}

}  // namespace

std::string meaning_elsewhere(std::string_view command) { return meaning(command, commands); }

std::string meaning_elsewhere(std::string_view command, std::string_view choice) {
    return meaning(std::string(command) + " " + std::string(choice), choices);
}

}  // namespace rt
