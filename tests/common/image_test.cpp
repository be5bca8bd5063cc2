// Images in files: the transfer curve, every format there and back, damaged files, whole-file writes.

#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <new>
#include <string>
#include <thread>

namespace rt {
namespace {

namespace fs = std::filesystem;
using test::error_of;

/// An empty directory that is gone at the end of the test.
struct Directory {
    fs::path path = fs::path(test::scratch_directory()) / ("image_test_" + std::to_string(::getpid()));
    Directory() {
        fs::remove_all(path);
        fs::create_directories(path);
    }
    Directory(const Directory&) = delete;
    Directory& operator=(const Directory&) = delete;
    ~Directory() { fs::remove_all(path); }

    fs::path operator/(const std::string& name) const { return path / name; }
    std::size_t count() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), {}));
    }
    /// A file with this content, made without the code under test.
    fs::path file(const std::string& name, const std::string& content) const {
        std::ofstream(path / name, std::ios::binary) << content;
        return path / name;
    }
};

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string read_error(const fs::path& path) {
    return error_of([&] { read_image(path); });
}

std::string big_endian(std::uint32_t n) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(n >> shift & 0xFF);
    return text;
}

std::string png_chunk(const std::string& type, const std::string& data) {
    std::uint32_t crc = ~0u;
    for (const char c : type + data) {
        crc ^= static_cast<std::uint8_t>(c);
        for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
    }
    return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(~crc);
}

enum PngColour : char { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, Rgba = 6 };

/// A PNG file by the book, uncompressed. `rows` begin with a filter byte each (0 = none).
std::string png_file(std::uint32_t width, std::uint32_t height, char depth, PngColour colour,
                     const std::string& rows, const std::string& palette = "") {
    std::uint32_t a = 1, b = 0;  // Adler-32
    for (const char c : rows) {
        a = (a + static_cast<std::uint8_t>(c)) % 65521;
        b = (b + a) % 65521;
    }
    std::string data = "\x78\x01";  // zlib header; then deflate blocks of at most 65535 bytes, stored
    for (std::size_t at = 0; at == 0 || at < rows.size(); at += 65535) {
        const std::string block = rows.substr(at, 65535);
        const int size = static_cast<int>(block.size());
        data += at + 65535 < rows.size() ? '\0' : '\1';  // the last has a mark
        for (const int n : {size, ~size})
            for (const int shift : {0, 8}) data += static_cast<char>(n >> shift & 0xFF);
        data += block;
    }
    data += big_endian(b << 16 | a);
    return "\x89PNG\r\n\x1a\n" +
           png_chunk("IHDR", big_endian(width) + big_endian(height) + depth + std::string{colour, 0, 0, 0}) +
           (palette.empty() ? "" : png_chunk("PLTE", palette)) + png_chunk("IDAT", data) +
           png_chunk("IEND", "");
}

/// The bytes of the given numbers.
std::string bytes(std::initializer_list<int> numbers) {
    std::string text;
    for (const int n : numbers) text += static_cast<char>(n);
    return text;
}

Image random_image(int width, int height, std::uint64_t seed) {
    test::Random random(seed);
    Image image = make_image(width, height);
    for (Vec3& p : image.pixels) p = 0.5 * (random.in_cube() + Vec3(1));
    return image;
}

constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

// ---- The transfer curve ----

TEST_CASE("sRGB has the values of its standard") {
    CHECK(encode_byte(0.5, Encoding::Srgb) == 188);  // 1.055 · 0.5^(1/2.4) − 0.055 = 187.516 / 255
    CHECK(encode_byte(0, Encoding::Srgb) == 0);
    CHECK(encode_byte(1, Encoding::Srgb) == 255);
    CHECK(encode_byte(0.2, Encoding::Srgb) == 124);   // 123.55
    CHECK(encode_byte(0.21, Encoding::Srgb) == 126);  // 126.43
    CHECK(decode(0.5, Encoding::Srgb) == Approx(0.21404114048223255).epsilon(1e-14));
    CHECK(decode(188 / 255.0, Encoding::Srgb) == Approx(0.5028864580325687).epsilon(1e-14));
    CHECK(decode(1, Encoding::Srgb) == 1);
}

TEST_CASE("sRGB is a straight line up to 0.0031308 and a power above") {
    CHECK(encode(0.0031308, Encoding::Srgb) == 12.92 * 0.0031308);
    CHECK(encode(std::nextafter(0.0031308, 1), Encoding::Srgb) == Approx(0.04044990748269014).epsilon(1e-14));
    CHECK(decode(0.04045, Encoding::Srgb) == 0.04045 / 12.92);
    CHECK(decode(std::nextafter(0.04045, 1), Encoding::Srgb) == Approx(0.0031308072830676845).epsilon(1e-14));
}

