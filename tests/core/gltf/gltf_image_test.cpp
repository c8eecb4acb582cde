// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_image_header.h"

#include "tests/core/gltf/gltf_fixture.h"

namespace sl {
namespace {

using namespace std::string_literals;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string png = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x05\0\0\0\x03\x08\x02\0\0\0\x12\x34\x56\x78"s;
const std::string jpeg = "\xff\xd8\xff\xe0\0\x04\0\0\xff\xc0\0\x0b\x08\0\x02\0\x07\x01\0\0\0"s;
const std::string webp = "RIFF\x10\0\0\0WEBPVP8L\x04\0\0\0\0\0\0\0"s;

GltfImageHeader header_of(const std::string& text) {
    return read_gltf_image_header(bytes_of(text));
}

TEST(GltfImage, Headers) {
    const GltfImageHeader of_png = header_of(png);
    EXPECT_EQ(of_png.kind, GltfImageKind::png);
    EXPECT_EQ(of_png.width, 5u);
    EXPECT_EQ(of_png.height, 3u);
    EXPECT_EQ(of_png.fault, "");
    const GltfImageHeader of_jpeg = header_of(jpeg);
    EXPECT_EQ(of_jpeg.kind, GltfImageKind::jpeg);
    EXPECT_EQ(of_jpeg.width, 7u);
    EXPECT_EQ(of_jpeg.height, 2u);
    EXPECT_EQ(of_jpeg.fault, "");
    EXPECT_EQ(header_of(webp).kind, GltfImageKind::webp);
    EXPECT_EQ(header_of(webp).fault, "");
    EXPECT_EQ(header_of("GIF89a").kind, GltfImageKind::unknown);
    EXPECT_EQ(header_of("RIFF\x10\0\0\0WAVEfmt \x04\0\0\0\0\0\0\0"s).kind, GltfImageKind::unknown);
}

TEST(GltfImage, EveryBeginningIsTold) {
    for (const std::string& whole : {png, jpeg, webp}) {
        for (std::size_t size = 0; size < whole.size(); ++size) {
            const GltfImageHeader header = header_of(whole.substr(0, size));
            const bool is_whole_frame = whole == jpeg && size >= 17;
            EXPECT_TRUE(header.kind == GltfImageKind::unknown || !header.fault.empty() || is_whole_frame) << size;
        }
    }
}

TEST(GltfImage, BrokenHeaders) {
    std::string other = png;
    other[12] = 'X';
    EXPECT_THAT(header_of(other).fault, HasSubstr("IHDR"));
    std::string flat = png;
    flat[19] = 0;
    EXPECT_EQ(header_of(flat).fault, "has no pixels");
    EXPECT_EQ(header_of("\xff\xd8\xff"s + std::string(20, '\0')).fault, "is no JPEG after its first bytes");
}

TEST(GltfImage, AgainstTheDocument) {
    const auto with = [](const std::string& bytes, std::string_view image, std::string_view more = "") {
        return faults_with(fmt::format(R"("images": [{{"uri": "a", {}}}]{})", image, more), {{"a", bytes}});
    };
    EXPECT_THAT(with(png, R"("mimeType": "image/png")"), IsEmpty());
    EXPECT_THAT(with(png, R"("mimeType": "image/jpeg")"), IsOnly("note /images/0/mimeType", "is 'image/jpeg'; the picture is image/png"));
    EXPECT_THAT(with("anything", R"("mimeType": "image/jpeg")"), IsEmpty());
    EXPECT_THAT(with(webp, R"("mimeType": "image/webp")"), IsOnly("note /images/0", "needs EXT_texture_webp"));
    const std::string extension = R"(, "extensionsUsed": ["EXT_texture_webp"], "textures": [)";
    EXPECT_THAT(with(webp, R"("mimeType": "image/webp")", extension + R"({"extensions": {"EXT_texture_webp": {"source": 0}}}])"), IsEmpty());
    EXPECT_THAT(with(webp, R"("mimeType": "image/webp")", extension + R"({"source": 0}])"), IsOnly("note /textures/0/source", "must be image/png or image/jpeg"));
    EXPECT_THAT(with(png, R"("mimeType": "image/png")", extension + R"({"extensions": {"EXT_texture_webp": {"source": 0}}}])"),
                IsOnly("note /textures/0/extensions/EXT_texture_webp/source", "must be image/webp"));
    EXPECT_THAT(faults_with(R"("images": [{"uri": "none.png"}])"), IsOnly("note /images/0/uri", "there is no such file"));
    EXPECT_THAT(faults_with(R"("images": [{"uri": "data:image/gif;base64,AAAA"}])"), Contains(HasSubstr("'image/gif'")));
}

}  // namespace
}  // namespace sl
