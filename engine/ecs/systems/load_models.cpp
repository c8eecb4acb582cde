// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/load_models.h"

#include <algorithm>
#include <set>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/core/model/model_pose.h"
#include "engine/ecs/components.h"
#include "engine/ecs/parent.h"
#include "engine/ecs/query.h"
#include "engine/ecs/scene_file.h"

namespace sl {

namespace {

void add_light(World& world, Entity entity, const ModelLight& light) {
    switch (light.kind) {
        case ModelLight::Kind::directional:
            world.add(entity, DirectionalLight{.colour = light.colour, .illuminance = light.intensity});
            break;
        case ModelLight::Kind::point:
            world.add(entity, PointLight{.colour = light.colour, .intensity = light.intensity, .range = light.range});
            break;
        case ModelLight::Kind::spot:
            world.add(entity, SpotLight{.colour = light.colour, .intensity = light.intensity, .range = light.range, .inner_cone = light.inner_cone, .outer_cone = light.outer_cone});
            break;
    }
}

ModelCost cost_of(const Model& model) {
    std::vector<ModelCost> meshes;
    for (const ModelMesh& mesh : model.meshes) {
        ModelCost& cost = meshes.emplace_back();
        for (const ModelPrimitive& primitive : mesh.primitives) {
            ++cost.parts;
            cost.triangles += primitive.mesh.indices.size() / 3;
            if (deforms(primitive)) cost.posed_bytes += primitive.mesh.vertices.size() * sizeof(Vertex) + primitive.mesh.pictured.size() * sizeof(PicturedVertex) + primitive.mesh.indices.size() * sizeof(std::uint32_t);
        }
    }
    ModelCost all{.parts = model.nodes.size()};
    for (const ModelNode& node : model.nodes) {
        if (node.mesh >= 0) all = all + meshes[static_cast<std::size_t>(node.mesh)];
    }
    return all;
}

/// Why that is too much; empty: it is not.
std::string too_much(const ModelCost& cost) {
    const ModelCost& most = most_model_cost;
    if (cost.parts > most.parts) return fmt::format("{} entities; {} is the limit", cost.parts, most.parts);
    if (cost.triangles > most.triangles) return fmt::format("{} million triangles; {} million is the limit", cost.triangles / 1'000'000, most.triangles / 1'000'000);
    if (cost.posed_bytes > most.posed_bytes) return fmt::format("{} MB of meshes that move; {} MB is the limit", cost.posed_bytes >> 20, most.posed_bytes >> 20);
    return {};
}

}  // namespace

ModelLibrary::~ModelLibrary() {
    // What is being read is waited for, so let it be short.
    for (auto& [path, loaded] : files_) loaded.progress->unwanted = true;
}

std::vector<ModelBeingRead> ModelLibrary::being_read() const {
    std::vector<ModelBeingRead> all;
    for (const auto& [path, loaded] : files_) {
        if (!loaded.coming.valid()) continue;
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - loaded.since;
        all.push_back({.file = path, .pictures = loaded.progress->pictures, .decoded = loaded.progress->decoded, .seconds = seconds.count()});
    }
    return all;
}

std::vector<std::string> ModelLibrary::faults() const {
    std::vector<std::string> all;
    for (const auto& [path, loaded] : files_) {
        if (!loaded.fault.empty()) all.push_back(loaded.fault);
    }
    if (!too_much_.empty()) all.push_back(too_much_);
    return all;
}

std::filesystem::path model_path(const World& world, const ModelFile& file) {
    return references_folder(world) / file.file;
}

/// One run of load_models.
class ModelLoader {
  public:
    explicit ModelLoader(World& world) : world_(world), library_(world.resource<ModelLibrary>()) {}

    void run() {
        drop_orphans();
        std::vector<std::pair<Entity, ModelFile>> wanted;
        for (auto [entity, file] : Query<const ModelFile>(world_)) {
            const auto* parts = world_.find<ModelParts>(entity);
            if (parts == nullptr || !parts->made || !shows_the_same(parts->made_by, file)) wanted.emplace_back(entity, file);
        }
        library_.too_much_.clear();
        if (!wanted.empty()) count_shown();
        for (const auto& [entity, file] : wanted) show(entity, file);
        forget_all_but(wanted);
    }