TEST_CASE("linear bytes are round(255 c)") {
    CHECK(encode_byte(0.5, Encoding::Linear) == 128);
    CHECK(encode_byte(0.49, Encoding::Linear) == 125);  // 124.95
    CHECK(encode_byte(1.4999 / 255, Encoding::Linear) == 1);
    CHECK(encode_byte(1.5001 / 255, Encoding::Linear) == 2);
}

TEST_CASE("what no display can show is clamped and NaN is black") {
    for (const Encoding encoding : {Encoding::Linear, Encoding::Srgb}) {
        CHECK(encode(-1, encoding) == 0);
        CHECK(encode(nan, encoding) == 0);
        CHECK(encode_byte(7, encoding) == 255);
        CHECK(encode_byte(infinity, encoding) == 255);
        CHECK(encode_byte(-infinity, encoding) == 0);
        CHECK(decode(-0.1, encoding) == 0);
        CHECK(decode(1.1, encoding) == 1);
    }
}

TEST_CASE("every byte survives decoding and encoding") {
    for (const Encoding encoding : {Encoding::Linear, Encoding::Srgb})
        for (int b = 0; b < 256; ++b) {
            CAPTURE(b);
            CHECK(encode_byte(decode(b / 255.0, encoding), encoding) == b);
        }
}

TEST_CASE("decoding undoes encoding") {
    // The standard's rounded constants leave its two branches 2.3e-9 apart where they meet.
    test::Random random(1);
    for (int i = 0; i < test::cases(10000); ++i) {
        const Real x = i % 2 ? random.uniform(0, 1) : random.uniform(0.00313, 0.00314);
        CAPTURE(x);
        CHECK(std::abs(decode(encode(x, Encoding::Srgb), Encoding::Srgb) - x) <= 2.4e-9);
    }
}

// ---- PFM ----

/// 2 x 2 pixels; as floats 0.5 = 3F000000, 1 = 3F800000, 2 = 40000000, −1 = BF800000, 0.25 = 3E800000.
Image four_pixels() { return {2, 2, {{1, 0.5, 0}, {0, 0, 2}, {-1, 0, 0}, {0.25, 0.25, 0.25}}}; }

TEST_CASE("a PFM file has a text header and little-endian floats, the bottom row first") {
    const Directory directory;
    write_image(directory / "a.pfm", four_pixels());
    const std::string expected =
        "PF\n2 2\n-1.0\n" + bytes({0, 0, 0x80, 0xBF, 0, 0, 0,    0,    0, 0, 0,    0,     //
                                   0, 0, 0x80, 0x3E, 0, 0, 0x80, 0x3E, 0, 0, 0x80, 0x3E,  //
                                   0, 0, 0x80, 0x3F, 0, 0, 0,    0x3F, 0, 0, 0,    0,     //
                                   0, 0, 0,    0,    0, 0, 0,    0,    0, 0, 0,    0x40});
    CHECK(content_of(directory / "a.pfm") == expected);
    CHECK(read_image(directory / "a.pfm").pixels == four_pixels().pixels);
}

TEST_CASE("a PFM file may be big-endian, grey and scaled") {
    const Directory directory;
    const Image image = read_image(directory.file("a.pfm", "Pf 1 2 2.0\n" + bytes({0x3F, 0, 0, 0,  //
                                                                                   0x3F, 0x80, 0, 0})));
    CHECK(image.width == 1);
    CHECK(image.height == 2);
    CHECK(image.pixels == std::vector<Vec3>{Vec3(2), Vec3(1)});
}

TEST_CASE("PFM keeps every float to the bit, infinities and NaN too") {
    const Directory directory;
    test::Random random(2);
    Image image = make_image(31, 7);
    for (Vec3& p : image.pixels)
        for (int i = 0; i < 3; ++i)
            p[i] = static_cast<Real>(static_cast<float>(random.uniform(-1, 1) * random.magnitude(-40, 38)));
    image.pixels[3] = {infinity, -infinity, 1e300};
    image.pixels[4] = {nan, 0, -1e300};
    write_image(directory / "a.pfm", image);
    Image read = read_image(directory / "a.pfm");
    CHECK(read.pixels[3] == Vec3(infinity, -infinity, infinity));
    CHECK(std::isnan(read.pixels[4].x));
    CHECK(read.pixels[4].z == -infinity);
    image.pixels[3] = read.pixels[3];
    image.pixels[4] = read.pixels[4] = Vec3(0);
    CHECK(read.pixels == image.pixels);
}

// ---- PNG ----

TEST_CASE("an 8-bit PNG keeps the bytes of both encodings") {
    const Directory directory;
    for (const Encoding encoding : {Encoding::Linear, Encoding::Srgb}) {
        Image image = make_image(16, 16);
        for (std::size_t i = 0; i < 256; ++i) {
            const Real b = static_cast<Real>(i);
            image.pixels[i] = {decode(b / 255, encoding), decode((255 - b) / 255, encoding), 0};
        }
        write_image(directory / "a.png", image, encoding);
        const Image read = read_image(directory / "a.png", encoding);
        CHECK(read.width == 16);
        CHECK(read.height == 16);
        CHECK(read.pixels == image.pixels);
    }
}

