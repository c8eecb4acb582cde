// SPDX-License-Identifier: MIT
#include "engine/render/reference/live_reference.h"

#include <tbb/task_arena.h>

#include <algorithm>

#include "engine/core/check.h"
#include "engine/render/scene/frame_params.h"
#include "engine/render/scene/light_map.h"

namespace sl {

namespace {

/// Rest before tracing begins, s: somebody who looks round wants frames, not rays.
constexpr double rest = 0.3;

std::uint64_t hash_of(const RenderScene& scene, uvec2 size) {
    const FrameParams frame = frame_params(scene, size.x, size.y, 0);
    std::uint64_t hash = hash_mix(hash_bytes(scene.geometry_hash(), &frame.clip_from_world, sizeof(mat4)), (std::uint64_t{size.x} << 32) | size.y);
    hash = hash_bytes(hash, &frame.sky, sizeof frame.sky);
    for (const LightParams& light : build_light_table(scene).params) hash = hash_bytes(hash, &light, sizeof light);
    return hash;
}

}  // namespace

/// A scene that nobody else writes to.
struct LiveReference::Job {
    RenderScene scene;
    MeshPool meshes;
    TextureLayers textures;
    uvec2 size;

    Job(const RenderScene& original, uvec2 size_) : scene(original), meshes(*original.meshes), size(size_) {
        scene.meshes = &meshes;
        if (original.textures != nullptr) textures = *original.textures;
        scene.textures = original.textures != nullptr ? &textures : nullptr;
    }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;
};

const Image& LiveReference::Picture::layer(std::string_view name) const {
    const auto found = std::ranges::find(layers, name, &ImageLayer::name);
    CHECK(found != layers.end(), "a reference has no layer '{}'", name);
    return found->image;
}

LiveReference::LiveReference(const TransportSettings& transport, double wanted_noise, std::uint32_t most_samples)
    : transport_(transport), wanted_noise_(wanted_noise), most_samples_(most_samples), thread_([this](const std::stop_token& stop) { work(stop); }) {}

LiveReference::~LiveReference() { stop(); }

void LiveReference::follow(const RenderScene& scene, uvec2 size, double seconds) {
    if (!scene.view || scene.meshes == nullptr) return stop();
    const std::uint64_t now = hash_of(scene, size);
    if (now != seen_) {
        stop();
        seen_ = now;
        return;
    }
    rested_ += seconds;
    if (begun_ || rested_ < rest) return;
    begun_ = true;
    const std::lock_guard lock(mutex_);
    wanted_ = std::make_shared<const Job>(scene, size);
    changed_.notify_all();
}

void LiveReference::stop() {
    begun_ = false;
    rested_ = 0.0;
    seen_ = 0;
    const std::lock_guard lock(mutex_);
    wanted_.reset();
    picture_.reset();
    problem_.clear();
}

std::shared_ptr<const LiveReference::Picture> LiveReference::picture() const {
    const std::lock_guard lock(mutex_);
    return picture_;
}

std::string LiveReference::problem() const {
    const std::lock_guard lock(mutex_);
    return problem_;
}

void LiveReference::work(const std::stop_token& stop) {
    // One processor is left to the picture that is compared.
    tbb::task_arena arena(std::max(tbb::this_task_arena::max_concurrency() - 1, 1), 1, tbb::task_arena::priority::low);
    std::shared_ptr<const Job> done;
    while (true) {
        std::shared_ptr<const Job> job;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [&] { return wanted_ != nullptr && wanted_ != done; })) return;
            job = wanted_;
        }
        arena.execute([&] { trace(job, stop); });
        done = job;
    }
}

void LiveReference::trace(const std::shared_ptr<const Job>& job, const std::stop_token& stop) {
    const auto is_wanted = [&] { return !stop.stop_requested() && wanted_ == job; };
    try {
        const PathTracer tracer(job->scene, job->size, transport_);
        Film film(job->size);
        const ReferencePlan plan{.block = {.high = job->size, .last = most_samples_}, .noise = wanted_noise_};
        trace_reference(tracer, film, plan, [&](const ReferenceProgress& progress) {
            auto picture = std::make_shared<Picture>();
            picture->layers = film.layers();
            picture->samples = progress.samples;
            picture->noise = progress.noise;
            picture->seconds = progress.seconds;
            picture->share = progress.share;
            const std::lock_guard lock(mutex_);
            if (is_wanted()) picture_ = std::move(picture);
            return is_wanted();
        });
    } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        if (is_wanted()) problem_ = error.what();
    }
}

}  // namespace sl
