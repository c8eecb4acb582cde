// SPDX-License-Identifier: MIT

// The test framework first: RapidCheck's header expects it.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "engine/core/field_random.h"
#include "tests/editor/edited_scene.h"

namespace sl {
namespace {

// RapidCheck reads its parameters once, when the first property runs; what the caller has set stays.
const int parameters_set = setenv("RC_PARAMS", "seed=20260101 max_success=200", 0);

/// One thing that a person does; `which` and `seed` choose among what there is.
struct Deed {
    enum class Kind { add, duplicate, remove, rename, reparent, add_component, remove_component, change, undo, redo };
    Kind kind;
    unsigned which;
    unsigned seed;
};

void showValue(const Deed& deed, std::ostream& out) {
    out << "{" << static_cast<int>(deed.kind) << ", " << deed.which << ", " << deed.seed << "}";
}

rc::Gen<std::vector<Deed>> deeds() {
    using Kind = Deed::Kind;
    const auto kinds = rc::gen::element(Kind::add, Kind::duplicate, Kind::remove, Kind::rename, Kind::reparent, Kind::add_component,
                                        Kind::remove_component, Kind::change, Kind::change, Kind::undo, Kind::undo, Kind::redo);
    return rc::gen::container<std::vector<Deed>>(
        rc::gen::build<Deed>(rc::gen::set(&Deed::kind, kinds), rc::gen::set(&Deed::which, rc::gen::arbitrary<unsigned>()),
                             rc::gen::set(&Deed::seed, rc::gen::arbitrary<unsigned>())));
}

void rename(SmallScene& scene, Entity entity, const std::string& name) {
    SceneEdit edit(scene.edited(), "rename");
    edit.set(entity, entity_part::name, name);
}

void reparent(SmallScene& scene, Entity entity, Entity parent) {
    if (!is_below(scene.app.world, parent, entity)) set_parent(scene.edited(), entity, parent);
}

void do_to_component(SmallScene& scene, Entity entity, const Deed& deed) {
    const auto types = scene.app.registry().types();
    const ComponentType& type = types[deed.seed % types.size()];
    const bool there = type.has(scene.app.world, entity);
    if (deed.kind == Deed::Kind::add_component && !there) add_component(scene.edited(), entity, type);
    if (deed.kind == Deed::Kind::remove_component && there) remove_component(scene.edited(), entity, type);
    if (deed.kind != Deed::Kind::change || !there) return;
    for (const unsigned frame : {0u, 1u, 2u}) {
        RandomFields random(deed.seed + frame);
        scene.change(entity, type.name, random);
    }
    scene.history.end_gesture();
}

void carry_out(SmallScene& scene, const Deed& deed) {
    const std::vector<Entity> all = scene.entities();
    const auto chosen = [&](unsigned number) { return all[number % all.size()]; };
    if (deed.kind == Deed::Kind::undo) return scene.undo();
    if (deed.kind == Deed::Kind::redo) return scene.redo();
    if (deed.kind == Deed::Kind::add || all.empty()) return void(add_entity(scene.edited(), {.translation = dvec3(deed.seed % 7)}));
    const Entity entity = chosen(deed.which);
    switch (deed.kind) {
        // A scene of copies of copies would take long to compare.
        case Deed::Kind::duplicate: return all.size() < 40 ? void(duplicate_entity(scene.edited(), entity)) : void();
        case Deed::Kind::remove: return delete_entity(scene.edited(), entity);
        case Deed::Kind::rename: return rename(scene, entity, fmt::format("name {}", deed.seed % 5));
        case Deed::Kind::reparent: return reparent(scene, entity, chosen(deed.seed));
        default: return do_to_component(scene, entity, deed);
    }
}

RC_GTEST_PROP(EditSequences, UndoingAllGivesTheStartAndRedoingAllTheEnd, ()) {
    const auto sequence = *deeds();
    SmallScene scene;
    const std::string start = scene.text();
    for (const Deed& deed : sequence) carry_out(scene, deed);
    while (!scene.history.undone().empty()) scene.redo();
    const std::string end = scene.text();
    while (!scene.history.done().empty()) scene.undo();
    RC_ASSERT(scene.text() == start);
    while (!scene.history.undone().empty()) scene.redo();
    RC_ASSERT(scene.text() == end);
}

RC_GTEST_PROP(EditSequences, EachStepBackAndForthMeetsTheSameScenes, ()) {
    const auto sequence = *deeds();
    SmallScene scene;
    std::map<std::size_t, std::string> by_steps{{0, scene.text()}};
    for (const Deed& deed : sequence) {
        const std::size_t before = scene.history.done().size();
        carry_out(scene, deed);
        const bool walks = deed.kind == Deed::Kind::undo || deed.kind == Deed::Kind::redo;
        const std::size_t now = scene.history.done().size();
        if (walks || now == before) {
            RC_ASSERT(scene.text() == by_steps.at(now));
        } else {
            by_steps[now] = scene.text();
        }
    }
}

}  // namespace
}  // namespace sl
