// SPDX-License-Identifier: MIT
#include "engine/render/gl/program.h"

#include "tests/render/gl/compute_fixture.h"

namespace sl::gl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Key;
using testing::Pair;

class ProgramTest : public GlTest {
  protected:
    TempFolder folder;
};
SL_ON_BOTH_CONTEXTS(ProgramTest);

constexpr const char* vertex = R"(layout(std140) uniform Camera { mat4 clip_from_world; } camera;
layout(std430) readonly buffer Vertices { vec4 position_ws[]; };
uniform vec3 offset;
out vec2 uv;
void main() {
    uv = position_ws[gl_VertexID].xy;
    gl_Position = camera.clip_from_world * vec4(position_ws[gl_VertexID].xyz + offset, 1.0);
}
)";

constexpr const char* fragment = R"(in vec2 uv;
struct Light { vec4 colour; };
layout(std140) uniform Albedo { vec4 tint; };
uniform sampler2D normal_map;
uniform sampler2DArrayShadow cascades;
uniform usampler2D ids;
uniform sampler2D albedo_map[3];
uniform float weights[4];
uniform Light light;
uniform float unused;
layout(location = 2) out vec4 colour;
layout(location = 0) out uvec2 id;
void main() {
    colour = tint * light.colour * weights[int(uv.x)] * texture(normal_map, uv);
    colour += texture(albedo_map[0], uv) + texture(albedo_map[1], uv) + texture(albedo_map[2], uv);
    colour *= texture(cascades, vec4(uv, 0.0, 0.5));
    id = texture(ids, uv).xy;
    gl_FragDepth = 0.5;
}
)";

TEST_P(ProgramTest, TellsWhatTheShaderNeeds) {
    folder.write("pass.vert", vertex);
    folder.write("pass.frag", fragment);
    ProgramCache cache(folder.path());
    const Program& program = cache.get({"pass.vert", "pass.frag", "", {}});
    EXPECT_THAT(program.samplers(), ElementsAre(Pair("albedo_map", 0u), Pair("cascades", 3u), Pair("ids", 4u),
                                                Pair("normal_map", 5u)));
    EXPECT_THAT(program.uniform_blocks(), ElementsAre(Pair("Albedo", 0u), Pair("Camera", 1u)));
    EXPECT_THAT(program.storage_blocks(), ElementsAre(Pair("Vertices", 0u)));
    EXPECT_THAT(program.uniforms(), ElementsAre(Key("light.colour"), Key("offset"), Key("weights")));
    EXPECT_THAT(program.outputs(), ElementsAre(Pair("colour", 2), Pair("id", 0)));
    EXPECT_THAT(program.images(), IsEmpty());

    GLint unit = -1;
    glGetUniformiv(program.id(), glGetUniformLocation(program.id(), "albedo_map[2]"), &unit);
    EXPECT_EQ(unit, 2);
    glGetUniformiv(program.id(), glGetUniformLocation(program.id(), "normal_map"), &unit);
    EXPECT_EQ(unit, 5);
    const GLenum what = GL_BUFFER_BINDING;
    GLint binding = -1;
    glGetProgramResourceiv(program.id(), GL_UNIFORM_BLOCK,
                           glGetProgramResourceIndex(program.id(), GL_UNIFORM_BLOCK, "Camera"), 1, &what, 1,
                           nullptr, &binding);
    EXPECT_EQ(binding, 1);
}

TEST_P(ProgramTest, VertexAloneHasNoOutputs) {
    folder.write("depth.vert", vertex);
    ProgramCache cache(folder.path());
    EXPECT_THAT(cache.get({"depth.vert", "", "", {}}).outputs(), IsEmpty());
}

TEST_P(ProgramTest, ImagesAndBuffersOfComputeWorkByName) {
    folder.write("pass.comp", R"(layout(local_size_x = 1) in;
layout(r32f) uniform image2D zebra;
layout(rgba16f) uniform writeonly image2DArray ape;
layout(r32ui) uniform uimage2D counts;
layout(std430) buffer B { float b; };
layout(std430) buffer A { float a; };
void main() {
    imageStore(zebra, ivec2(0), vec4(3.0));
    imageStore(ape, ivec3(0), vec4(1.0));
    imageAtomicAdd(counts, ivec2(0), 1u);
    b = a;
}
)");
    ProgramCache cache(folder.path());
    const Program& program = cache.get({"", "", "pass.comp", {}});
    EXPECT_THAT(program.images(), ElementsAre(Pair("ape", 0u), Pair("counts", 1u), Pair("zebra", 2u)));
    EXPECT_THAT(program.storage_blocks(), ElementsAre(Pair("A", 0u), Pair("B", 1u)));
    EXPECT_THAT(program.outputs(), IsEmpty());
}

TEST_P(ProgramTest, BlocksAreBoundWhereTheProgramSays) {
    Buffer constants;
    constants.upload(std::vector<float>{1.0f, 2.0f, 3.0f, 4.0f});
    Buffer input;
    input.upload(std::vector<float>{10.0f});
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, constants.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, input.id());  // "Input" comes before "Result"
    EXPECT_THAT(compute(folder,
                        "layout(std140) uniform Constants { vec4 numbers; };\n"
                        "layout(std430) readonly buffer Input { float first; };",
                        "result[0] = numbers.z + first;", 1),
                ElementsAre(13.0f));
}

TEST_P(ProgramTest, DefinesMakeAnotherProgram) {
    folder.write("pass.comp", R"(layout(local_size_x = 1) in;
#ifdef WITH_B
layout(std430) buffer B { float b; };
void main() { b = SCALE; }
#else
layout(std430) buffer A { float a; };
void main() { a = 1.0; }
#endif
)");
    ProgramCache cache(folder.path());
    const Program& without = cache.get({"", "", "pass.comp", {}});
    const Program& with = cache.get({"", "", "pass.comp", {{"WITH_B", ""}, {"SCALE", "2.0"}}});
    EXPECT_THAT(without.storage_blocks(), ElementsAre(Key("A")));
    EXPECT_THAT(with.storage_blocks(), ElementsAre(Key("B")));
    EXPECT_EQ(&cache.get({"", "", "pass.comp", {}}), &without);
}

}  // namespace
}  // namespace sl::gl
