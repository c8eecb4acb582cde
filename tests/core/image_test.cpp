// SPDX-License-Identifier: MIT
#include "engine/core/image.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <map>

#include "tests/core/image_fixture.h"

namespace sl {
namespace {

using testing::ElementsAre;

TEST_F(ImageTest, ExrKeepsEveryFloat) {
    Image image = counting(7, 5, 3, -20.5f);
    image.data[0] = 1e30f;
    image.data[1] = std::numeric_limits<float>::infinity();
    image.data[2] = std::numeric_limits<float>::denorm_min();
    image.data[3] = std::numeric_limits<float>::quiet_NaN();
    write_exr(folder / "a.exr", {{"", image}});
    const auto layers = read_exr(folder / "a.exr");
    ASSERT_EQ(layers.size(), 1u);
    EXPECT_EQ(layers[0].name, "");
    EXPECT_EQ(layers[0].image.width, 7u);
    EXPECT_EQ(layers[0].image.height, 5u);
    EXPECT_EQ(layers[0].image.channels, 3u);
    EXPECT_TRUE(std::isnan(layers[0].image.data[3]));
    image.data[3] = 0.0f;
    auto read = layers[0].image.data;
    read[3] = 0.0f;
    EXPECT_EQ(read, image.data);
}

TEST_F(ImageTest, ExrKeepsLayersTheirOrderAndChannels) {
    const std::vector<ImageLayer> written = {{"zebra", counting(4, 3, 3, 0.0f)},
                                             {"", counting(4, 3, 4, 100.0f)},
                                             {"depth", counting(4, 3, 1, 200.0f)},
                                             {"gi.moments", counting(4, 3, 2, 300.0f)},
                                             {"ape", counting(4, 3, 3, 400.0f)}};
    write_exr(folder / "a.exr", written);
    const auto read = read_exr(folder / "a.exr");
    ASSERT_EQ(read.size(), written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].name, written[i].name);
        EXPECT_EQ(read[i].image.channels, written[i].image.channels);
        EXPECT_EQ(read[i].image.data, written[i].image.data) << written[i].name;
    }
}

TEST_F(ImageTest, ExrNamesChannelsAsOtherProgramsDo) {
    write_exr(folder / "a.exr", {{"", counting(1, 1, 3, 0.0f)},
                                 {"depth", counting(1, 1, 1, 0.0f)},
                                 {"motion", counting(1, 1, 2, 0.0f)}});
    const auto input = OIIO::ImageInput::open((folder / "a.exr").string());
    ASSERT_TRUE(input);
    EXPECT_THAT(input->spec().channelnames,
                testing::UnorderedElementsAre("R", "G", "B", "depth.Y", "motion.R", "motion.G"));
    EXPECT_EQ(input->spec().format, OIIO::TypeDesc::FLOAT);
    EXPECT_EQ(input->spec().get_string_attribute("compression"), "zip");
}

TEST_F(ImageTest, ExrOfOthersIsGroupedByName) {
    OIIO::ImageSpec spec(2, 1, 5, OIIO::TypeDesc::HALF);
    spec.channelnames = {"b.B", "Z", "b.R", "b.G", "a.x"};
    const std::vector<float> pixels = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    const auto output = OIIO::ImageOutput::create("exr");
    ASSERT_TRUE(output->open((folder / "a.exr").string(), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
    ASSERT_TRUE(output->close());
    std::map<std::string, std::vector<float>> read;
    for (const ImageLayer& layer : read_exr(folder / "a.exr")) read[layer.name] = layer.image.data;
    EXPECT_THAT(read[""], ElementsAre(2, 7));
    EXPECT_THAT(read["b"], ElementsAre(3, 4, 1, 8, 9, 6));
    EXPECT_THAT(read["a"], ElementsAre(5, 10));
}

TEST_F(ImageTest, EqualPicturesAreEqualFiles) {
    const Image image = counting(64, 64, 4, 0.0f);
    for (const char* name : {"a", "b"}) {
        write_exr(folder / (std::string(name) + ".exr"), {{"", image}, {"x", image}});
        write_png(folder / (std::string(name) + ".png"), image);
        ::usleep(1100000);  // file formats note seconds
    }
    EXPECT_TRUE(bytes_of(folder / "a.exr") == bytes_of(folder / "b.exr"));
    EXPECT_TRUE(bytes_of(folder / "a.png") == bytes_of(folder / "b.png"));
    for (const char* word : {"OpenImageIO", "Software", "tIME", "DateTime"}) {
        EXPECT_EQ(bytes_of(folder / "a.exr").find(word), std::string::npos) << word;
        EXPECT_EQ(bytes_of(folder / "a.png").find(word), std::string::npos) << word;
    }
}

TEST_F(ImageTest, PngRoundsAndClamps) {
    Image image(8, 1, 1);
    image.data = {-1.0f, 0.0f, 0.4f / 255.0f, 0.6f / 255.0f,
                  0.5f,  1.0f, 7.0f,          std::numeric_limits<float>::quiet_NaN()};
    write_png(folder / "a.png", image);
    const Image read = read_png(folder / "a.png");
    EXPECT_EQ(read.channels, 1u);
    std::vector<int> bytes;
    for (float value : read.data) bytes.push_back(static_cast<int>(std::lround(value * 255.0f)));
    EXPECT_THAT(bytes, ElementsAre(0, 0, 0, 1, 128, 255, 255, 0));
}

TEST_F(ImageTest, PngKeepsAllBytesOfAllChannelCounts) {
    for (std::uint32_t channels = 1; channels <= 4; ++channels) {
        Image image(16, 16, channels);
        for (std::size_t i = 0; i < image.data.size(); ++i)
            image.data[i] = static_cast<float>(i * 37 % 256) / 255.0f;
        write_png(folder / "a.png", image);
        const Image read = read_png(folder / "a.png");
        ASSERT_EQ(read.channels, channels);
        for (std::size_t i = 0; i < image.data.size(); ++i) ASSERT_NEAR(read.data[i], image.data[i], 1e-6f);
    }
}

TEST_F(ImageTest, WritingReplacesAndLeavesNothingElse) {
    write_png(folder / "a.png", Image(4, 4, 3));
    write_png(folder / "a.png", Image(2, 2, 3));
    EXPECT_EQ(read_png(folder / "a.png").width, 2u);
    EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(ImageTest, SideBySide) {
    const Image joined = side_by_side({counting(2, 2, 1, 10.0f), counting(1, 2, 1, 20.0f)}, 1);
    EXPECT_EQ(joined.width, 4u);
    EXPECT_THAT(joined.data, ElementsAre(10, 11, 1, 20, 12, 13, 1, 21));
    EXPECT_EQ(side_by_side({counting(2, 2, 3, 0.0f)}, 5).width, 2u);
}

}  // namespace
}  // namespace sl
