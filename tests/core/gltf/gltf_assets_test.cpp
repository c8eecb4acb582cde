// SPDX-License-Identifier: MIT
#include <array>

#include "tests/core/gltf/gltf_fixture.h"
#include "tests/support/assets.h"

namespace sl {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What the format's own validator says, and a part of a message that says the same.
struct CodeEntry {
    std::string_view code, part;
};
constexpr std::array codes{
    CodeEntry{"ACCESSOR_ANIMATION_INPUT_NEGATIVE", "before 0"},
    CodeEntry{"ACCESSOR_ANIMATION_INPUT_NON_INCREASING", "the one before it"},
    CodeEntry{"ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION", "quaternion of length"},
    CodeEntry{"ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", "the elements' is"},
    CodeEntry{"ACCESSOR_ELEMENT_OUT_OF_MIN_BOUND", "the elements' is"},
    CodeEntry{"ACCESSOR_INDEX_OOB", "leads to vertex"},
    CodeEntry{"ACCESSOR_INDEX_PRIMITIVE_RESTART", "would begin a new primitive"},
    CodeEntry{"ACCESSOR_INVALID_FLOAT", "no finite numbers"},
    CodeEntry{"ACCESSOR_INVALID_IBM", "the last row of matrix"},
    CodeEntry{"ACCESSOR_INVALID_SIGN", "not 1 or -1"},
    CodeEntry{"ACCESSOR_JOINTS_INDEX_DUPLICATE", "hangs on joint"},
    CodeEntry{"ACCESSOR_JOINTS_INDEX_OOB", "refers to joint"},
    CodeEntry{"ACCESSOR_MATRIX_ALIGNMENT", "matrices do not begin"},
    CodeEntry{"ACCESSOR_MAX_MISMATCH", "the elements' is"},
    CodeEntry{"ACCESSOR_MIN_MISMATCH", "the elements' is"},
    CodeEntry{"ACCESSOR_NON_CLAMPED", "not between 0 and 1"},
    CodeEntry{"ACCESSOR_NORMALIZED_INVALID", "cannot be normalized"},
    CodeEntry{"ACCESSOR_OFFSET_ALIGNMENT", "no multiple of the component's"},
    CodeEntry{"ACCESSOR_SMALL_BYTESTRIDE", "they overlap"},
    CodeEntry{"ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE", "replaces"},
    CodeEntry{"ACCESSOR_TOO_LONG", "ends at byte"},
    CodeEntry{"ACCESSOR_TOTAL_OFFSET_ALIGNMENT", "in the buffer, no multiple"},
    CodeEntry{"ACCESSOR_VECTOR3_NON_UNIT", "has the length"},
    CodeEntry{"ACCESSOR_WEIGHTS_NEGATIVE", "has the weight -"},
    CodeEntry{"ACCESSOR_WEIGHTS_NON_NORMALIZED", "sum to"},
    CodeEntry{"ANIMATION_CHANNEL_TARGET_NODE_MATRIX", "has a matrix"},
    CodeEntry{"ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", "no morph targets"},
    CodeEntry{"ANIMATION_DUPLICATE_TARGETS", "another channel moves"},
    CodeEntry{"ANIMATION_SAMPLER_ACCESSOR_WITH_BYTESTRIDE", "has a byteStride"},
    CodeEntry{"ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", "must be SCALAR of float32"},
    CodeEntry{"ANIMATION_SAMPLER_INPUT_ACCESSOR_TOO_FEW_ELEMENTS", "CUBICSPLINE needs two"},
    CodeEntry{"ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS", "no min and max"},
    CodeEntry{"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT", "keys need"},
    CodeEntry{"ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", "it must be VEC3"},
    CodeEntry{"ARRAY_TYPE_MISMATCH", "must be an object"},
    CodeEntry{"ASSET_MIN_VERSION_GREATER_THAN_VERSION", "later than the version"},
    CodeEntry{"BUFFER_BYTE_LENGTH_MISMATCH", "but there are only"},
    CodeEntry{"BUFFER_DATA_URI_MIME_TYPE_INVALID", "holds data of the type"},
    CodeEntry{"BUFFER_MISSING_GLB_DATA", "no BIN chunk"},
    CodeEntry{"BUFFER_VIEW_INVALID_BYTE_STRIDE", "only views of vertices may have"},
    CodeEntry{"BUFFER_VIEW_TARGET_OVERRIDE", "so that it cannot hold"},
    CodeEntry{"BUFFER_VIEW_TOO_BIG_BYTE_STRIDE", "more than the whole view"},
    CodeEntry{"BUFFER_VIEW_TOO_LONG", "lie outside buffer"},
    CodeEntry{"CAMERA_XMAG_YMAG_ZERO", "mag is 0"},
    CodeEntry{"CAMERA_ZFAR_LEQUAL_ZNEAR", "not more than znear"},
    CodeEntry{"DUPLICATE_ELEMENTS", "stands in the array twice"},
    CodeEntry{"EMPTY_ENTITY", "is an empty"},
    CodeEntry{"GLB_CHUNK_LENGTH_UNALIGNED", "no multiple of 4"},
    CodeEntry{"GLB_CHUNK_TOO_BIG", "are left"},
    CodeEntry{"GLB_DUPLICATE_CHUNK", "is a second"},
    CodeEntry{"GLB_EMPTY_CHUNK", "the JSON chunk is empty"},
    CodeEntry{"GLB_INVALID_MAGIC", "neither a container"},
    CodeEntry{"GLB_INVALID_VERSION", "the container has version"},
    CodeEntry{"GLB_LENGTH_MISMATCH", "bytes long, the file has"},
    CodeEntry{"GLB_LENGTH_TOO_SMALL", "too short for a chunk"},
    CodeEntry{"GLB_UNEXPECTED_BIN_CHUNK", "must be the second"},
    CodeEntry{"GLB_UNEXPECTED_END_OF_CHUNK_DATA", "are left"},
    CodeEntry{"GLB_UNEXPECTED_END_OF_CHUNK_HEADER", "within the header of chunk"},
    CodeEntry{"GLB_UNEXPECTED_END_OF_HEADER", "the file is empty"},
    CodeEntry{"GLB_UNEXPECTED_END_OF_HEADER", "neither a container"},
    CodeEntry{"GLB_UNEXPECTED_FIRST_CHUNK", "first chunk must be JSON"},
    CodeEntry{"IMAGE_BUFFER_VIEW_WITH_BYTESTRIDE", "has a byteStride"},
    CodeEntry{"IMAGE_DATA_INVALID", "is no JPEG"},
    CodeEntry{"IMAGE_MIME_TYPE_INVALID", "the picture is"},
    CodeEntry{"IMAGE_MIME_TYPE_INVALID", "not a picture that the format knows"},
    CodeEntry{"IMAGE_NON_ENABLED_MIME_TYPE", "among the extensions used"},
    CodeEntry{"IMAGE_UNEXPECTED_EOS", "ends within its header"},
    CodeEntry{"INVALID_IBM_ACCESSOR_COUNT", "matrices for"},
    CodeEntry{"INVALID_JSON", "is no JSON"},
    CodeEntry{"INVALID_JSON", "byte order mark"},
    CodeEntry{"INVALID_JSON", "the file is empty"},
    CodeEntry{"INVALID_URI", "is no URI"},
    CodeEntry{"INVALID_URI", "not a picture that the format knows"},
    CodeEntry{"IO_ERROR", "there is no such file"},
    CodeEntry{"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_NODE", "must be left out beside"},
    CodeEntry{"KHR_ANIMATION_POINTER_ANIMATION_CHANNEL_TARGET_PATH", "it must be 'pointer'"},
    CodeEntry{"KHR_LIGHTS_PUNCTUAL_LIGHT_SPOT_ANGLES", "not less than outerConeAngle"},
    CodeEntry{"KHR_MATERIALS_VARIANTS_NON_UNIQUE_VARIANT", "has two materials"},
    CodeEntry{"MESH_INVALID_WEIGHTS_COUNT", "weights for"},
    CodeEntry{"MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT", "first primitive has"},
    CodeEntry{"MESH_PRIMITIVE_ACCESSOR_UNALIGNED", "do not begin at multiples"},
    CodeEntry{"MESH_PRIMITIVE_ACCESSOR_WITHOUT_BYTESTRIDE", "has no byteStride"},
    CodeEntry{"MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", "it must be VEC3"},
    CodeEntry{"MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_UNSIGNED_INT", "anything but uint32"},
    CodeEntry{"MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY", "without a gap"},
    CodeEntry{"MESH_PRIMITIVE_INDICES_ACCESSOR_INVALID_FORMAT", "must be SCALAR of uint8"},
    CodeEntry{"MESH_PRIMITIVE_INDICES_ACCESSOR_WITH_BYTESTRIDE", "has a byteStride"},
    CodeEntry{"MESH_PRIMITIVE_INVALID_ATTRIBUTE", "is no attribute of the format"},
    CodeEntry{"MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH", "JOINTS and"},
    CodeEntry{"MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT", "elements for"},
    CodeEntry{"MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR", "to add it to"},
    CodeEntry{"MESH_PRIMITIVE_NO_TANGENT_SPACE", "needs NORMAL and TANGENT"},
    CodeEntry{"MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS", "no min and max"},
    CodeEntry{"MESH_PRIMITIVE_TOO_FEW_TEXCOORDS", "needs TEXCOORD_"},
    CodeEntry{"MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", "elements for"},
    CodeEntry{"NODE_LOOP", "hangs on itself"},
    CodeEntry{"NODE_MATRIX_NON_TRS", "is no product"},
    CodeEntry{"NODE_MATRIX_TRS", "has a matrix beside"},
    CodeEntry{"NODE_PARENT_OVERRIDE", "already a child"},
    CodeEntry{"NODE_SKIN_NO_SCENE", "are not in scene"},
    CodeEntry{"NODE_SKIN_WITH_NON_SKINNED_MESH", "no JOINTS_0"},
    CodeEntry{"NODE_WEIGHTS_INVALID", "morph targets"},
    CodeEntry{"NON_REQUIRED_EXTENSION", "must be required too"},
    CodeEntry{"ONE_OF_MISMATCH", "exactly one"},
    CodeEntry{"PATTERN_MISMATCH", "must be a"},
    CodeEntry{"ROTATION_NON_UNIT", "quaternion of length"},
    CodeEntry{"SCENE_NON_ROOT_NODE", "is no root"},
    CodeEntry{"SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE", "has a byteStride"},
    CodeEntry{"SKIN_IBM_INVALID_FORMAT", "must be MAT4"},
    CodeEntry{"SKIN_NO_COMMON_ROOT", "no common root"},
    CodeEntry{"SKIN_SKELETON_INVALID", "is not below"},
    CodeEntry{"TEXTURE_INVALID_IMAGE_MIME_TYPE", "here it must be"},
    CodeEntry{"TYPE_MISMATCH", "must be a"},
    CodeEntry{"UNDECLARED_EXTENSION", "does not stand in /extensionsUsed"},
    CodeEntry{"UNDEFINED_PROPERTY", "has no \""},
    CodeEntry{"UNEXPECTED_EXTENSION_OBJECT", "has no place"},
    CodeEntry{"UNKNOWN_ASSET_MAJOR_VERSION", "this program reads 2.0"},
    CodeEntry{"UNRESOLVED_REFERENCE", "refers to number"},
    CodeEntry{"UNSATISFIED_DEPENDENCY", "beside it"},
    CodeEntry{"UNSATISFIED_DEPENDENCY", "refers to number"},
    CodeEntry{"UNUSED_EXTENSION_REQUIRED", "is required, but"},
    CodeEntry{"VALUE_MULTIPLE_OF", "must be a multiple"},
    // A number that no double holds is refused by the reader of JSON.
    CodeEntry{"VALUE_NOT_IN_RANGE", "number overflow"},
    CodeEntry{"VALUE_NOT_IN_RANGE", "must be"},
};

class GltfAssetsTest : public AssetsTest {
  protected:
    static std::vector<GltfFault> faults_of(const fs::path& path) {
        const std::string content = content_of(path);
        const auto load = [&](const std::string& beside) {
            const fs::path file = path.parent_path() / beside;
            if (!fs::is_regular_file(file)) fail("{}: there is no such file", beside);
            const std::string text = content_of(file);
            const auto bytes = bytes_of(text);
            return std::vector<std::byte>(bytes.begin(), bytes.end());
        };
        const GltfChecked checked = check_gltf(bytes_of(content), load);
        return checked.faults.list();
    }

