// SPDX-License-Identifier: MIT
// lib/vertex.glsl: positions and normals in world space under any affine placement.
#include <glm/gtc/matrix_transform.hpp>

#include "engine/core/math.h"
#include "engine/render/scene/rows.h"
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

class VertexLibrary : public LibraryTest {
  protected:
    /// One vertex drawn as a point over the only pixel, whose colour is `value`.
    vec4 vertex_value(const std::string& value, vec3 position, vec3 normal, std::uint32_t draw_index) {
        write("vertex.vert", "#include \"lib/vertex.glsl\"\nflat out vec4 value;\n"
                             "void main() {\n    value = vec4(" + value + ", 1.0);\n    gl_Position = vec4(0.0, 0.0, 0.0, 1.0);\n}\n");
        write("vertex.frag", "flat in vec4 value;\nout vec4 colour;\nvoid main() { colour = value; }\n");
        return draw("vertex.vert", "vertex.frag", 1, 1, [&](const gl::Program& program) {
            // No arrays: every vertex has these attributes.
            glVertexAttrib3f(0, position.x, position.y, position.z);
            glVertexAttribI1ui(1, pack_normal(normal));
            glUniform1ui(program.uniforms().at("draw_index"), draw_index);
            glDrawArrays(GL_POINTS, 0, 1);
        }).at(0);
    }
};

TEST_F(VertexLibrary, PositionsAndNormalsFollowTheirDraw) {
    const mat4 one(1.0f);
    const mat4 turn = glm::rotate(one, 1.1f, glm::normalize(vec3(1, 2, 3)));
    const mat4 shear(vec4(1, 0, 0, 0), vec4(0.7f, 1, 0, 0), vec4(0, -0.4f, 1, 0), vec4(0, 0, 0, 1));
    const std::pair<const char*, mat4> placements[] = {
        {"where it is", one},
        {"moved", glm::translate(one, vec3(5, -2, 9))},
        {"turned", turn},
        {"stretched unevenly", glm::scale(one, vec3(0.1f, 3, 20))},
        {"mirrored", glm::scale(one, vec3(-1, 1, 1))},
        {"mirrored, turned and stretched", glm::translate(turn * glm::scale(one, vec3(2, -0.5f, 7)), vec3(1, 2, 3))},
        {"mirrored three times", glm::scale(one, vec3(-1, -2, -3))},
        {"sheared", turn * shear}};
    std::vector<DrawParams> draws;
    for (const auto& [name, place] : placements) draws.push_back({.world_from_local = place, .normal_from_local = normal_matrix(place), .first_material = {}});
    give("Draws", draws);

    const vec3 position(0.3f, -1.7f, 2.9f);
    for (std::uint32_t i = 0; i < draws.size(); ++i) {
        SCOPED_TRACE(placements[i].first);
        const mat4& place = placements[i].second;
        expect_close(vertex_value("position_in_world()", position, vec3(0, 1, 0), i), vec4(vec3(place * vec4(position, 1)), 1), 1e-5f, i);
        for (const vec3& wanted : {vec3(0, 1, 0), vec3(-1, 0, 0), glm::normalize(vec3(1, -2, 3)), glm::normalize(vec3(-3, -1, -1))}) {
            const vec3 normal = unpack_normal(pack_normal(wanted));  // 16 bits a coordinate: not the shader's error
            // The textbook's inverse transpose, which the engine's cofactors stand for.
            const vec3 expected = glm::normalize(glm::transpose(glm::inverse(mat3(place))) * normal);
            expect_close(vertex_value("normal_in_world()", position, normal, i), vec4(expected, 1), 1e-5f, i);
        }
    }
}

TEST_F(VertexLibrary, NormalOfWhatHasNoExtentIsZero) {
    const mat4 nothing = glm::scale(mat4(1.0f), vec3(0));
    give("Draws", std::vector<DrawParams>{{.world_from_local = nothing, .normal_from_local = normal_matrix(nothing), .first_material = {}}});
    EXPECT_EQ(vec3(vertex_value("normal_in_world()", vec3(1), vec3(0, 1, 0), 0)), vec3(0)) << "not a number would spread";
}

}  // namespace
}  // namespace sl
