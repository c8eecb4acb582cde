// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engine/render/graph/frame_graph.h"

namespace sl {

namespace {

/// Calls visit(id, reads_old, made) for every resource that a pass touches. reads_old: what was in it before matters;
/// made: the pass makes this version.
template <class Visit>
void each_use(const PassRecord& pass, Visit&& visit) {
    for (const ImageRead& read : pass.reads) visit(read.image, true, false);
    for (const StorageUse& use : pass.storage) visit(use.buffer, !use.written, use.written);
    for (const ImageStore& store : pass.stores) visit(store.image, true, true);
    for (const Target& target : pass.targets) visit(target.image, true, true);
    if (pass.depth.image) visit(pass.depth.image, true, true);
}

}  // namespace

std::vector<Step> FrameGraph::compile() {
    // Walk backwards: a pass is needed when it is kept, makes a wanted image, or makes something a needed pass uses.
    // A target counts as used by its own writer: other layers, or what a blend adds to, were made by earlier passes.
    std::vector<char> needed(passes_.size(), 0);
    std::vector<char> resource_needed(resources_.size(), 0);
    for (const std::uint32_t resource : wanted_) resource_needed[resource] = 1;
    for (std::size_t i = passes_.size(); i-- > 0;) {
        bool need = passes_[i].keep;
        each_use(passes_[i], [&](const ResourceId& id, bool, bool made) { need |= made && resource_needed[id.index] != 0; });
        needed[i] = need;
        if (need) {
            each_use(passes_[i], [&](const ResourceId& id, bool, bool) { resource_needed[id.index] = 1; });
        }
    }

    std::vector<Step> steps;
    std::vector<int> last_step(resources_.size(), -1);
    for (std::size_t i = 0; i < passes_.size(); ++i) {
        if (needed[i] == 0) continue;
        each_use(passes_[i], [&](const ResourceId& id, bool, bool) { last_step[id.index] = static_cast<int>(steps.size()); });
        steps.push_back({static_cast<int>(i), {}});
    }
    for (std::uint32_t resource = 0; resource < resources_.size(); ++resource) {
        const bool reusable = resources_[resource].lifetime == Lifetime::transient && !wanted(resource);
        if (reusable && last_step[resource] >= 0) {
            steps[static_cast<std::size_t>(last_step[resource])].last_use.push_back(resource);
        }
    }
    return steps;
}

void FrameGraph::commit(std::span<const Step> steps) {
    for (const PendingKey& pending : pending_) {
        const ResourceRecord& resource = resources_[pending.resource];
        const bool written = std::ranges::any_of(steps, [&](const Step& step) {
            const PassRecord& pass = passes_[static_cast<std::size_t>(step.pass)];
            const auto hits = [&](const Target& target) {
                return target.image.index == pending.resource && target.layer == pending.layer;
            };
            return hits(pass.depth) || std::ranges::any_of(pass.targets, hits) ||
                   std::ranges::any_of(pass.stores, [&](const auto& s) { return s.image.index == pending.resource; }) ||
                   std::ranges::any_of(pass.storage, [&](const auto& s) { return s.written && s.buffer.index == pending.resource; });
        });
        if (!written) continue;
        auto& state = states_->find(resource);
        state.keys[pending.layer] = pending.key;
        state.last_frame = states_->frame;
    }
    ++states_->frame;
}

}  // namespace sl
