// SPDX-License-Identifier: MIT
#pragma once

#include "editor/entity_parts.h"

namespace sl {

/// What a step did to one part of one entity.
struct PartChange {
    EntityKey entity = EntityKey::none;
    std::string part;
    PartValue before, after;
};

/// What people undo at once, in the order in which it was done.
struct EditStep {
    std::string label;  ///< for people: "delete lamp"
    std::vector<PartChange> changes;
};

/// All that was done to a scene in the editor, to be undone and done again without limit. Holds what changed,
/// not the world: what the game did in between stays.
class EditHistory {
  public:
    /// Remembers a step that was done just now. Steps that were undone are forgotten.
    void add(EditStep step);
    /// The same for one change of a gesture, as the dragging of a slider: the same part changed again and
    /// again is one step until the gesture ends.
    void add_to_gesture(std::string label, PartChange change);
    /// A gesture that ended where it began leaves no step.
    void end_gesture();

    /// Nothing happens where there is nothing to undo or redo.
    void undo(World& world, const ComponentRegistry& registry);
    void redo(World& world, const ComponentRegistry& registry);

    /// Labels of the steps that could be undone, the oldest first, and that could be done again, the newest
    /// undone one first.
    std::span<const EditStep> done() const { return std::span(steps_).first(done_); }
    std::span<const EditStep> undone() const { return std::span(steps_).subspan(done_); }
    /// Whether a file holds the scene as it is: none was asked for, or all since the last mark was undone.
    bool saved() const { return done_ == saved_; }
    void mark_saved() {
        end_gesture();
        saved_ = done_;
    }
    EntityKeys& keys() { return keys_; }

  private:
    void apply(const EntityParts& parts, const PartChange& change, const PartValue& value);

    EntityKeys keys_;
    std::vector<EditStep> steps_;
    std::size_t done_ = 0;
    std::optional<std::size_t> saved_ = 0;  ///< of done_; none once that state cannot be reached any more
    bool in_gesture_ = false;
};

}  // namespace sl
