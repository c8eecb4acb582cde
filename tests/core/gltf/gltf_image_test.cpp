// SPDX-License-Identifier: MIT
#include "tests/core/gltf/gltf_fixture.h"

namespace sl {
namespace {

using namespace std::string_literals;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string png = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x05\0\0\0\x03\x08\x02\0\0\0\x12\x34\x56\x78"s;
const std::string webp = "RIFF\x10\0\0\0WEBPVP8L\x04\0\0\0\0\0\0\0"s;

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
    EXPECT_THAT(with(png.substr(0, 20), R"("mimeType": "image/png")"), IsOnly("note /images/0", "the picture ends within its header"));
    EXPECT_THAT(with("\x76\x2f\x31\x01 of an EXR", R"("mimeType": "image/png")"), IsEmpty());
    EXPECT_THAT(faults_with(R"("images": [{"uri": "none.png"}])"), IsOnly("note /images/0/uri", "there is no such file"));
    EXPECT_THAT(faults_with(R"("images": [{"uri": "data:image/gif;base64,AAAA"}])"), Contains(HasSubstr("'image/gif'")));
}

TEST(GltfImage, PicturesAreTheSameBytesOrShareNone) {
    const auto with = [](std::string_view views) {
        return faults_with(fmt::format(R"("buffers": [{{"byteLength": 99, "uri": "b"}}], "bufferViews": [{}],
            "images": [{{"bufferView": 0, "mimeType": "image/png"}}, {{"bufferView": 1, "mimeType": "image/png"}}])", views), {{"b", png + png + png}});
    };
    EXPECT_THAT(with(R"({"buffer": 0, "byteLength": 33}, {"buffer": 0, "byteOffset": 33, "byteLength": 33})"), IsEmpty());
    EXPECT_THAT(with(R"({"buffer": 0, "byteLength": 33}, {"buffer": 0, "byteLength": 33})"), IsEmpty());
    EXPECT_THAT(with(R"({"buffer": 0, "byteLength": 33}, {"buffer": 0, "byteLength": 34})"), IsOnly("note /images/0", "shares a part of its bytes with image 1, and is left out"));
}

}  // namespace
}  // namespace sl
