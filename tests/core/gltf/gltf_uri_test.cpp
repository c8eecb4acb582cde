// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_uri.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

std::string data_of(std::string_view text) {
    const GltfUri uri = read_gltf_uri(text);
    if (uri.kind != GltfUri::Kind::data) return "none";
    return {reinterpret_cast<const char*>(uri.data.data()), uri.data.size()};
}

TEST(GltfUri, Data) {
    EXPECT_EQ(data_of("data:application/octet-stream;base64,QUJD"), "ABC");
    EXPECT_EQ(data_of("data:application/octet-stream;base64,QUI="), "AB");
    EXPECT_EQ(data_of("data:application/octet-stream;base64,QQ=="), "A");
    EXPECT_EQ(data_of("data:application/octet-stream;base64,QQ%3D%3D"), "A");
    EXPECT_EQ(data_of("DATA:text/plain;charset=utf-8;BASE64,"), "");
    EXPECT_EQ(data_of("data:application/gltf-buffer,0%201"), "0 1");
    EXPECT_EQ(data_of("data:,x"), "x");
    EXPECT_EQ(read_gltf_uri("data:Image/PNG,x").media_type, "image/png");
    for (const char* wrong : {"data:", "data:text/plain", "data:text/plain;base64", "data:a/b;;base64,AA==", "data:a/b;x;base64,AA==",
                              "data:a/b;base64,A", "data:a/b;base64,A===", "data:a/b;base64,`AAA", "data:a/b;base64,=AAA",
                              "data:a/b,%", "data:a/b,%zz", "data:ab,x"}) {
        EXPECT_EQ(read_gltf_uri(wrong).kind, GltfUri::Kind::invalid) << wrong;
    }
}

TEST(GltfUri, Paths) {
    EXPECT_EQ(read_gltf_uri("a/b%20c.bin?x#y").path, "a/b c.bin");
    EXPECT_EQ(read_gltf_uri("a/b:c").kind, GltfUri::Kind::relative);
    EXPECT_EQ(read_gltf_uri("../a.bin").path, "../a.bin");
    for (const char* absolute : {"http://x/a.bin", "file:a.bin", "C:\\a.bin", "/etc/passwd", "//x/a.bin"}) {
        EXPECT_EQ(read_gltf_uri(absolute).kind, GltfUri::Kind::absolute) << absolute;
    }
    for (const char* wrong : {"", ":", ":a", "1a:b", "%", "a%2", "a%00b", "a\nb", "?x", "a b:c"}) {
        EXPECT_EQ(read_gltf_uri(wrong).kind, GltfUri::Kind::invalid) << wrong;
    }
}

}  // namespace
}  // namespace sl
