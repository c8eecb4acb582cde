// SPDX-License-Identifier: MIT
#include "editor/edit_history.h"

#include <ranges>

namespace sl {

void EditHistory::add(EditStep step) {
    end_gesture();
    if (saved_ > done_) saved_.reset();
    steps_.resize(done_);
    steps_.push_back(std::move(step));
    ++done_;
}

void EditHistory::add_to_gesture(std::string label, PartChange change) {
    if (in_gesture_) {
        PartChange& last = steps_.back().changes.front();
        if (last.entity == change.entity && last.part == change.part) {
            last.after = std::move(change.after);
            return;
        }
    }
    add({std::move(label), {std::move(change)}});
    in_gesture_ = true;
}

void EditHistory::end_gesture() {
    if (!std::exchange(in_gesture_, false)) return;
    const PartChange& change = steps_.back().changes.front();
    if (change.before != change.after) return;
    steps_.pop_back();
    --done_;
}

void EditHistory::undo(World& world, const ComponentRegistry& registry) {
    end_gesture();
    if (done_ == 0) return;
    const EntityParts parts{world, registry, keys_};
    for (const PartChange& change : steps_[--done_].changes | std::views::reverse) {
        apply(parts, change, change.before);
    }
}

void EditHistory::redo(World& world, const ComponentRegistry& registry) {
    end_gesture();
    if (done_ == steps_.size()) return;
    const EntityParts parts{world, registry, keys_};
    for (const PartChange& change : steps_[done_++].changes) apply(parts, change, change.after);
}

void EditHistory::apply(const EntityParts& parts, const PartChange& change, const PartValue& value) {
    const Entity entity = keys_.entity_of(change.entity);
    if (change.part != entity_part::existence) {
        // The game may have destroyed it meanwhile.
        if (parts.world.alive(entity)) parts.write(entity, change.part, value);
    } else if (value) {
        keys_.give(change.entity, parts.world.create());
    } else {
        parts.world.destroy(entity);
    }
}

}  // namespace sl