    static std::string text_of(const std::vector<GltfFault>& faults) {
        std::string text;
        for (const GltfFault& fault : faults) {
            text += fmt::format("\n    {} {}: {}", fault.fatal ? "fatal" : "note", fault.where, fault.message);
        }
        return text;
    }

    static bool says(const std::vector<GltfFault>& faults, std::string_view code) {
        return std::any_of(codes.begin(), codes.end(), [&](const CodeEntry& entry) {
            return entry.code == code && std::any_of(faults.begin(), faults.end(), [&](const GltfFault& fault) {
                       return fault.message.find(entry.part) != std::string::npos;
                   });
        });
    }
};

TEST_F(GltfAssetsTest, EveryMalformedFileIsTold) {
    for (const json& entry : manifest()) {
        if (entry.value("errors", 0) == 0) continue;
        const std::string file = entry["file"].get<std::string>();
        const auto faults = faults_of(folder / file);
        if (faults.empty()) {
            ADD_FAILURE() << file << " has no fault; it should have " << entry["codes"];
            continue;
        }
        const auto& told = entry["codes"];
        EXPECT_TRUE(std::any_of(told.begin(), told.end(), [&](const json& code) { return says(faults, code.get<std::string>()); }))
            << file << " should have " << told << ", and has" << text_of(faults);
    }
}

/// Without a fatal fault nothing is left unread: then every code must be said.
TEST_F(GltfAssetsTest, FilesWithoutFatalFaultsAreToldInFull) {
    for (const json& entry : manifest()) {
        if (entry.value("errors", 0) == 0) continue;
        const std::string file = entry["file"].get<std::string>();
        const auto faults = faults_of(folder / file);
        if (std::any_of(faults.begin(), faults.end(), [](const GltfFault& fault) { return fault.fatal; })) continue;
        for (const json& code : entry["codes"]) {
            EXPECT_TRUE(says(faults, code.get<std::string>())) << file << " should have " << code << ", and has" << text_of(faults);
        }
    }
}

TEST_F(GltfAssetsTest, ValidFilesHaveNoFault) {
    for (const fs::path& path : models("valid")) {
        const auto faults = faults_of(path);
        EXPECT_TRUE(faults.empty()) << path << text_of(faults);
    }
}

TEST_F(GltfAssetsTest, ModelsOfThePublicLoad) {
    for (const fs::path& path : models("public")) {
        if (path.extension() == ".vox") continue;
        const auto faults = faults_of(path);
        EXPECT_TRUE(std::none_of(faults.begin(), faults.end(), [](const GltfFault& fault) { return fault.fatal; })) << path << text_of(faults);
        if (!faults.empty()) std::cout << path << text_of(faults) << '\n';
    }
}

/// No crash and no hang is asked of those without a verdict.
TEST_F(GltfAssetsTest, FilesWithoutVerdict) {
    std::size_t count = 0;
    for (const json& entry : manifest()) {
        if (entry.contains("errors")) continue;
        const fs::path path = folder / entry["file"].get<std::string>();
        if (path.extension() != ".gltf" && path.extension() != ".glb") continue;
        std::cout << path.filename() << text_of(faults_of(path)) << '\n';
        ++count;
    }
    EXPECT_GT(count, 0u);
}

}  // namespace
}  // namespace sl
