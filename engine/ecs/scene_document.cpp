// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_document.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/json_text.h"
#include "engine/core/text_file.h"

namespace sl {

using nlohmann::json;
namespace fs = std::filesystem;

namespace {

struct SceneFile {
    std::string shown;  ///< path as in messages
    fs::path path;      ///< canonical
    std::shared_ptr<const json> content;
};

SceneFile read_file(const fs::path& path, std::span<const SceneUpgrade> upgrades) {
    const std::string shown = path.string();
    json content = parse_json(without_comments(read_text_file(path, most_scene_bytes)), shown);
    upgrade_scene(content, shown, upgrades);
    constexpr std::array<std::string_view, 5> known{scene_key::version, scene_key::description, scene_key::include,
                                                    scene_key::entities, scene_key::schema};
    for (const auto& item : content.items()) {
        if (std::find(known.begin(), known.end(), item.key()) != known.end()) continue;
        fail("{}: {}", shown, no_such_name("key", item.key(), known));
    }
    return {shown, fs::canonical(path), std::make_shared<const json>(std::move(content))};
}

/// The value of a text key, or nothing where it is absent.
std::optional<std::string> find_text(const json& object, std::string_view key, std::string_view where) {
    const auto found = object.find(key);
    if (found == object.end()) return std::nullopt;
    if (!found->is_string()) fail("{}/{}: must be a text, not {}", where, key, found->type_name());
    return found->get<std::string>();
}

/// Where an include leads. It stays in the folder of the file that includes, links resolved.
fs::path included_path(const SceneFile& file, const std::string& include) {
    const std::string where =
        fmt::format("{}: /{}: '{}'", file.shown, scene_key::include, for_message(include));
    const fs::path relative(include);
    if (include.empty() || include.find('\0') != std::string::npos) fail("{} names no file", where);
    if (relative.is_absolute()) fail("{} must be relative to the file that includes it", where);
    if (std::find(relative.begin(), relative.end(), "..") != relative.end()) {
        fail("{} leaves the folder of the file that includes it", where);
    }
    std::error_code error;
    const fs::path resolved = fs::canonical(file.path.parent_path() / relative, error);
    if (error) fail("{}: there is no such file", where);
    const fs::path folder = file.path.parent_path();
    if (std::mismatch(folder.begin(), folder.end(), resolved.begin(), resolved.end()).first != folder.end()) {
        fail("{} leaves the folder of the file that includes it", where);
    }
    return fs::path(file.shown).parent_path() / relative;
}

/// The file and those it includes, outermost first.
std::vector<SceneFile> read_chain(const fs::path& path, std::span<const SceneUpgrade> upgrades) {
    std::vector<SceneFile> chain{read_file(path, upgrades)};
    while (const auto include =
               find_text(*chain.back().content, scene_key::include, chain.back().shown + ": ")) {
        const fs::path next = included_path(chain.back(), *include);
        const fs::path canonical = fs::canonical(next);
        const auto is_it = [&](const SceneFile& file) { return file.path == canonical; };
        if (std::any_of(chain.begin(), chain.end(), is_it)) {
            fail("{}: /{}: '{}' is already being read: files include each other in a circle",
                 chain.back().shown, scene_key::include, for_message(*include));
        }
        if (chain.size() > deepest_include) {
            fail("{}: /{}: more than {} files deep", chain.back().shown, scene_key::include, deepest_include);
        }
        chain.push_back(read_file(next, upgrades));
    }
    return chain;
}

/// Merges files by entity name.
class Merge {
  public:
    void add_file(const SceneFile& file) {
        const auto found = file.content->find(scene_key::entities);
        if (found == file.content->end()) return;
        if (!found->is_array()) {
            fail("{}: /{}: must be an array […], not {}", file.shown, scene_key::entities,
                 found->type_name());
        }
        read_ += found->size();
        if (read_ > most_scene_entities) {
            fail("{}: /{}: {} entities, with those of included files; {} is the limit", file.shown, scene_key::entities, read_, most_scene_entities);
        }
        std::unordered_set<std::string> names;
        const auto folder = std::make_shared<const fs::path>(fs::path(file.shown).parent_path());
        for (std::size_t i = 0; i < found->size(); ++i) {
            const SceneLayer layer{&(*found)[i], fmt::format("{}: /{}/{}", file.shown, scene_key::entities, i), folder};
            const std::string name = name_of(layer);
            if (!names.insert(name).second) {
                fail("{}/{}: there are two entities called '{}'", layer.where, scene_key::name,
                     for_message(name));
            }
            add_layer(name, layer);
        }
    }

