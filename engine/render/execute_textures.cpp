// SPDX-License-Identifier: MIT
// The executor's textures: transient ones are reused as soon as their last reader has run, persistent ones keep their
// name, and framebuffers are made once per set of attachments.
#include <algorithm>
#include <cstring>

#include "engine/render/execute.h"

namespace sl {

void Executor::allocate(const FrameGraph& graph, const PassRecord& pass) {
    const auto ensure = [&](const ResourceId& id) {
        if (!id) return;
        const ResourceRecord& resource = graph.resources()[id.index];
        if (resource.is_buffer) {
            if (resource.lifetime == Lifetime::transient) live_buffers_[id.index].reserve(resource.buffer_bytes, resource.name.c_str());
            if (resource.lifetime == Lifetime::persistent) persistent_buffers_[resource.name].reserve(resource.buffer_bytes, resource.name.c_str());
            return;
        }
        if (resource.lifetime == Lifetime::persistent) {
            Pooled& pooled = persistent_[resource.name];
            if (!pooled.texture || !(pooled.texture->desc() == resource.image)) {
                if (pooled.texture) forget_framebuffers_of(pooled.texture->id());
                pooled.texture = std::make_unique<gl::Texture>(resource.image, resource.name.c_str());
            }
            pooled.last_frame = frame_;
            return;
        }
        if (resource.lifetime == Lifetime::external || live_textures_.contains(id.index)) return;
        const auto reusable = std::ranges::find_if(free_textures_, [&](const Pooled& p) { return p.texture->desc() == resource.image; });
        if (reusable != free_textures_.end()) {
            live_textures_[id.index] = std::move(reusable->texture);
            free_textures_.erase(reusable);
        } else {
            live_textures_[id.index] = std::make_unique<gl::Texture>(resource.image, resource.name.c_str());
        }
    };
    for (const Target& target : pass.targets) ensure(target.image);
    ensure(pass.depth.image);
    for (const ImageStore& store : pass.stores) ensure(store.image);
    for (const ImageRead& read : pass.reads) ensure(read.image);
    for (const StorageUse& use : pass.storage) ensure(use.buffer);
}

void Executor::release(const FrameGraph& graph, const Step& step) {
    for (const std::uint32_t index : step.last_use) {
        if (graph.resources()[index].is_buffer) continue;
        const auto live = live_textures_.find(index);
        if (live == live_textures_.end()) continue;
        free_textures_.push_back({std::move(live->second), frame_});
        live_textures_.erase(live);
    }
}

void Executor::forget_framebuffers_of(GLuint texture) {
    std::erase_if(framebuffers_, [&](const auto& entry) {
        const bool uses = std::ranges::any_of(entry.first, [&](const auto& attachment) { return attachment.first == texture; });
        if (uses) glDeleteFramebuffers(1, &entry.second);
        return uses;
    });
}

GLuint Executor::native(const FrameGraph& graph, const ResourceId& id) const {
    const ResourceRecord& resource = graph.resources()[id.index];
    switch (resource.lifetime) {
        case Lifetime::external: return resource.native;
        case Lifetime::persistent: {
            if (resource.is_buffer) {
                const auto found = persistent_buffers_.find(resource.name);
                return found != persistent_buffers_.end() ? found->second.id() : 0;
            }
            const auto found = persistent_.find(resource.name);
            return found != persistent_.end() ? found->second.texture->id() : 0;
        }
        case Lifetime::transient: break;
    }
    if (resource.is_buffer) {
        const auto found = live_buffers_.find(id.index);
        return found != live_buffers_.end() ? found->second.id() : 0;
    }
    const auto found = live_textures_.find(id.index);
    return found != live_textures_.end() ? found->second->id() : 0;
}

GLuint Executor::framebuffer(const FrameGraph& graph, const PassRecord& pass) {
    FramebufferKey key;
    for (const Target& target : pass.targets) key.emplace_back(native(graph, target.image), target.layer);
    key.emplace_back(pass.depth.image ? native(graph, pass.depth.image) : 0, pass.depth.layer);
    GLuint& id = framebuffers_[key];
    if (id != 0) return id;
    glCreateFramebuffers(1, &id);
    const auto attach = [&](GLenum point, const Target& target) {
        const bool layered = graph.resources()[target.image.index].image.layers > 0;
        const GLuint texture = native(graph, target.image);
        layered ? glNamedFramebufferTextureLayer(id, point, texture, 0, static_cast<GLint>(target.layer))
                : glNamedFramebufferTexture(id, point, texture, 0);
    };
    std::vector<GLenum> points;
    for (const Target& target : pass.targets) {
        points.push_back(static_cast<GLenum>(GL_COLOR_ATTACHMENT0 + points.size()));
        attach(points.back(), target);
    }
    if (pass.depth.image) attach(GL_DEPTH_ATTACHMENT, pass.depth);
    if (points.empty()) {
        glNamedFramebufferDrawBuffer(id, GL_NONE);
    } else {
        glNamedFramebufferDrawBuffers(id, static_cast<GLsizei>(points.size()), points.data());
    }
    const GLenum status = glCheckNamedFramebufferStatus(id, GL_FRAMEBUFFER);
    CHECK(status == GL_FRAMEBUFFER_COMPLETE, "pass '{}': its targets make no complete framebuffer (0x{:x})", pass.name, status);
    return id;
}

GLuint Executor::texture(const FrameGraph& graph, ImageId image) const { return native(graph, image); }

const gl::Texture& Executor::readable(const FrameGraph& graph, ImageId image) const {
    const ResourceRecord& resource = graph.resources()[image.index];
    if (resource.lifetime == Lifetime::persistent) return *persistent_.at(resource.name).texture;
    const auto found = live_textures_.find(image.index);
    CHECK(found != live_textures_.end(), "'{}' was not wanted, so it is gone", resource.name);
    return *found->second;
}

std::vector<float> Executor::read(const FrameGraph& graph, ImageId image, std::uint32_t layer) const { return readable(graph, image).read(layer); }

std::vector<float> Executor::read_texel(const FrameGraph& graph, ImageId image, uvec2 texel, std::uint32_t layer) const {
    return readable(graph, image).read_texel(texel, layer);
}

float Executor::read_number(const std::string& buffer) const {
    const auto found = persistent_buffers_.find(buffer);
    CHECK(found != persistent_buffers_.end(), "there is no persistent buffer '{}'", buffer);
    float number = 0.0f;
    std::memcpy(&number, found->second.read(sizeof number).data(), sizeof number);
    return number;
}

std::uint64_t Executor::texture_bytes() const {
    std::uint64_t bytes = 0;
    const auto add = [&](const gl::Texture& texture) {
        const TextureDesc& desc = texture.desc();
        bytes += std::uint64_t{desc.width} * desc.height * std::max(desc.layers, 1u) * bytes_per_pixel(desc.format);
    };
    for (const Pooled& pooled : free_textures_) add(*pooled.texture);
    for (const auto& [index, texture] : live_textures_) add(*texture);
    for (const auto& [name, pooled] : persistent_) add(*pooled.texture);
    return bytes;
}

}  // namespace sl
