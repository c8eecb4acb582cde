// SPDX-License-Identifier: MIT
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "tests/core/image_fixture.h"

namespace sl {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ImageFailuresTest : public ImageTest {};

TEST_F(ImageFailuresTest, FailuresToWriteNameTheFileAndKeepTheOldOne) {
    const Image image(2, 2, 3);
    EXPECT_THAT(error_of([&] { write_png(folder / "none" / "a.png", image); }),
                HasSubstr("none/a.png: cannot be written: there is no folder"));
    EXPECT_THAT(error_of([&] {
                    write_exr(folder / "none" / "a.exr", {{"", image}});
                }),
                HasSubstr("none/a.exr: cannot be written: there is no folder"));
    fs::create_directory(folder / "taken.png");
    EXPECT_THAT(error_of([&] { write_png(folder / "taken.png", image); }), HasSubstr("taken.png: "));
    EXPECT_EQ(files_in_folder(), 1u);
    const std::string long_name(300, 'x');
    EXPECT_THAT(error_of([&] { write_png(folder / long_name, image); }), HasSubstr(long_name));
}

TEST_F(ImageFailuresTest, ForbiddenFolderIsAnError) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    ::chmod(folder.c_str(), 0500);
    EXPECT_THAT(error_of([&] { write_png(folder / "a.png", Image(2, 2, 3)); }),
                HasSubstr("a.png: cannot be written"));
    ::chmod(folder.c_str(), 0700);
}

TEST_F(ImageFailuresTest, FullDiskIsAnErrorAndKeepsTheOldFile) {
    const Image small(1, 1, 3);
    write_png(folder / "a.png", small);
    write_exr(folder / "a.exr", {{"", small}});
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit tight{100, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &tight);
    const Image image = counting(40, 40, 3, 0.0f);
    const std::string png = error_of([&] { write_png(folder / "a.png", image); });
    const std::string exr = error_of([&] { write_exr(folder / "a.exr", {{"", image}}); });
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_DFL);
    EXPECT_THAT(png, HasSubstr("a.png: cannot be written: "));
    EXPECT_THAT(exr, HasSubstr("a.exr: cannot be written: "));
    EXPECT_EQ(read_png(folder / "a.png").width, 1u);
    EXPECT_EQ(read_exr(folder / "a.exr")[0].image.width, 1u);
    EXPECT_EQ(files_in_folder(), 2u);
}

TEST_F(ImageFailuresTest, FailuresToReadNameTheFile) {
    EXPECT_THAT(error_of([&] { read_exr(folder / "none.exr"); }),
                HasSubstr("none.exr: cannot be read: there is no such file"));
    EXPECT_THAT(error_of([&] { read_png(folder); }), HasSubstr("there is no such file"));
    std::ofstream(folder / "text.exr") << "not a picture";
    EXPECT_THAT(error_of([&] { read_exr(folder / "text.exr"); }), HasSubstr("text.exr: "));
    std::ofstream(folder / "empty.exr") << "";
    EXPECT_THAT(error_of([&] { read_exr(folder / "empty.exr"); }), HasSubstr("empty.exr: "));
    write_png(folder / "a.png", Image(2, 2, 3));
    EXPECT_THAT(error_of([&] { read_exr(folder / "a.png"); }), HasSubstr("a.png: it is not an EXR"));
    write_exr(folder / "a.exr", {{"", Image(2, 2, 3)}});
    EXPECT_THAT(error_of([&] { read_png(folder / "a.exr"); }),
                HasSubstr("a.exr: it is not a PNG"));
}

TEST_F(ImageFailuresTest, CutFilesAreErrorsAtEveryLength) {
    write_exr(folder / "whole.exr", {{"", counting(40, 40, 3, 0.0f)}});
    const std::string whole = bytes_of(folder / "whole.exr");
    for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 60) {
        std::ofstream(folder / "cut.exr", std::ios::binary) << whole.substr(0, length);
        EXPECT_THAT(error_of([&] { read_exr(folder / "cut.exr"); }), HasSubstr("cut.exr")) << length;
    }
}

TEST_F(ImageFailuresTest, AbsurdSizesAreRefused) {
    write_exr(folder / "a.exr", {{"", Image(2, 2, 3)}});
    std::string bytes = bytes_of(folder / "a.exr");
    for (const char* window : {"dataWindow", "displayWindow"}) {
        // name, type "box2i", size, then x0, y0, x1, y1.
        const std::size_t box = bytes.find(window) + std::string_view(window).size() + 1 + 6 + 4;
        const std::int32_t edge = 99999;
        for (std::size_t corner : {8u, 12u}) {
            bytes.replace(box + corner, 4, reinterpret_cast<const char*>(&edge), 4);
        }
    }
    std::ofstream(folder / "big.exr", std::ios::binary) << bytes;
    EXPECT_THAT(error_of([&] { read_exr(folder / "big.exr"); }), HasSubstr("big.exr: "));
}

}  // namespace
}  // namespace sl
