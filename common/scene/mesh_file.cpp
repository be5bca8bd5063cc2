// Meshes from Wavefront `.obj` files: one pass over the words, then what had to wait for the whole file –
// indices of vertices that come later, and the cutting of faces that name them.
#include "common/scene/mesh_file.hpp"

#include "common/math/input_error.hpp"
#include "common/scene/cut_polygon.hpp"
#include "common/scene/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace rt {

namespace {

/// Statements without shape: groups, names, materials, how to draw, points and lines.
constexpr std::string_view passed_over[] = {
    "g",        "o",    "s",      "mg",     "l",          "p",         "bevel",  "c_interp",
    "d_interp", "lod",  "usemtl", "mtllib", "usemap",     "maplib",    "ctech",  "stech",
    "deg",      "bmat", "step",   "cstype", "shadow_obj", "trace_obj", "vp",     "parm",
    "trim",     "hole", "scrv",   "sp",     "end",        "con",       "usemat", "newobj",
};

/// Statements whose shape would be missing.
constexpr std::string_view unsupported[] = {"curv", "curv2", "surf", "bsp", "bzp",
                                            "cdc",  "cdp",   "res",  "call"};

template <std::size_t N>
bool is_one_of(std::string_view word, const std::string_view (&words)[N]) {
    return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// Line and column, both from 1.
struct Place {
    int line = 0;
    int column = 0;
};

/// A face of more than three corners.
struct Face {
    std::size_t triangles_before = 0;  ///< how many faces of three corners stand before it
    std::size_t first_corner = 0;      ///< in MeshReader::corners
    std::size_t count = 0;             ///< of corners
    Place place;
};

/// The greatest index that a face named before there was such a vertex.
struct Promise {
    std::size_t count = 0;  ///< how many there must be
    Place place;
};

/// The state in the middle of a file.
class MeshReader {
public:
    MeshReader(const std::string& file, const MeshOptions& how) : name(file), options(how) {}

    Mesh read(std::string_view text) {
        while (!text.empty()) {
            take_statement(text);
            if (!words.empty()) read_statement();
        }
        keep_promise(positions, mesh.positions.size(), "vertex");
        keep_promise(normals, mesh.normals.size(), "normal");
        keep_promise(uvs, mesh.uvs.size(), "texture coordinate");
        cut_faces();
        if (mesh.triangles.empty()) throw InputError(name + ": has no faces");
        forget_zero_normals();
        mesh.file = name;
        return std::move(mesh);
    }

private:
    // Words

    /// Fills `words` with those of the next line, and of the lines that a `\` at the end joins to it.
    void take_statement(std::string_view& text) {
        words.clear();
        statement = text;
        statement_line = ++line_number;
        comment_in_word = nullptr;
        bool goes_on = read_words(take_line(text));
        for (; goes_on && !text.empty(); ++line_number) goes_on = read_words(take_line(text));
    }

    /// Appends the words of one line; whether it ends with a `\`.
    bool read_words(std::string_view line) {
        const char* const inside = split_words(line, line_words);
        if (inside) comment_in_word = inside;
        const bool goes_on = !inside && !line_words.empty() && line_words.back().ends_with('\\');
        if (goes_on) line_words.back().remove_suffix(1);
        if (goes_on && line_words.back().empty()) line_words.pop_back();
        words.insert(words.end(), line_words.begin(), line_words.end());
        return goes_on;
    }

    /// Of a byte of the current statement.
    Place place_of(const char* at) const {
        std::string_view rest = statement;
        Place place{statement_line, 1};
        while (true) {
            const std::string_view line = take_line(rest);
            if (at <= line.data() + line.size()) return {place.line, static_cast<int>(at - line.data()) + 1};
            ++place.line;
        }
    }
    Place place_of(std::string_view word) const { return place_of(word.data()); }

    std::string message(Place place, const std::string& what) const {
        return at_place(name, place.line, place.column, what);
    }
    [[noreturn]] void fail(Place place, const std::string& what) const {
        throw InputError(message(place, what));
    }
    void warn(Place place, const std::string& what) const {
        if (options.warnings) options.warnings->push_back(message(place, what));
    }

    // Statements

    void read_statement() {
        const std::string_view word = words[0];
        if (word == "v")
            mesh.positions.push_back(numbers(3));
        else if (word == "vn")
            mesh.normals.push_back(numbers(3));
        else if (word == "vt")
            mesh.uvs.push_back(Vec2(numbers(1)));
        else if (word == "f" || word == "fo")  // `fo` is what the first version of the format says
            read_face();
        else
            return pass_over(word);
        if (comment_in_word) warn(place_of(comment_in_word), std::string(comment_inside_word));
    }

    /// The first three numbers after the keyword, 0 where there are fewer; all words must be numbers.
    Vec3 numbers(std::size_t at_least) const {
        if (words.size() <= at_least)
            fail(place_of(words.back().data() + words.back().size()),
                 quoted(words[0]) + " needs " + std::to_string(at_least) +
                     (at_least == 1 ? " number" : " numbers") + ", here are " +
                     std::to_string(words.size() - 1));
        Vec3 values(0);
        for (std::size_t i = 1; i < words.size(); ++i) {
            const ParsedNumber number = parse_number(words[i]);
            if (!number.problem.empty())
                fail(place_of(words[i]), quoted(words[i]) + " " + std::string(number.problem));
            if (i <= 3) values[static_cast<int>(i) - 1] = number.value;
        }
        return values;
    }

    /// A statement that is none of those that are read: an error where shape is missing, a warning once for
    /// each kind that nobody knows.
    void pass_over(std::string_view word) {
        if (is_one_of(word, passed_over)) return;
        const bool has_shape = is_one_of(word, unsupported);
        const std::string what =
            quoted(word) + (has_shape
                                ? (word == "call" ? ": other files are not read from here"
                                                  : ": free-form curves and surfaces are not supported; "
                                                    "save the model as polygons")
                                : " is not a statement of these files");
        if (has_shape && !options.lenient) fail(place_of(word), what);
        if (std::find(warned_of.begin(), warned_of.end(), word) != warned_of.end()) return;
        warned_of.emplace_back(word);
        warn(place_of(word), what + " (such lines are skipped)");
    }

    void read_face() {
        const std::size_t count = words.size() - 1;
        if (count < 3)
            fail(place_of(words.back().data() + words.back().size()),
                 "a face needs at least 3 corners, here are " + std::to_string(count));
        if (count == 3) {
            mesh.triangles.push_back({corner(words[1]), corner(words[2]), corner(words[3])});
            return;
        }
        faces.push_back({mesh.triangles.size(), corners.size(), count, place_of(words[0])});
        for (std::size_t i = 1; i <= count; ++i) corners.push_back(corner(words[i]));
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`; all but `v` may be empty.
    Mesh::Corner corner(std::string_view word) {
        const std::size_t first = std::min(word.find('/'), word.size());
        const std::size_t second = std::min(word.find('/', first + 1), word.size());
        const auto part = [&](std::size_t from, std::size_t to) {
            return from < to ? word.substr(from, to - from) : std::string_view();
        };
        Mesh::Corner result;
        result.position = index(word, word.substr(0, first), mesh.positions.size(), "vertices", positions);
        if (const auto uv = part(first + 1, second); !uv.empty())
            result.uv = index(word, uv, mesh.uvs.size(), "texture coordinates", uvs);
        if (const auto normal = part(second + 1, word.size()); !normal.empty())
            result.normal = index(word, normal, mesh.normals.size(), "normals", normals);
        return result;
    }

    /// An index from 1, or negative from the end, to one from 0; `count` have been given so far.
    std::int32_t index(std::string_view whole, std::string_view word, std::size_t count, const char* plural,
                       Promise& promise) {
        const char* const end = word.data() + word.size();
        long value = 0;
        const auto [stop, error] = std::from_chars(word.data(), end, value);
        if (error == std::errc::invalid_argument || stop != end)
            fail(place_of(whole),
                 quoted(whole) + " is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn");
        if (error == std::errc() && value == 0)
            fail(place_of(whole), quoted(whole) + ": indices count from 1");
        const bool is_far = error != std::errc() || value > std::numeric_limits<std::int32_t>::max() ||
                            value < -std::numeric_limits<std::int32_t>::max();
        if (word.front() == '-' && (is_far || value < -static_cast<long>(count)))
            fail(place_of(whole), quoted(whole) + ": the number of " + plural + " before this line is " +
                                      std::to_string(count));
        if (is_far) fail(place_of(whole), quoted(whole) + ": there is no file with so many " + plural);
        if (value < 0) return static_cast<std::int32_t>(static_cast<long>(count) + value);
        if (static_cast<std::size_t>(value) > std::max(count, promise.count))
            promise = {static_cast<std::size_t>(value), place_of(whole)};
        return static_cast<std::int32_t>(value - 1);
    }

    // What waits for the end of the file

    void keep_promise(const Promise& promise, std::size_t count, const char* noun) const {
        if (promise.count > count)
            fail(promise.place, "there is no " + std::string(noun) + " " + std::to_string(promise.count) +
                                    ": the file has " + std::to_string(count));
    }

    /// Puts the triangles of faces of more than three corners between the others, in the file's order.
    void cut_faces() {
        if (faces.empty()) return;
        std::vector<std::array<Mesh::Corner, 3>> all;
        all.reserve(mesh.triangles.size() + corners.size() - 2 * faces.size());
        auto next = mesh.triangles.begin();
        for (const Face& face : faces) {
            const auto here = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(face.triangles_before);
            all.insert(all.end(), next, here);
            next = here;
            cut(face, all);
        }
        all.insert(all.end(), next, mesh.triangles.end());
        mesh.triangles = std::move(all);
    }

    void cut(const Face& face, std::vector<std::array<Mesh::Corner, 3>>& all) const {
        const Mesh::Corner* const corner = corners.data() + face.first_corner;
        std::vector<Vec3> places;
        for (std::size_t i = 0; i < face.count; ++i)
            places.push_back(mesh.positions[static_cast<std::size_t>(corner[i].position)]);
        const PolygonCut result = cut_polygon(places);
        for (const auto& [a, b, c] : result.triangles) all.push_back({corner[a], corner[b], corner[c]});
        if (result.problem.empty()) return;
        const std::string what = "the face " + std::string(result.problem);
        if (!options.lenient) fail(face.place, what);
        warn(face.place, what + " (skipped)");
    }

    void forget_zero_normals() {
        const auto is_zero = [](const Vec3& n) { return n == Vec3(0); };
        if (std::none_of(mesh.normals.begin(), mesh.normals.end(), is_zero)) return;
        for (auto& triangle : mesh.triangles)
            for (Mesh::Corner& corner : triangle)
                if (corner.normal >= 0 && is_zero(mesh.normals[static_cast<std::size_t>(corner.normal)]))
                    corner.normal = -1;
    }

    const std::string& name;
    const MeshOptions& options;
    Mesh mesh;
    std::vector<Mesh::Corner> corners;  ///< of all faces of more than three
    std::vector<Face> faces;
    Promise positions, normals, uvs;
    std::vector<std::string> warned_of;

    int line_number = 0;
    int statement_line = 0;                 ///< where the current statement begins
    std::string_view statement;             ///< the text from there on
    const char* comment_in_word = nullptr;  ///< in the current statement
    std::vector<std::string_view> words, line_words;
};

}  // namespace

Mesh parse_mesh(std::string_view text, const std::string& name, const MeshOptions& options) {
    text = without_bom(text);
    check_is_text(text, name);
    return MeshReader(name, options).read(text);
}

Mesh read_mesh(const std::filesystem::path& path, const MeshOptions& options) {
    return parse_mesh(read_text(path, path.string()), path.string(), options);
}

}  // namespace rt