  private:
    using Loaded = ModelLibrary::Loaded;

    static bool shows_the_same(const ModelFile& a, const ModelFile& b) { return a.file == b.file && a.scene == b.scene; }

    void count_shown() {
        std::map<const Model*, ModelCost> costs;
        for (const auto& [path, loaded] : library_.files_) costs[loaded.model.get()] = loaded.cost;
        for (auto [entity, parts] : Query<const ModelParts>(world_)) {
            if (parts.made) shown_ = shown_ + costs.at(parts.model.get());
        }
    }

    /// Files that are neither shown nor wanted: models that are gone, and those whose name was still being typed.
    void forget_all_but(std::span<const std::pair<Entity, ModelFile>> wanted) {
        std::set<std::filesystem::path> asked;
        for (const auto& [entity, file] : wanted) asked.insert(model_path(world_, file));
        for (auto entry = library_.files_.begin(); entry != library_.files_.end();) {
            Loaded& loaded = entry->second;
            // Whatever shows a model holds it.
            const bool is_used = asked.contains(entry->first) || loaded.model.use_count() > 1;
            if (!is_used) loaded.progress->unwanted = true;
            if (is_used || is_being_read(loaded)) {
                ++entry;
                continue;
            }
            give_back(loaded);
            entry = library_.files_.erase(entry);
        }
    }

    static bool is_being_read(const Loaded& loaded) { return loaded.coming.valid() && loaded.coming.wait_for(std::chrono::seconds(0)) != std::future_status::ready; }

    void give_back(Loaded& loaded) {
        if (!loaded.model) return;
        std::vector<StoredModel*> others;
        for (auto& [path, other] : library_.files_) {
            if (&other != &loaded && other.model) others.push_back(&other.stored);
        }
        remove_model(world_, loaded.stored, others);
    }

    void show(Entity entity, const ModelFile& file) {
        if (const auto* before = world_.find<ModelParts>(entity); before != nullptr && !shows_the_same(before->made_by, file)) drop(entity);
        if (!world_.has<ModelParts>(entity)) world_.add(entity, ModelParts{.made_by = file});
        if (file.file.empty()) return;
        Loaded& loaded = loaded_file(model_path(world_, file));
        if (!loaded.fault.empty() && library_.at_once) fail("{}", loaded.fault);
        if (!loaded.model) return;
        if (const std::string why = too_much(shown_ + loaded.cost); !why.empty()) {
            library_.too_much_ = fmt::format("{}: it is not shown, because all models together would have {}", file.file, why);
            if (library_.at_once) fail("{}", library_.too_much_);
            return;
        }
        shown_ = shown_ + loaded.cost;
        // Adding components moves others, so this one is put in place when all are there.
        ModelParts parts = made_parts(entity, file, loaded);
        world_.get<ModelParts>(entity) = std::move(parts);
    }

    Loaded& loaded_file(const std::filesystem::path& path) {
        std::error_code missing;
        const auto written = std::filesystem::last_write_time(path, missing);
        const auto [entry, fresh] = library_.files_.try_emplace(path);
        Loaded& loaded = entry->second;
        // What nobody wanted for a moment has been read in part.
        const bool is_cut_short = loaded.progress->unwanted;
        if (is_cut_short && is_being_read(loaded) && !library_.at_once) return loaded;
        if (fresh || is_cut_short || (!loaded.fault.empty() && loaded.written != written)) {
            loaded = {.since = std::chrono::steady_clock::now(), .written = written};
            loaded.coming = std::async(std::launch::async, [path, reading = library_.reading, progress = loaded.progress] {
                ModelLibrary::Read read{.model = read_model(path, reading), .pictures = {}};
                read.pictures = model_pictures(read.model, *progress);
                return read;
            });
        }
        const bool there = loaded.coming.valid() && (library_.at_once || loaded.coming.wait_for(std::chrono::seconds(0)) == std::future_status::ready);
        if (!there) return loaded;
        try {
            ModelLibrary::Read read = loaded.coming.get();
            for (const auto* warnings : {&read.model.warnings, &read.pictures.warnings}) {
                for (const std::string& warning : *warnings) log::warn("{}: {}", path.string(), warning);
            }
            loaded.cost = cost_of(read.model);
            loaded.stored = store_model(world_, read.model, read.pictures);
            loaded.model = std::make_shared<const Model>(std::move(read.model));
        } catch (const std::exception& error) {
            loaded.fault = error.what();
        }
        return loaded;
    }