    std::vector<SceneEntity> finish() {
        std::erase_if(entities_, [](const SceneEntity& entity) { return entity.layers.empty(); });
        by_name_.clear();
        for (std::size_t i = 0; i < entities_.size(); ++i) by_name_[entities_[i].name] = i;
        check_parents();
        return std::move(entities_);
    }

  private:
    static std::string name_of(const SceneLayer& layer) {
        if (!layer.object->is_object()) {
            fail("{}: must be an object {{…}}, not {}", layer.where, layer.object->type_name());
        }
        const auto name = find_text(*layer.object, scene_key::name, layer.where);
        if (!name || name->empty()) fail("{}: needs a \"{}\"", layer.where, scene_key::name);
        return *name;
    }

    void add_layer(const std::string& name, const SceneLayer& layer) {
        const auto known = by_name_.find(name);
        if (is_removal(layer)) {
            if (known == by_name_.end()) {
                fail("{}/{}: no included file has an entity '{}'", layer.where, scene_key::remove,
                     for_message(name));
            }
            entities_[known->second].layers.clear();
            by_name_.erase(known);
            return;
        }
        if (known == by_name_.end()) {
            by_name_[name] = entities_.size();
            entities_.push_back({.name = name, .parent = std::nullopt, .where = layer.where, .layers = {}});
        }
        SceneEntity& entity = entities_[by_name_[name]];
        entity.layers.push_back(layer);
        if (const auto parent = layer.object->find(scene_key::parent); parent != layer.object->end()) {
            entity.parent =
                parent->is_null() ? std::nullopt : find_text(*layer.object, scene_key::parent, layer.where);
            entity.where = layer.where;
        }
    }

    static bool is_removal(const SceneLayer& layer) {
        const auto remove = layer.object->find(scene_key::remove);
        if (remove == layer.object->end()) return false;
        if (!remove->is_boolean()) {
            fail("{}/{}: must be true or false, not {}", layer.where, scene_key::remove, remove->type_name());
        }
        if (*remove && layer.object->size() > 2) {
            fail("{}: an entity that is removed has no other keys than its name", layer.where);
        }
        return remove->get<bool>();
    }

    void check_parents() const {
        std::vector<std::size_t> walk(entities_.size(),
                                      entities_.size());  // from which entity it was reached
        for (std::size_t start = 0; start < entities_.size(); ++start) {
            std::size_t at = start;
            while (walk[at] == entities_.size()) {
                walk[at] = start;
                const SceneEntity& entity = entities_[at];
                if (!entity.parent) break;
                at = parent_of(entity);
                if (walk[at] == start) {
                    fail("{}/{}: '{}' hangs on itself through its parents", entity.where, scene_key::parent,
                         for_message(entity.name));
                }
            }
        }
    }

    std::size_t parent_of(const SceneEntity& entity) const {
        const auto found = by_name_.find(*entity.parent);
        if (found != by_name_.end()) return found->second;
        std::vector<std::string_view> names;
        for (const SceneEntity& known : entities_) names.push_back(known.name);
        fail("{}/{}: {}", entity.where, scene_key::parent, no_such_name("entity", *entity.parent, names));
    }

    std::vector<SceneEntity> entities_;
    std::unordered_map<std::string, std::size_t> by_name_;
    std::size_t read_ = 0;
};

}  // namespace

SceneDocument read_scene_document(const fs::path& path, std::span<const SceneUpgrade> upgrades) {
    const std::vector<SceneFile> chain = read_chain(path, upgrades);
    SceneDocument document;
    for (const SceneFile& file : chain) document.paths.emplace_back(file.shown);
    // Of each file, so that a wrong one is told wherever it stands; the outermost one's are kept.
    for (auto file = chain.rbegin(); file != chain.rend(); ++file) {
        document.description = find_text(*file->content, scene_key::description, file->shown + ": ").value_or("");
        document.schema = find_text(*file->content, scene_key::schema, file->shown + ": ").value_or("");
    }
    Merge merge;
    for (auto file = chain.rbegin(); file != chain.rend(); ++file) {
        merge.add_file(*file);
        document.files.push_back(file->content);
    }
    document.entities = merge.finish();
    return document;
}

}  // namespace sl
