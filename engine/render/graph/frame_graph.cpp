// SPDX-License-Identifier: MIT
#include "engine/render/graph/frame_graph.h"

#include <algorithm>

namespace sl {

PersistentStates::State& PersistentStates::find(const ResourceRecord& resource) {
    State& state = states_[resource.name];
    if (!(state.image == resource.image) || state.buffer_bytes != resource.buffer_bytes || state.keys.empty()) {
        state.image = resource.image;
        state.buffer_bytes = resource.buffer_bytes;
        state.keys.assign(std::max(resource.image.layers, 1u), 0);
        state.last_frame = 0;
    }
    return state;
}

PassBuilder FrameGraph::add_pass(std::string_view name, PassKind kind, ProgramDesc program) {
    PassRecord& pass = passes_.emplace_back();
    pass.name = name;
    pass.group = group_;
    pass.kind = kind;
    pass.program = std::move(program);
    return {*this, static_cast<int>(passes_.size()) - 1};
}

PassBuilder FrameGraph::fullscreen(std::string_view name, std::string_view fragment) {
    return add_pass(name, PassKind::fullscreen,
                    {.vertex = "lib/fullscreen.vert", .fragment = std::string(fragment), .compute = {}, .defines = {}});
}

PassBuilder FrameGraph::compute(std::string_view name, std::string_view shader) {
    return add_pass(name, PassKind::compute, {.vertex = {}, .fragment = {}, .compute = std::string(shader), .defines = {}});
}

PassBuilder FrameGraph::geometry(std::string_view name, std::string_view vertex, std::string_view fragment) {
    return add_pass(name, PassKind::draws,
                    {.vertex = std::string(vertex), .fragment = std::string(fragment), .compute = {}, .defines = {}});
}

ResourceId FrameGraph::add_resource(ResourceRecord record) {
    record.writers = {-1};
    resources_.push_back(std::move(record));
    return {static_cast<std::uint32_t>(resources_.size()) - 1, 0};
}

ImageId FrameGraph::create(std::string_view name, const TextureDesc& desc) {
    CHECK(desc.width > 0 && desc.height > 0, "image '{}' is {}x{}", name, desc.width, desc.height);
    ResourceRecord record;
    record.name = name;
    record.image = desc;
    return {add_resource(std::move(record))};
}

BufferId FrameGraph::create_buffer(std::string_view name, std::uint64_t bytes) {
    ResourceRecord record;
    record.name = name;
    record.is_buffer = true;
    record.buffer_bytes = bytes;
    return {add_resource(std::move(record))};
}

ImageId FrameGraph::import_image(std::string_view name, const TextureDesc& desc, std::uint32_t native) {
    const ImageId image = create(name, desc);
    resources_[image.index].lifetime = Lifetime::external;
    resources_[image.index].native = native;
    return image;
}

BufferId FrameGraph::import_buffer(std::string_view name, std::uint64_t bytes, std::uint32_t native) {
    const BufferId buffer = create_buffer(name, bytes);
    resources_[buffer.index].lifetime = Lifetime::external;
    resources_[buffer.index].native = native;
    return buffer;
}

ImageId FrameGraph::persistent(std::string_view name, const TextureDesc& desc) {
    const ImageId image = create(name, desc);
    resources_[image.index].lifetime = Lifetime::persistent;
    states_->find(resources_[image.index]);
    return image;
}

BufferId FrameGraph::persistent_buffer(std::string_view name, std::uint64_t bytes) {
    const BufferId buffer = create_buffer(name, bytes);
    resources_[buffer.index].lifetime = Lifetime::persistent;
    states_->find(resources_[buffer.index]);
    return buffer;
}

bool FrameGraph::needs_redraw(ResourceId resource, std::uint32_t layer, std::uint64_t key) {
    const ResourceRecord& record = resources_[resource.index];
    CHECK(record.lifetime == Lifetime::persistent, "'{}' does not survive frames", record.name);
    if (key == 0) key = 1;
    if (states_->find(record).keys[layer] == key) return false;
    pending_.push_back({resource.index, layer, key});
    return true;
}

std::uint64_t FrameGraph::drawn_key(ResourceId resource, std::uint32_t layer) const {
    const ResourceRecord& record = resources_[resource.index];
    CHECK(record.lifetime == Lifetime::persistent, "'{}' does not survive frames", record.name);
    return states_->find(record).keys[layer];
}

FrameGraph::History FrameGraph::history(std::string_view name, const TextureDesc& desc) {
    const bool odd = states_->frame % 2 == 1;
    const std::string even_name = fmt::format("{}:even", name);
    const std::string odd_name = fmt::format("{}:odd", name);
    History result;
    result.previous = persistent(odd ? even_name : odd_name, desc);
    result.current = persistent(odd ? odd_name : even_name, desc);
    const auto& previous = states_->find(resources_[result.previous.index]);
    result.valid = previous.keys[0] != 0 && previous.last_frame + 1 == states_->frame;
    pending_.push_back({result.current.index, 0, 1});
    return result;
}

ImageId FrameGraph::black() {
    // Once a frame: who asked before must not hold an older version.
    if (black_) return black_;
    black_ = persistent("black", {.format = Format::rgba32f});
    if (needs_redraw(black_, 0, 1)) {
        black_ = fullscreen("black", "passes/black.frag").write("black", black_, Load::clear);
    }
    return black_;
}

ImageId FrameGraph::find_image(std::string_view name) const {
    for (std::uint32_t i = 0; i < resources_.size(); ++i) {
        if (resources_[i].name == name && !resources_[i].is_buffer) return {{i, resources_[i].version}};
    }
    return {};
}

void FrameGraph::want(ImageId image) {
    check_current(image, -1, "is wanted");
    wanted_.push_back(image.index);
}

bool FrameGraph::wanted(std::uint32_t resource) const { return std::ranges::find(wanted_, resource) != wanted_.end(); }

void FrameGraph::check_current(ResourceId id, int pass, const char* verb) const {
    const std::string_view who = pass >= 0 ? std::string_view(passes_[static_cast<std::size_t>(pass)].name) : "the caller";
    CHECK(id.index < resources_.size(), "pass '{}': no such image or buffer", who);
    const ResourceRecord& record = resources_[id.index];
    if (id.version == record.version) {
        const int maker = record.writers[id.version];
        CHECK(pass < 0 || maker < pass, "pass '{}': '{}' is made by pass '{}', which was added later; ask for it first", who,
              record.name, passes_[static_cast<std::size_t>(maker)].name);
        return;
    }
    const int writer = record.writers[id.version + 1];
    CHECK(false, "pass '{}': version {} of '{}' {}, but pass '{}' has written it since; use the handle which that returned",
          who, id.version, record.name, verb, writer >= 0 ? passes_[static_cast<std::size_t>(writer)].name : "?");
}

ResourceId FrameGraph::next_version(ResourceId id, int pass) {
    check_current(id, pass, "is written");
    ResourceRecord& record = resources_[id.index];
    record.writers.push_back(pass);
    return {id.index, ++record.version};
}

PassRecord& PassBuilder::record() { return graph_.passes_[static_cast<std::size_t>(pass_)]; }

PassBuilder& PassBuilder::read(std::string_view sampler, ImageId image, Sampling sampling) {
    graph_.check_current(image, pass_, "is read");
    record().reads.push_back({std::string(sampler), image, sampling});
    return *this;
}

PassBuilder& PassBuilder::storage(std::string_view block, BufferId buffer) {
    graph_.check_current(buffer, pass_, "is read");
    record().storage.push_back({std::string(block), buffer, false});
    return *this;
}

BufferId PassBuilder::write_storage(std::string_view block, BufferId buffer) {
    const BufferId next{graph_.next_version(buffer, pass_)};
    record().storage.push_back({std::string(block), next, true});
    return next;
}

PassBuilder& PassBuilder::add_params(std::string_view block, std::span<const std::byte> bytes) {
    record().params.push_back({std::string(block), {bytes.begin(), bytes.end()}});
    return *this;
}

ImageId PassBuilder::create(std::string_view output, const TextureDesc& desc, Load load, std::array<float, 4> clear) {
    return write(output, graph_.create(output, desc), load, 0, clear);
}

ImageId PassBuilder::write(std::string_view output, ImageId image, Load load, std::uint32_t layer,
                           std::array<float, 4> clear) {
    const ImageId next{graph_.next_version(image, pass_)};
    record().targets.push_back({std::string(output), next, layer, load, clear});
    return next;
}

ImageId PassBuilder::depth(ImageId image, Load load, std::uint32_t layer) {
    const ImageId next{graph_.next_version(image, pass_)};
    record().depth = {"", next, layer, load, {}};
    record().depth_test = true;
    return next;
}

ImageId PassBuilder::store(std::string_view name, ImageId image) {
    const ImageId next{graph_.next_version(image, pass_)};
    record().stores.push_back({std::string(name), next});
    return next;
}

PassBuilder& PassBuilder::draws(DrawList list) {
    record().draws = std::move(list);
    return *this;
}

PassBuilder& PassBuilder::dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    record().groups = {x, y, z};
    return *this;
}

PassBuilder& PassBuilder::dispatch_items(std::uint32_t items, std::uint32_t group_size) {
    constexpr std::uint32_t longest = 32768;  // every OpenGL takes 65,535
    const std::uint32_t groups = items / group_size + (items % group_size != 0 ? 1 : 0);
    const std::uint32_t across = std::min(groups, longest);
    return dispatch(across, across > 0 ? (groups + across - 1) / across : 0);
}

PassBuilder& PassBuilder::blend_add() {
    record().blend_add = true;
    return *this;
}

PassBuilder& PassBuilder::two_sided() {
    record().cull_back = false;
    return *this;
}

PassBuilder& PassBuilder::depth_bias(float slope) {
    record().depth_bias_slope = slope;
    return *this;
}

PassBuilder& PassBuilder::keep() {
    record().keep = true;
    return *this;
}

}  // namespace sl
