// SPDX-License-Identifier: MIT
// Every struct that C++ and GLSL share: the offset of each member as GL lays it out, in a uniform block (std140) and in a
// storage block (std430), must be the offset that C++ gives it; and no member may be missing from the list.
#include <unistd.h>

#include <fstream>
#include <map>

#include "shared/exposure.h"
#include "shared/facets.h"
#include "shared/frame.h"
#include "shared/lights.h"
#include "shared/pictures.h"
#include "shared/rsm.h"
#include "shared/scene.h"
#include "shared/view.h"
#include "shared/water.h"
#include "shared/brdf.h"
#include "tests/support/gl_test.h"

namespace sl {
namespace {

struct SharedStruct {
    std::string name, header;
    std::size_t size;
    std::map<std::string, std::size_t> offsets;
};

#define MEMBER(type, member) {#member, offsetof(type, member)}

const std::vector<SharedStruct>& shared_structs() {
    static const std::vector<SharedStruct> all{
        {"FrameParams", "frame", sizeof(FrameParams),
         {MEMBER(FrameParams, clip_from_world), MEMBER(FrameParams, camera_position), MEMBER(FrameParams, ray_forward),
          MEMBER(FrameParams, ray_right), MEMBER(FrameParams, ray_up), MEMBER(FrameParams, sky), MEMBER(FrameParams, counts)}},
        {"ViewParams", "view", sizeof(ViewParams), {MEMBER(ViewParams, clip_from_world), MEMBER(ViewParams, light)}},
        {"RsmGatherParams", "view", sizeof(RsmGatherParams),
         {MEMBER(RsmGatherParams, map), MEMBER(RsmGatherParams, grid), MEMBER(RsmGatherParams, disc), MEMBER(RsmGatherParams, tolerance),
          MEMBER(RsmGatherParams, slice)}},
        {"DrawParams", "scene", sizeof(DrawParams),
         {MEMBER(DrawParams, world_from_local), MEMBER(DrawParams, normal_from_local), MEMBER(DrawParams, first_material)}},
        {"MaterialParams", "scene", sizeof(MaterialParams),
         {MEMBER(MaterialParams, base_colour), MEMBER(MaterialParams, emission), MEMBER(MaterialParams, specular), MEMBER(MaterialParams, texture)}},
        {"PictureParams", "pictures", sizeof(PictureParams),
         {MEMBER(PictureParams, layers), MEMBER(PictureParams, second), MEMBER(PictureParams, colour.axes), MEMBER(PictureParams, colour.offset),
          MEMBER(PictureParams, emission.axes), MEMBER(PictureParams, emission.offset), MEMBER(PictureParams, data.axes), MEMBER(PictureParams, data.offset),
          MEMBER(PictureParams, relief.axes), MEMBER(PictureParams, relief.offset), MEMBER(PictureParams, alpha)}},
        {"PicturePlace", "pictures", sizeof(PicturePlace), {MEMBER(PicturePlace, axes), MEMBER(PicturePlace, offset)}},
        {"LightParams", "lights", sizeof(LightParams),
         {MEMBER(LightParams, map_clip_from_world), MEMBER(LightParams, position), MEMBER(LightParams, direction), MEMBER(LightParams, intensity),
          MEMBER(LightParams, cone), MEMBER(LightParams, kind), MEMBER(LightParams, tiles)}},
        {"Incident", "lights", sizeof(Incident), {MEMBER(Incident, to_light), MEMBER(Incident, irradiance)}},
        {"Surface", "brdf", sizeof(Surface), {MEMBER(Surface, base_colour), MEMBER(Surface, normal), MEMBER(Surface, specular)}},
        {"RsmPackedTexel", "rsm", sizeof(RsmPackedTexel), {MEMBER(RsmPackedTexel, position), MEMBER(RsmPackedTexel, light)}},
        {"ExposureParams", "exposure", sizeof(ExposureParams), {MEMBER(ExposureParams, adapt)}},
        {"FacetParams", "facets", sizeof(FacetParams), {MEMBER(FacetParams, grid), MEMBER(FacetParams, table)}},
        {"FacetCell", "facets", sizeof(FacetCell), {MEMBER(FacetCell, name), MEMBER(FacetCell, within)}},
        {"WaterParams", "water", sizeof(WaterParams), {MEMBER(WaterParams, absorption), MEMBER(WaterParams, scattering), MEMBER(WaterParams, view)}},
        {"RsmTexel", "rsm", sizeof(RsmTexel), {MEMBER(RsmTexel, position), MEMBER(RsmTexel, normal), MEMBER(RsmTexel, flux)}},
    };
    return all;
}

#undef MEMBER

/// Offsets by member name, as the linker reports them for one array element of the struct in a block.
std::map<std::string, std::size_t> offsets_in_gl(const SharedStruct& shared, bool storage, std::size_t* stride) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / fmt::format("sl_layout_{}", ::getpid());
    std::filesystem::create_directories(folder);
    std::filesystem::copy(shader_folder() / "shared", folder / "shared", std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing);
    const std::string head = fmt::format("#include \"shared/{}.h\"\nlayout(local_size_x = 1) in;\n", shared.header);
    const std::string block = storage ? fmt::format("layout(std430) buffer Block {{ {} items[]; }};\n", shared.name)
                                      : fmt::format("layout(std140) uniform Block {{ {} items[2]; }};\n", shared.name);
    std::string use;
    for (const auto& [member, offset] : shared.offsets) {
        const bool matrix = member == "clip_from_world" || member == "world_from_local" || member == "normal_from_local" || member == "map_clip_from_world";
        use += fmt::format("    sum += vec4(items[1].{}{});\n", member, matrix ? "[1]" : "");
    }
    std::ofstream(folder / "layout.comp") << head << block << "layout(std430) buffer Out { vec4 result; };\nvoid main() {\n    vec4 sum = vec4(0);\n"
                                          << use << "    result = sum;\n}\n";
    gl::ProgramCache cache(folder);
    const GLuint program = cache.get({.compute = "layout.comp"}).id();
    const GLenum interface = storage ? GL_BUFFER_VARIABLE : GL_UNIFORM;
    GLint count = 0;
    glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
    std::map<std::string, std::size_t> offsets;
    for (GLint i = 0; i < count; ++i) {
        char name[256];
        glGetProgramResourceName(program, interface, static_cast<GLuint>(i), sizeof name, nullptr, name);
        const std::string full = name;
        if (!full.starts_with("Block.items[0].") && !full.starts_with("items[0].")) continue;
        const GLenum properties[] = {GL_OFFSET, GL_TOP_LEVEL_ARRAY_STRIDE};
        GLint values[2] = {};
        glGetProgramResourceiv(program, interface, static_cast<GLuint>(i), storage ? 2 : 1, properties, 2, nullptr, values);
        offsets[full.substr(full.find("].") + 2)] = static_cast<std::size_t>(values[0]);
        if (storage) *stride = static_cast<std::size_t>(values[1]);
    }
    std::filesystem::remove_all(folder);
    return offsets;
}

class SharedLayout : public GlTest {};

TEST_F(SharedLayout, EveryMemberLiesWhereGlPutsIt) {
    for (const SharedStruct& shared : shared_structs()) {
        std::size_t stride = 0;
        EXPECT_EQ(offsets_in_gl(shared, true, &stride), shared.offsets) << shared.name << " in a storage block";
        EXPECT_EQ(stride, shared.size) << shared.name;
        EXPECT_EQ(offsets_in_gl(shared, false, &stride), shared.offsets) << shared.name << " in a uniform block";
    }
}

TEST_F(SharedLayout, NoSharedStructIsForgotten) {
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::directory_iterator(shader_folder() / "shared")) {
        std::ifstream file(entry.path());
        for (std::string line; std::getline(file, line);) found += line.starts_with("struct ") ? 1 : 0;
    }
    EXPECT_EQ(found, shared_structs().size()) << "a struct in shader/shared is missing from this test's list";
}

}  // namespace
}  // namespace sl
