// SPDX-License-Identifier: MIT
#include "engine/core/picture_header.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sl {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

const std::string png_begin = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x01\x02\0\0\0\x03\x08\x02\0\0\0\0\0\0\0"s;

const std::string jpeg = "\xff\xd8\xff\xe0\0\x04\0\0\xff\xc0\0\x0b\x08\0\x02\0\x07\x01\0\0\0"s;
const std::string webp = "RIFF\x10\0\0\0WEBPVP8L\x04\0\0\0\0\0\0\0"s;

std::string fault(const std::string& bytes) { return picture_header(bytes).fault; }
uvec2 size(const std::string& bytes) { return picture_header(bytes).size; }
PictureCoding coding(const std::string& bytes) { return picture_header(bytes).coding; }

TEST(PictureHeader, KnowsFormatsByTheirFirstBytes) {
    EXPECT_EQ(coding(png_begin), PictureCoding::png);
    EXPECT_EQ(coding(jpeg), PictureCoding::jpeg);
    EXPECT_EQ(coding(webp), PictureCoding::webp);
    EXPECT_EQ(coding("\x76\x2f\x31\x01\x02\0\0\0"s), PictureCoding::openexr);
    EXPECT_EQ(coding("\xabKTX 20\xbb\r\n\x1a\n"), PictureCoding::ktx2);
    EXPECT_EQ(picture_coding_name(PictureCoding::openexr), "openexr");
    EXPECT_EQ(picture_coding_name(PictureCoding::unknown), "");
    for (const std::string& bytes : {""s, "\x89"s, "RIFF"s, "GIF89a"s, "RIFF\x10\0\0\0WAVEfmt \x04\0\0\0\0\0\0\0"s}) EXPECT_EQ(coding(bytes), PictureCoding::unknown);
}

TEST(PictureHeader, TellsTheSize) {
    EXPECT_EQ(size(png_begin), uvec2(258, 3));
    // A comment, tables that look like a frame, and then the frame.
    EXPECT_EQ(size("\xff\xd8\xff\xfe\0\x04\xff\xc0\xff\xc4\0\x02\xff\xc2\0\x0b\x08\x01\x00\x02\x03"s), uvec2(515, 256));
    EXPECT_EQ(size("RIFF\0\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0\xff\x01\0\x02\0\0"s), uvec2(512, 3));
    EXPECT_EQ(size("RIFF\0\0\0\0WEBPVP8L\0\0\0\0\x2f\x08\x00\x01\x00"s), uvec2(9, 5));
    EXPECT_EQ(size("RIFF\0\0\0\0WEBPVP8 \0\0\0\0\0\0\0\x9d\x01\x2a\x09\0\x05\0"s), uvec2(9, 5));
    EXPECT_EQ(size("\xff\xd8\xff\xc0\0"s), uvec2(0));
}

TEST(PictureHeader, PartsThatClaimMoreThanThereIsAreRefused) {
    EXPECT_THAT(fault(png_begin + "\x61\x0b\x05\x09tEXtComment"), HasSubstr("is cut or damaged: a part at byte 33 has 1628112137 bytes, and 7 are left"));
    EXPECT_EQ(fault(png_begin + "\0\0\0\x07tEXtComment"s), "");
    EXPECT_EQ(fault(png_begin + "\0\0\0\0IEND\0\0\0\0 and whatever a camera adds"s), "");
}

TEST(PictureHeader, AJpegOfTooManyScansIsNotDecoded) {
    const auto with = [](std::size_t scans) {
        std::string bytes = jpeg;
        for (std::size_t i = 0; i < scans; ++i) bytes += "\xff\xda\0\x02 pixels \xff\0\xda"s;
        return bytes + "\xff\xd9 what follows is none: \xff\xda";
    };
    EXPECT_EQ(fault(with(64)), "");
    EXPECT_EQ(fault(with(65)), "has 65 scans; 64 are the limit");
}

TEST(PictureHeader, EveryBeginningHasAFault) {
    const std::string png = png_begin;
    for (const std::string& whole : {png, jpeg, webp}) {
        EXPECT_EQ(fault(whole), "");
        for (std::size_t count = 0; count < whole.size(); ++count) {
            const bool has_frame = whole == jpeg && count >= 17;
            EXPECT_TRUE(coding(whole.substr(0, count)) == PictureCoding::unknown || has_frame || !fault(whole.substr(0, count)).empty()) << count;
        }
    }
}

TEST(PictureHeader, WhatCannotBeDecodedIsSaid) {
    std::string other = png_begin, flat = png_begin;
    other[12] = 'X';
    EXPECT_EQ(fault(other), "does not begin with the chunk IHDR");
    flat[18] = flat[19] = 0;
    EXPECT_EQ(fault(flat), "has no pixels");
    EXPECT_EQ(fault("\xff\xd8\xff"s + std::string(20, '\0')), "is no JPEG after its first bytes");
    EXPECT_EQ(fault("RIFF\x10\0\0\0WEBPOTHR\x04\0\0\0\0\0\0\0"s), "holds no picture that WebP knows");
    EXPECT_EQ(fault("RIFF\x11\0\0\0WEBPVP8L\x04\0\0\0\0\0\0\0"s), "is shorter than its header says");
}

}  // namespace
}  // namespace sl
