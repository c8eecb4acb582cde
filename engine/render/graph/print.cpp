// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <set>

#include "engine/render/graph/frame_graph.h"

namespace sl {

namespace {

std::string label(const ResourceRecord& resource) {
    if (resource.is_buffer) return resource.name;
    const TextureDesc& desc = resource.image;
    return desc.layers > 0 ? fmt::format("{} {}x{}x{}", resource.name, desc.width, desc.height, desc.layers)
                           : fmt::format("{} {}x{}", resource.name, desc.width, desc.height);
}

}  // namespace

FrameGraph::PassImages FrameGraph::images_of(const PassRecord& pass) const {
    PassImages images;
    for (const ImageRead& read : pass.reads) images.reads.push_back(resources_[read.image.index].name);
    for (const StorageUse& use : pass.storage) {
        (use.written ? images.writes : images.reads).push_back(resources_[use.buffer.index].name);
    }
    for (const ImageStore& store : pass.stores) images.writes.push_back(label(resources_[store.image.index]));
    for (const Target& target : pass.targets) images.writes.push_back(label(resources_[target.image.index]));
    if (pass.depth.image) images.writes.push_back(label(resources_[pass.depth.image.index]));
    return images;
}

std::string FrameGraph::table(std::span<const Step> steps) const {
    std::string text = fmt::format("{:<4}{:<22}  {:<46}  {}\n", "#", "pass", "writes", "reads");
    int number = 0;
    for (const Step& step : steps) {
        const PassRecord& pass = passes_[static_cast<std::size_t>(step.pass)];
        const PassImages images = images_of(pass);
        text += fmt::format("{:<4}{:<22}  {:<46}  {}\n", ++number, pass.name, fmt::format("{}", fmt::join(images.writes, ", ")),
                            fmt::join(images.reads, ", "));
    }
    return text;
}

std::string FrameGraph::mermaid(std::span<const Step> steps) const {
    std::string text = "flowchart LR\n";
    std::set<std::string> edges;
    for (const Step& step : steps) {
        const PassRecord& pass = passes_[static_cast<std::size_t>(step.pass)];
        const auto arrow = [&](const ResourceId& id, bool made) {
            const ResourceRecord& resource = resources_[id.index];
            const std::string image = fmt::format("r{}([\"{}\"])", id.index, label(resource));
            const std::string box = fmt::format("p{}[\"{}\"]", step.pass, pass.name);
            edges.insert(made ? fmt::format("    {} --> {}\n", box, image) : fmt::format("    {} --> {}\n", image, box));
        };
        for (const ImageRead& read : pass.reads) arrow(read.image, false);
        for (const StorageUse& use : pass.storage) arrow(use.buffer, use.written);
        // Adding to an image needs what was in it.
        for (const ImageStore& store : pass.stores) {
            arrow(store.image, false);
            arrow(store.image, true);
        }
        for (const Target& target : pass.targets) {
            if (target.load == Load::keep) arrow(target.image, false);
            arrow(target.image, true);
        }
        if (pass.depth.image) arrow(pass.depth.image, true);
    }
    for (const std::string& edge : edges) text += edge;
    return text;
}

}  // namespace sl
