// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <optional>

#include "engine/core/model/read_model.h"
#include "engine/ecs/components/model_file.h"
#include "engine/ecs/systems/model_pictures.h"
#include "engine/ecs/world.h"

namespace sl {

/// A file that is being read.
struct ModelBeingRead {
    std::filesystem::path file;
    std::size_t pictures = 0, decoded = 0;  ///< 0 pictures: the file itself is being read
    double seconds = 0.0;                   ///< since it began
};

/// The model files that entities show, each loaded once; a resource. Files are read on a thread of their own. One that could
/// not be read is tried again once it has changed.
class ModelLibrary {
  public:
    ModelLibrary() = default;
    ~ModelLibrary();
    ModelLibrary(ModelLibrary&&) = default;
    ModelLibrary& operator=(ModelLibrary&&) = default;

    /// What is shown waits for its files, as pictures have to; a window shows the rest meanwhile.
    bool at_once = false;
    ModelReading reading;

    std::vector<ModelBeingRead> being_read() const;
    /// Why files cannot be shown, a line each; for whoever shows the rest to tell.
    std::vector<std::string> faults() const;

  private:
    friend class ModelLoader;
    struct Read {
        Model model;
        ModelPictures pictures;
    };
    struct Loaded {
        std::chrono::steady_clock::time_point since{};
        std::filesystem::file_time_type written{};  ///< when it was, as it was read
        std::shared_ptr<ModelProgress> progress = std::make_shared<ModelProgress>();
        std::future<Read> coming;
        std::shared_ptr<const Model> model;
        std::string fault;  ///< why there is none
        std::vector<std::vector<MeshHandle>> meshes;  ///< per mesh, per primitive
        std::int32_t first_material = 0;              ///< in the MaterialTable; one more than the file has, the plain one last
    };
    std::map<std::filesystem::path, Loaded> files_;
};

/// The entities that show a model, made by load_models below the one that has its ModelFile.
struct ModelParts {
    ModelFile made_by;
    bool made = false;  ///< false while its file is being read, or where it cannot be
    std::shared_ptr<const Model> model{};
    std::vector<Entity> nodes{};  ///< by the model's number; null for those of other scenes
    /// A mesh that joints or morphs move, which is therefore this entity's own.
    struct Posed {
        Entity entity;
        std::size_t node, primitive;
    };
    std::vector<Posed> posed{};
    std::optional<double> posed_at{};  ///< s: as the animation last was
};

/// A part of an entity's model.
struct ModelPart {
    Entity owner;
    MeshHandle own_mesh{};  ///< that goes with it
};

/// Reads the files of new ModelFiles, and makes and removes the entities that show them. Throws Error where the library's
/// `at_once` is set and a file cannot be shown.
void load_models(World& world);

/// Where a model's file is.
std::filesystem::path model_path(const World& world, const ModelFile& file);

}  // namespace sl
