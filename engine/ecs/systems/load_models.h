// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <future>
#include <map>
#include <memory>
#include <optional>

#include "engine/core/model/read_model.h"
#include "engine/ecs/components/model_file.h"
#include "engine/ecs/systems/stored_model.h"

namespace sl {

/// A file that is being read.
struct ModelBeingRead {
    std::filesystem::path file;
    std::size_t pictures = 0, decoded = 0;  ///< 0 pictures: the file itself is being read
    double seconds = 0.0;                   ///< since it began
};

/// What showing a model once takes of what all models of a world may take together: a short scene may show a large one many times.
struct ModelCost {
    std::uint64_t parts = 0;        ///< entities
    std::uint64_t triangles = 0;    ///< that are drawn
    std::uint64_t posed_bytes = 0;  ///< of meshes that joints or morphs move, which each entity has for itself

    ModelCost operator+(const ModelCost& other) const { return {parts + other.parts, triangles + other.triangles, posed_bytes + other.posed_bytes}; }
};
inline constexpr ModelCost most_model_cost{.parts = 1u << 19, .triangles = 1u << 28, .posed_bytes = 1u << 30};

/// The model files that entities show, each loaded once and kept as long as one shows it; a resource. Files are read on a thread
/// of their own. One that could not be read is tried again once it has changed.
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
        StoredModel stored;
        ModelCost cost;
    };
    std::map<std::filesystem::path, Loaded> files_;
    std::string too_much_;  ///< why a model that is there is not shown
};

/// The entities that show a model, made by load_models below the one that has its ModelFile.
struct ModelParts {
    ModelFile made_by;
    bool made = false;  ///< false while its file is being read, or where it cannot be, or is too much
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
