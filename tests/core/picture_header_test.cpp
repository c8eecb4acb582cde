// SPDX-License-Identifier: MIT
#include "engine/core/picture_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/core/error.h"

namespace sl {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

const std::string png_begin = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x01\x02\0\0\0\x03\x08\x02\0\0\0\0\0\0\0"s;

PictureHeader header(const std::string& bytes) { return picture_header(bytes, "file"); }

std::string fault(const std::string& bytes) {
    try {
        (void)header(bytes);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(PictureHeader, KnowsFormatsByTheirFirstBytes) {
    EXPECT_STREQ(header(png_begin).format, "png");
    EXPECT_STREQ(header("\xff\xd8\xff").format, "jpeg");
    EXPECT_STREQ(header("RIFF\x04\0\0\0WEBP"s).format, "webp");
    EXPECT_STREQ(header("\x76\x2f\x31\x01\x02\0\0\0"s).format, "openexr");
    for (const std::string& bytes : {""s, "\x89"s, "RIFF"s, "GIF89a"s}) EXPECT_EQ(header(bytes).format, nullptr);
}

TEST(PictureHeader, TellsTheSize) {
    EXPECT_EQ(header(png_begin).size, uvec2(258, 3));
    // A comment, tables that look like a frame, and then the frame.
    EXPECT_EQ(header("\xff\xd8\xff\xfe\0\x04\xff\xc0\xff\xc4\0\x02\xff\xc2\0\x0b\x08\x01\x00\x02\x03"s).size, uvec2(515, 256));
    EXPECT_EQ(header("RIFF\0\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\x01\0\x02\0\0"s).size, uvec2(512, 3));
    EXPECT_EQ(header("RIFF\0\0\0\0WEBPVP8L\0\0\0\0\x2f\x08\x00\x01\x00"s).size, uvec2(9, 5));
    EXPECT_EQ(header("RIFF\0\0\0\0WEBPVP8 \0\0\0\0\0\0\0\x9d\x01\x2a\x09\0\x05\0"s).size, uvec2(9, 5));
    EXPECT_EQ(header("\xff\xd8\xff\xc0\0"s).size, uvec2(0));
}

TEST(PictureHeader, PartsThatClaimMoreThanThereIsAreRefused) {
    EXPECT_THAT(fault(png_begin + "\x61\x0b\x05\x09tEXtComment"), HasSubstr("file: it is cut or damaged: a part at byte 33 has 1628112137 bytes, and 7 are left"));
    EXPECT_EQ(fault(png_begin + "\0\0\0\x07tEXtComment"s), "");
    EXPECT_EQ(fault(png_begin + "\0\0\0\0IEND\0\0\0\0 and whatever a camera adds"s), "");
}

}  // namespace
}  // namespace sl