TEST_CASE("an 8-bit PNG is rounded to the nearest byte") {
    const Directory directory;
    const Image image = random_image(33, 17, 3);
    write_image(directory / "a.png", image);
    const Image read = read_image(directory / "a.png");
    REQUIRE(read.pixels.size() == image.pixels.size());
    for (std::size_t p = 0; p < image.pixels.size(); ++p)
        for (int i = 0; i < 3; ++i)
            REQUIRE(encode_byte(read.pixels[p][i], Encoding::Srgb) ==
                    encode_byte(image.pixels[p][i], Encoding::Srgb));
}

TEST_CASE("8-bit PNGs of every kind are decoded as their encoding says") {
    const Directory directory;
    const Real light = decode(188 / 255.0, Encoding::Srgb);
    const auto read = [&](char depth, PngColour colour, const std::string& row, Encoding encoding,
                          const std::string& palette = "") {
        return read_image(directory.file("a.png", png_file(2, 1, depth, colour, bytes({0}) + row, palette)),
                          encoding)
            .pixels;
    };
    using Pixels = std::vector<Vec3>;
    CHECK(read(8, Rgb, bytes({255, 188, 0, 0, 0, 51}), Encoding::Srgb) ==
          Pixels{{1, light, 0}, {0, 0, decode(0.2, Encoding::Srgb)}});
    CHECK(read(8, Rgb, bytes({255, 188, 0, 0, 0, 51}), Encoding::Linear) ==
          Pixels{{1, 188 / 255.0, 0}, {0, 0, 51 / 255.0}});
    CHECK(read(8, Grey, bytes({188, 255}), Encoding::Srgb) == Pixels{Vec3(light), Vec3(1)});
    CHECK(read(8, GreyAlpha, bytes({188, 0, 255, 77}), Encoding::Srgb) == Pixels{Vec3(light), Vec3(1)});
    CHECK(read(8, Rgba, bytes({188, 0, 255, 0, 0, 255, 0, 128}), Encoding::Srgb) ==
          Pixels{{light, 0, 1}, {0, 1, 0}});
    CHECK(read(1, Grey, bytes({0x40}), Encoding::Srgb) == Pixels{Vec3(0), Vec3(1)});
    CHECK(read(8, Palette, bytes({1, 0}), Encoding::Srgb, bytes({255, 0, 0, 0, 188, 255})) ==
          Pixels{{0, light, 1}, {1, 0, 0}});
}

TEST_CASE("a 16-bit PNG is linear whatever the encoding says") {
    const Directory directory;
    const auto read = [&](PngColour colour, const std::string& row) {
        const fs::path path = directory.file("a.png", png_file(1, 1, 16, colour, bytes({0}) + row));
        const Image srgb = read_image(path, Encoding::Srgb), linear = read_image(path, Encoding::Linear);
        CHECK(srgb.pixels == linear.pixels);
        return srgb.pixels.at(0);
    };
    CHECK(read(Rgb, bytes({0x12, 0x34, 0xFF, 0xFF, 0, 1})) == Vec3(0x1234, 65535, 1) / 65535.0);
    CHECK(read(Grey, bytes({0x80, 0})) == Vec3(0x8000 / 65535.0));
    CHECK(read(GreyAlpha, bytes({0x80, 0, 0, 7})) == Vec3(0x8000 / 65535.0));
    CHECK(read(Rgba, bytes({0, 1, 0, 2, 0, 3, 0, 4})) == Vec3(1, 2, 3) / 65535.0);
}

// ---- HDR ----

const std::string hdr_header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

TEST_CASE("RGBE is three bytes times a power of two") {
    const Directory directory;
    // 128/256 · 2^(129−128) = 1, 64/256 · 2 = 0.5; an exponent byte of 0 is black.
    const Image image = read_image(directory.file(
        "a.hdr", hdr_header + "-Y 1 +X 3\n" + bytes({128, 64, 0, 129, 255, 255, 255, 0, 0, 0, 200, 128})));
    CHECK(image.pixels == std::vector<Vec3>{{1, 0.5, 0}, Vec3(0), {0, 0, 200 / 256.0}});
}

TEST_CASE("rows of an HDR file may be run-length encoded, a channel at a time") {
    const Directory directory;
    const Image image = read_image(directory.file(
        "a.hdr", hdr_header + "-Y 1 +X 8\n" +
                     bytes({2, 2, 0, 8, 128 + 8, 128, 3, 1, 2, 3, 128 + 5, 9, 128 + 8, 0, 128 + 8, 136})));
    REQUIRE(image.pixels.size() == 8);
    CHECK(image.pixels[0] == Vec3(128, 1, 0));
    CHECK(image.pixels[2] == Vec3(128, 3, 0));
    CHECK(image.pixels[3] == Vec3(128, 9, 0));
    CHECK(image.pixels[7] == Vec3(128, 9, 0));
}