    ModelParts made_parts(Entity root, const ModelFile& file, const Loaded& loaded) {
        const Model& model = *loaded.model;
        ModelParts parts{.made_by = file, .made = true, .model = loaded.model, .nodes = std::vector<Entity>(model.nodes.size())};
        const std::size_t scene = file.scene >= 0 ? static_cast<std::size_t>(file.scene) : model.scene;
        if (scene >= model.scenes.size()) log::warn("{}: it has {} scenes, so none is number {}", file.file, model.scenes.size(), file.scene);
        const auto places = places_of(model, scene);
        for (std::size_t i = 0; i < model.nodes.size(); ++i) {
            if (!places[i]) continue;
            const ModelNode& node = model.nodes[i];
            const Entity above = node.parent >= 0 && parts.nodes[static_cast<std::size_t>(node.parent)] ? parts.nodes[static_cast<std::size_t>(node.parent)] : root;
            const Entity entity = parts.nodes[i] = world_.create(Transform{.translation = node.translation, .rotation = node.rotation, .scale = node.scale}, Parent{above}, ModelPart{root});
            if (node.light >= 0) add_light(world_, entity, model.lights[static_cast<std::size_t>(node.light)]);
            if (node.camera >= 0) {
                const ModelCamera& camera = model.cameras[static_cast<std::size_t>(node.camera)];
                world_.add(entity, Camera{.fov_y = camera.fov_y, .height = camera.height, .near = camera.near, .active = false});
            }
            if (node.mesh >= 0) show_mesh(root, i, loaded, parts);
        }
        return parts;
    }

    void show_mesh(Entity root, std::size_t number, const Loaded& loaded, ModelParts& parts) {
        const ModelNode& node = loaded.model->nodes[number];
        const auto mesh = static_cast<std::size_t>(node.mesh);
        const auto& primitives = loaded.model->meshes[mesh].primitives;
        for (std::size_t i = 0; i < primitives.size(); ++i) {
            const auto plain = static_cast<std::int32_t>(loaded.model->materials.size());
            const std::int32_t material = primitives[i].material >= 0 ? primitives[i].material : plain;
            const bool own = deforms(primitives[i]);
            const MeshHandle handle = own ? world_.resource<MeshPool>().insert(primitives[i].mesh) : loaded.stored.meshes[mesh][i];
            // A skin says where its mesh is, whatever its node does.
            const bool skinned = node.skin >= 0 && !primitives[i].joints.empty();
            const Entity entity = world_.create(Transform{}, Parent{skinned ? root : parts.nodes[number]}, MeshInstance{.mesh = handle, .first_material = loaded.stored.first_material + material},
                                                ModelPart{root, own ? handle : MeshHandle{}});
            if (own) parts.posed.push_back({entity, number, i});
        }
    }

    void drop(Entity owner) {
        std::vector<Entity> parts;
        for (auto [entity, part] : Query<const ModelPart>(world_)) {
            if (part.owner == owner) parts.push_back(entity);
        }
        destroy(parts);
        world_.remove<ModelParts>(owner);
    }

    void destroy(const std::vector<Entity>& parts) {
        for (const Entity part : parts) {
            if (const MeshHandle own = world_.get<ModelPart>(part).own_mesh) world_.resource<MeshPool>().erase(own);
            world_.destroy(part);
        }
    }

    /// Parts whose entity has lost its model, or is gone.
    void drop_orphans() {
        std::vector<Entity> owners, orphans;
        for (auto [entity, parts] : Query<const ModelParts>(world_)) {
            if (!world_.has<ModelFile>(entity)) owners.push_back(entity);
        }
        for (const Entity owner : owners) world_.remove<ModelParts>(owner);
        for (auto [entity, part] : Query<const ModelPart>(world_)) {
            if (!world_.alive(part.owner) || !world_.has<ModelParts>(part.owner)) orphans.push_back(entity);
        }
        destroy(orphans);
    }

    World& world_;
    ModelLibrary& library_;
    ModelCost shown_;  ///< by all models so far
};

void load_models(World& world) { ModelLoader(world).run(); }

}  // namespace sl