TEST_CASE("a run-length count of 128 says that 128 bytes follow") {
    const Directory directory;
    std::string row = bytes({2, 2, 0, 128, 128});
    for (int x = 0; x < 128; ++x) row += static_cast<char>(x);
    row += bytes({128 + 127, 0, 1, 0, 128 + 127, 0, 1, 0, 128 + 127, 136, 1, 136});
    const Image image = read_image(directory.file("a.hdr", hdr_header + "-Y 1 +X 128\n" + row));
    REQUIRE(image.pixels.size() == 128);
    CHECK(image.pixels[127] == Vec3(127, 0, 0));
}

TEST_CASE("HDR keeps light to 1/128 of a pixel's greatest channel") {
    const Directory directory;
    test::Random random(4);
    for (const int width : {3, 40}) {  // plain and run-length encoded rows
        Image image = make_image(width, 5);
        for (Vec3& p : image.pixels) p = (random.in_cube() + Vec3(1)) * random.magnitude(-20, 20);
        for (int x = 0; x < width; ++x) pixel(image, x, 2) = Vec3(0.5, 0.25, 0);
        write_image(directory / "a.hdr", image);
        const Image read = read_image(directory / "a.hdr");
        REQUIRE(read.pixels.size() == image.pixels.size());
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const Vec3 &a = read.pixels[i], &b = image.pixels[i];
            // The greatest mantissa is at least 128, and mantissas are cut to whole numbers.
            const Real step = max_component(b) / 128;
            CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
            REQUIRE(size_of(a - b) <= step);
        }
        CHECK(pixel(read, 1, 2) == Vec3(0.5, 0.25, 0));
    }
}

TEST_CASE("what RGBE cannot hold becomes the nearest that it can") {
    const Directory directory;
    const Real greatest = 255.0 / 256 * 0x1p127;
    write_image(directory / "a.hdr", {3, 1, {{-1, nan, 1}, {infinity, 0, 0}, {1e300, 0, 0}}});
    const Image read = read_image(directory / "a.hdr");
    CHECK(read.pixels == std::vector<Vec3>{{0, 0, 1}, {greatest, 0, 0}, {greatest, 0, 0}});
}

// ---- Damaged files ----

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;  // it reserves terabytes of addresses
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// This process can take no more than `bytes` of memory more while this lives.
struct MemoryLimit {
    rlimit before{};
    explicit MemoryLimit(std::size_t bytes) {
        ::getrlimit(RLIMIT_AS, &before);
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        const rlimit limit{pages * static_cast<std::size_t>(::getpagesize()) + bytes, before.rlim_max};
        if (pages > 0 && !sanitized) ::setrlimit(RLIMIT_AS, &limit);
    }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
    ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &before); }
};

TEST_CASE("a damaged file is named with what is wrong") {
    const Directory directory;
    const std::string good = png_file(1, 1, 8, Rgb, bytes({0, 1, 2, 3}));
    std::string flipped = good;
    flipped[good.find("IDAT") + 12] ^= 1;
    struct Case {
        std::string name, content, error;
    };
    const std::string row = bytes({2, 2, 0, 8});
    const std::string bad_row = "the HDR file is damaged (a row has the wrong length)";
    for (const Case& c : std::vector<Case>{
             {"empty.png", "", "not a PNG file"},
             {"text.png", "hello", "not a PNG file"},
             {"short.png", good.substr(0, good.size() - 1), "the PNG file is cut off"},
             {"flipped.png", flipped, "the PNG file is damaged (a checksum is wrong)"},
             {"few.png", png_file(1, 2, 8, Rgb, bytes({0, 1, 2, 3})),
              "the PNG file is damaged (not enough pixels)"},
             {"depth.png", png_file(1, 1, 7, Rgb, bytes({0, 1, 2, 3})),
              "the PNG file is damaged (invalid bit depth)"},
             {"huge.png", png_file(9000, 9000, 8, Rgb, "x"),
              "an image of 9000 x 9000 pixels; expected at least 1 x 1 and at most 67108864 pixels"},
             {"empty.pfm", "", "not a PFM file"},
             {"ppm.pfm", "P6 1 1 255\n...", "not a PFM file"},
             {"header.pfm", "PF 1 1",
              "a PFM file starts with 'PF' or 'Pf', width, height and a scale that is not 0"},
             {"scale.pfm", "PF 1 1 0\n",
              "a PFM file starts with 'PF' or 'Pf', width, height and a scale that is not 0"},
             {"size.pfm", "PF 0 1 -1\n",
              "an image of 0 x 1 pixels; expected at least 1 x 1 and at most 67108864 pixels"},
             {"negative.pfm", "PF -5 -5 -1\n",
              "an image of -5 x -5 pixels; expected at least 1 x 1 and at most 67108864 pixels"},
             {"huge.pfm", "PF 4000000000 4000000000 -1\n",
              "an image of 4000000000 x 4000000000 pixels; expected at least 1 x 1 and at most 67108864 "
              "pixels"},
             {"short.pfm", "PF 1 1 -1\n12345678901", "the PFM file has 11 bytes of pixels; expected 12"},
             {"long.pfm", "Pf 1 1 -1\n12345", "the PFM file has 5 bytes of pixels; expected 4"},
             {"text.hdr", "hello", "not an HDR file"},
             {"header.hdr", "#?RADIANCE\nFORMAT=", "the HDR file is cut off"},
             {"xyze.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n1234",
              "an HDR file of another kind; expected FORMAT=32-bit_rle_rgbe"},
             {"order.hdr", hdr_header + "+X 1 -Y 1\n1234",
              "an HDR file with an unknown order of pixels; expected -Y height +X width"},
             {"huge.hdr", hdr_header + "-Y 1 +X 70000000\n1234",
              "an image of 70000000 x 1 pixels; expected at least 1 x 1 and at most 67108864 pixels"},
             {"tiny.hdr", hdr_header + "-Y 8000 +X 8000\n1234", "the HDR file is cut off"},
             {"chunk.png", good.substr(0, 33) + png_chunk("\x1b[2J", "") + good.substr(33),
              "the PNG file is damaged (unknown critical chunk)"},
             {"first.png", "\x89PNG\r\n\x1a\n" + png_chunk("CgBI", "1234") + good.substr(8),
              "the PNG file is damaged (it does not begin with IHDR)"},
             {"cut.hdr", hdr_header + "-Y 1 +X 8\n" + row + bytes({128 + 8, 5, 128 + 8}),
              "the HDR file is cut off"},
             {"zero.hdr", hdr_header + "-Y 1 +X 8\n" + row + bytes({0, 0, 0, 0, 0, 0, 0, 0}), bad_row},
             {"run.hdr", hdr_header + "-Y 1 +X 8\n" + row + bytes({128 + 9, 5, 0, 0, 0, 0, 0, 0}), bad_row},
             {"width.hdr", hdr_header + "-Y 1 +X 9\n" + row + "12345678", bad_row},
             {"long.hdr", hdr_header + "-Y 1 +X 1\n12345", "the HDR file goes on after its last pixel"},
         }) {
        const fs::path path = directory.file(c.name, c.content);
        CHECK(read_error(path) == path.string() + ": " + c.error);
    }
}

TEST_CASE("a small file takes no great memory, whatever size it says it has") {
    const Directory directory;
    // Each says that it has 2^26 pixels: 1.6 GB of them.
    for (const fs::path& path :
         {directory.file("wide.hdr", hdr_header + "-Y 1 +X 67108864\n1234"),
          directory.file("runs.hdr", hdr_header + "-Y 4096 +X 16384\n" + std::string(4 * 4096, '\2')),
          directory.file("plain.pfm", "PF 8192 8192 -1\n1234"),
          directory.file("square.png", png_file(8192, 8192, 16, Rgba, "x")),
          directory.file("line.png", png_file(67108864, 1, 8, Grey, "x"))}) {
        CAPTURE(path);
        std::string error;
        {
            const MemoryLimit limit(std::size_t{64} << 20);
            error = error_of([&] {
                try {
                    read_image(path);
                } catch (const std::bad_alloc&) {
                    throw InputError("more memory was taken");
                }
            });
        }
        CHECK(error.starts_with(path.string() + ": "));
    }
}

TEST_CASE("what a PNG file has packed besides its pixels takes no great memory") {
    const Directory directory;
    // 18 MB of zeros, behind the header of one pixel and as a text.
    write_image(directory / "large.png", make_image(3000, 2000));
    const std::string large = content_of(directory / "large.png");
    const std::string header =
        large.substr(0, 8) + png_chunk("IHDR", big_endian(1) + big_endian(1) + large.substr(24, 5));
    const std::size_t data = large.find("IDAT") + 4;
    const std::string text =
        png_chunk("zTXt", std::string("k\0\0", 3) + large.substr(data, large.size() - 16 - data));
    const fs::path pixels = directory.file("pixels.png", header + large.substr(33));
    const fs::path texts = directory.file("texts.png", header + text + large.substr(33));
    Image image;
    std::string error;
    {
        const MemoryLimit limit(std::size_t{40} << 20);
        image = read_image(pixels);
        error = read_error(texts);
    }
    CHECK(image.pixels == std::vector<Vec3>{Vec3(0)});
    CHECK(error == texts.string() + ": the PNG file has more than 16 MiB of texts and colour profiles");
}

TEST_CASE("every PNG that holds as many bytes as its header says is read, interlaced ones too") {
    const Directory directory;
    // A row of three pixels of 2 bits is one byte and its filter's; Adam7 has 1, 0, 0, 1, 0 and 1 pixels in
    // it.
    const std::string plain = png_file(3, 1, 2, Grey, bytes({0, 0b00'01'11'00}));
    std::string header = plain.substr(16, 13), rows = bytes({0, 0b00'000000, 0, 0b11'000000, 0, 0b01'000000});
    header[12] = 1;
    const std::string data = png_file(3, 1, 2, Grey, rows).substr(33);
    const fs::path interlaced =
        directory.file("interlaced.png", plain.substr(0, 8) + png_chunk("IHDR", header) + data);
    const fs::path straight = directory.file("straight.png", plain);
    const Image image = read_image(straight, Encoding::Linear);
    CHECK(image.pixels == std::vector<Vec3>{Vec3(0), Vec3(1 / Real(3)), Vec3(1)});
    CHECK(read_image(interlaced, Encoding::Linear).pixels == image.pixels);
}

TEST_CASE("devices, pipes without a writer and endless files are refused") {
    const Directory directory;
    fs::create_symlink("/dev/zero", directory / "zero.pfm");
    CHECK(read_error(directory / "zero.pfm") ==
          (directory / "zero.pfm").string() + ": cannot be read: it is a device, not a file");
    REQUIRE(::mkfifo((directory / "pipe.png").c_str(), 0600) == 0);
    CHECK(read_error(directory / "pipe.png") ==
          (directory / "pipe.png").string() + ": cannot be read: nobody writes into this pipe");
    directory.file("long.hdr", "");
    fs::resize_file(directory / "long.hdr", largest_file + 1);  // takes no room on the disk
    CHECK(read_error(directory / "long.hdr") ==
          (directory / "long.hdr").string() + ": more than 1073741824 bytes; no larger file is read");
}

TEST_CASE("a picture comes through a pipe") {
    const Directory directory;
    const fs::path pipe = directory / "pipe.pfm";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    write_image(directory / "a.pfm", random_image(200, 100, 4));
    std::thread writer([&] { write_file(pipe, content_of(directory / "a.pfm")); });
    const Image image = read_image(pipe);
    writer.join();
    CHECK(image.pixels == read_image(directory / "a.pfm").pixels);
}

TEST_CASE("no beginning of a picture passes for the picture") {
    const Directory directory;
    for (const std::string name : {"a.png", "a.pfm", "a.hdr"}) {
        write_image(directory / name, random_image(9, 4, 5));
        const std::string whole = content_of(directory / name);
        REQUIRE(read_error(directory / name) == "");
        for (std::size_t size = 0; size < whole.size(); ++size) {
            CAPTURE(name, size);
            const std::string error = read_error(directory.file(name, whole.substr(0, size)));
            REQUIRE(error.starts_with((directory / name).string() + ": "));
        }
    }
}

TEST_CASE("a file with changed bytes is refused or read, and a PNG is always refused") {
    const Directory directory;
    test::Random random(6);
    for (const std::string name : {"a.png", "a.pfm", "a.hdr"}) {
        write_image(directory / name, random_image(9, 4, 7));
        const std::string whole = content_of(directory / name);
        REQUIRE(!whole.empty());
        for (int i = 0; i < test::cases(500); ++i) {
            std::string changed = whole;
            const std::size_t at = random.index(whole.size());
            changed[at] = static_cast<char>(changed[at] ^ static_cast<char>(1 + random.index(255)));
            CAPTURE(name, at, static_cast<int>(changed[at]));
            const std::string error = read_error(directory.file(name, changed));
            if (name == "a.png") REQUIRE(error != "");
            if (error != "") REQUIRE(error.starts_with((directory / name).string() + ": "));
        }
    }
}

TEST_CASE("a place or an ending that is wrong is said in one line") {
    const Directory directory;
    const Image image = make_image(1, 1);
    const auto write_error = [&](const fs::path& path) {
        return error_of([&] { write_image(path, image); });
    };
    const std::string missing = (directory / "no" / "a.png").string(), at = directory.path.string();
    CHECK(read_error(missing) == missing + ": cannot be read: No such file or directory");
    fs::create_directory(directory / "d.png");
    CHECK(read_error(directory / "d.png") == at + "/d.png: cannot be read: Is a directory");
    CHECK(read_error(directory / "a.jpg") ==
          at + "/a.jpg: unknown image format '.jpg'; expected .png, .pfm or .hdr");
    CHECK(write_error(directory / "a.jpg") ==
          at + "/a.jpg: unknown image format '.jpg'; expected .png, .pfm or .hdr");
    CHECK(write_error(directory / "a") == at + "/a: no file ending; expected .png, .pfm or .hdr");
    CHECK(write_error(missing) == missing + ": cannot be written: there is no directory '" + at + "/no'");
    CHECK(write_error(directory / "d.png") == at + "/d.png: cannot be written: Is a directory");
    CHECK(error_of([&] { write_image(directory / "a.png", Image{}); }) ==
          at + "/a.png: an image of 0 x 0 pixels; expected at least 1 x 1 and at most 67108864 pixels");
    directory.file("f", "");
    CHECK(write_error(directory / "f" / "a.png") == at + "/f/a.png: cannot be written: Not a directory");
    CHECK(directory.count() == 2);  // d.png and f: no temporary file stays behind
}

TEST_CASE("endings may be in capitals") {
    const Directory directory;
    write_image(directory / "A.PFM", four_pixels());
    CHECK(read_image(directory / "A.PFM").pixels == four_pixels().pixels);
}

// ---- Whole-file writes ----

TEST_CASE("a written file is there with its content and nothing beside it") {
    const Directory directory;
    const std::string content = bytes({0, 1, 255, '\r', '\n', 0});
    write_file(directory / "a", "before, and longer than after");
    write_file(directory / "a", content);
    write_file(directory / "empty", "");
    CHECK(content_of(directory / "a") == content);
    CHECK(fs::file_size(directory / "empty") == 0);
    CHECK(directory.count() == 2);
}

/// Files of this process cannot grow beyond `bytes` while this lives, as on a full disk.
struct FileSizeLimit {
    rlimit before{};
    explicit FileSizeLimit(rlim_t bytes) {
        ::getrlimit(RLIMIT_FSIZE, &before);
        const rlimit limit{bytes, before.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before); }
};

TEST_CASE("a write that fails halfway leaves the old file and nothing else") {
    const Directory directory;
    write_file(directory / "a", "old");
    std::string error;
    {
        const FileSizeLimit limit(1000);
        error = error_of([&] { write_file(directory / "a", std::string(5000, 'x')); });
    }
    CHECK(error == (directory / "a").string() + ": cannot be written: File too large");
    CHECK(content_of(directory / "a") == "old");
    CHECK(directory.count() == 1);
}

TEST_CASE("a directory without write permission is an error") {
    const Directory directory;
    fs::permissions(directory.path, fs::perms::owner_read | fs::perms::owner_exec);
    const std::string error = error_of([&] { write_file(directory / "a", "x"); });
    fs::permissions(directory.path, fs::perms::owner_all);
    // Permissions do not hold root back.
    CHECK(error ==
          (::geteuid() == 0 ? "" : (directory / "a").string() + ": cannot be written: Permission denied"));
}

TEST_CASE("links and permissions outlive a write") {
    const Directory directory;
    directory.file("script", "old");
    fs::permissions(directory / "script", fs::perms::owner_all);
    fs::create_symlink("script", directory / "link");
    write_file(directory / "link", "new");
    CHECK(fs::is_symlink(directory / "link"));
    CHECK(content_of(directory / "script") == "new");
    CHECK(fs::status(directory / "script").permissions() == fs::perms::owner_all);

    fs::create_symlink("later", directory / "early");  // leads to a file that does not exist yet
    write_file(directory / "early", "new");
    CHECK(content_of(directory / "later") == "new");

    fs::create_symlink("loop", directory / "loop");
    CHECK(error_of([&] { write_file(directory / "loop", "x"); }) ==
          (directory / "loop").string() + ": cannot be written: Too many levels of symbolic links");
    CHECK(directory.count() == 5);
}

TEST_CASE("a pipe is written to, not replaced") {
    const Directory directory;
    const fs::path pipe = directory / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    const int end = ::open(pipe.c_str(), O_RDWR | O_NONBLOCK);  // a reader, so that the writer need not wait
    write_file(pipe, "news");
    std::array<char, 8> received{};
    CHECK(::read(end, received.data(), received.size()) == 4);
    CHECK(std::string(received.data()) == "news");
    ::close(end);
    CHECK(fs::is_fifo(pipe));
    CHECK(directory.count() == 1);
}

TEST_CASE("a file that is read-only is neither written nor replaced") {
    const Directory directory;
    directory.file("a.pfm", "precious");
    fs::permissions(directory / "a.pfm", fs::perms::owner_read | fs::perms::group_read);
    fs::create_symlink("a.pfm", directory / "link.pfm");
    for (const std::string name : {"a.pfm", "link.pfm"}) {
        const std::string expected = (directory / name).string() + ": cannot be written: it is read-only";
        CHECK(error_of([&] { write_file(directory / name, "x"); }) == expected);
        CHECK(error_of([&] { require_writable(directory / name); }) == expected);
    }
    CHECK(content_of(directory / "a.pfm") == "precious");
    CHECK(directory.count() == 2);
}

TEST_CASE("a place that cannot be written is found without writing") {
    const Directory directory;
    directory.file("file", "kept");
    fs::create_directory(directory / "d");
    const auto place_error = [&](const std::string& name) {
        return error_of([&] { require_writable(directory / name); });
    };
    const std::string at = directory.path.string();
    CHECK(place_error("new") == "");
    CHECK(place_error("file") == "");
    CHECK(place_error("d") == at + "/d: cannot be written: Is a directory");
    CHECK(place_error("file/a") == at + "/file/a: cannot be written: Not a directory");
    CHECK(place_error("no/a") == at + "/no/a: cannot be written: there is no directory '" + at + "/no'");
    CHECK(place_error(std::string(300, 'n')).ends_with(": cannot be written: File name too long"));
    CHECK(error_of([] { require_writable("/proc/new"); }).starts_with("/proc/new: cannot be written: "));
    CHECK(error_of([&] { make_directories(directory / "file" / "a"); }) ==
          at + "/file/a: cannot be made a directory: Not a directory");
    CHECK(content_of(directory / "file") == "kept");
    CHECK(directory.count() == 2);
}

TEST_CASE("a file that is read is known by whatever name") {
    const Directory directory;
    const fs::path scene = directory.file("a.scene", "x");
    directory.file("other", "x");
    fs::create_hard_link(scene, directory / "hard");
    fs::create_symlink("hard", directory / "soft");
    for (const std::string name : {"a.scene", "hard", "soft", "./a.scene"})
        CHECK(error_of([&] {
                  require_no_input(directory / name, {directory / "other", scene});
              }) == (directory / name).string() + ": cannot be written: it is '" + scene.string() +
                        "', which is read here");
    for (const std::string name : {"other", "new"})
        CHECK(error_of([&] {
                  require_no_input(directory / name, {scene, "", directory / "missing"});
              }) == "");
}

TEST_CASE("temporary files of killed programs go with the next write, those in use stay") {
    const Directory directory;
    fs::create_directory(directory / "d");  // a directory into which this program has not written yet
    directory.file("d/.course-99-0.tmp", "left");
    directory.file("d/.course-98-3.tmp", "in use");
    directory.file("d/.course-mine.txt", "another's");
    const int user = ::open((directory / "d/.course-98-3.tmp").c_str(), O_WRONLY);
    REQUIRE(::flock(user, LOCK_EX) == 0);
    write_file(directory / "d/a", "x");
    ::close(user);
    CHECK_FALSE(fs::exists(directory / "d/.course-99-0.tmp"));
    CHECK(fs::exists(directory / "d/.course-98-3.tmp"));
    CHECK(fs::exists(directory / "d/.course-mine.txt"));
    CHECK(content_of(directory / "d/a") == "x");
}

TEST_CASE("a signal that ends the program takes its temporary files away") {
    const Directory directory;
    const auto temporary_files = [&] {
        return std::count_if(fs::directory_iterator(directory.path), {},
                             [](const auto& entry) { return entry.path().extension() == ".tmp"; });
    };
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        const pid_t child = ::fork();
        REQUIRE(child >= 0);
        if (child == 0) {
            for (;;) write_file(directory / "a", std::string(1 << 22, 'x'));
        }
        while (temporary_files() == 0) ::usleep(100);
        ::kill(child, signal);
        int status = 0;
        ::waitpid(child, &status, 0);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        CHECK(temporary_files() == 0);
    }
    if (fs::exists(directory / "a")) CHECK(fs::file_size(directory / "a") == 1 << 22);
}

TEST_CASE("of writers at the same time one wins whole") {
    const Directory directory;
    std::vector<std::thread> writers;
    for (const char c : {'a', 'b', 'c', 'd'})
        writers.emplace_back([&directory, c] {
            for (int i = 0; i < 50; ++i) write_file(directory / "a", std::string(20000, c));
        });
    for (std::thread& writer : writers) writer.join();
    const std::string content = content_of(directory / "a");
    CHECK(content == std::string(20000, content.at(0)));
    CHECK(directory.count() == 1);
}

TEST_CASE("16-bit PNG keeps linear light to half a step", "[image]") {
    Image image = make_image(37, 5);
    test::Random random(3);
    for (Vec3& p : image.pixels) p = Vec3(0.5) + random.in_cube() / Real(2);
    image.pixels[0] = {-1, 2, 0.5};
    const std::string path = rt::test::scratch_directory() + "/sixteen.png";
    write_png16(path, image);
    const Image back = read_image(path);
    REQUIRE(back.width == 37);
    REQUIRE(back.height == 5);
    CHECK((back.pixels[0] == Vec3(0, 1, 32768 / Real(65535))));
    for (std::size_t i = 1; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c)
            CHECK(std::abs(back.pixels[i][c] - image.pixels[i][c]) <= 0.5 / 65535 * (1 + 1e-9));
}

}  // namespace
}  // namespace rt
