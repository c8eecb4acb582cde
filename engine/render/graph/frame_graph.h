// SPDX-License-Identifier: MIT
#pragma once

#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>

#include "engine/core/check.h"
#include "engine/render/graph/pass_record.h"

namespace sl {

class FrameGraph;

/// Declares one pass. Each call both declares the edge and binds by the shader's own name.
class PassBuilder {
  public:
    /// The image that a sampler of the shader reads.
    PassBuilder& read(std::string_view sampler, ImageId image, Sampling sampling = Sampling::nearest);
    /// The buffer behind a storage block that the shader reads.
    PassBuilder& storage(std::string_view block, BufferId buffer);
    /// The buffer behind a storage block that the shader writes; the old handle is retired.
    [[nodiscard]] BufferId write_storage(std::string_view block, BufferId buffer);

    /// The bytes of one uniform block; `value` is a struct of shader/shared.
    template <class T>
    PassBuilder& params(std::string_view block, const T& value) {
        static_assert(std::is_trivially_copyable_v<T>);
        return add_params(block, std::as_bytes(std::span(&value, 1)));
    }

    /// Makes a transient image named like the shader's output and writes it.
    [[nodiscard]] ImageId create(std::string_view output, const TextureDesc& desc, Load load = Load::discard,
                                 std::array<float, 4> clear = {});
    /// Writes an existing image (one layer); the old handle is retired.
    [[nodiscard]] ImageId write(std::string_view output, ImageId image, Load load, std::uint32_t layer = 0,
                                std::array<float, 4> clear = {});
    /// Depth-tests and writes; Load::clear clears to 0, which is infinitely far.
    [[nodiscard]] ImageId depth(ImageId image, Load load, std::uint32_t layer = 0);
    /// Image written by a compute shader through imageStore.
    [[nodiscard]] ImageId store(std::string_view name, ImageId image);

    /// What a geometry pass draws, in this order.
    PassBuilder& draws(DrawList list);
    /// Work groups of a compute pass.
    PassBuilder& dispatch(std::uint32_t x, std::uint32_t y = 1, std::uint32_t z = 1);
    /// As many work groups as hold `items` invocations, spread over two dimensions where one is too short for them; the
    /// shader counts with lib/linear_index.glsl, and leaves what is past the last item.
    PassBuilder& dispatch_items(std::uint32_t items, std::uint32_t group_size);
    /// Outputs are added to what the targets hold.
    PassBuilder& blend_add();
    /// Triangles are drawn from behind too.
    PassBuilder& two_sided();
    /// Moves depths away from the eye by so much of their slope: what a map of depths is compared with does not shadow itself then.
    PassBuilder& depth_bias(float slope);
    /// Runs even when nobody in this frame reads what it writes.
    PassBuilder& keep();

  private:
    friend class FrameGraph;
    PassBuilder(FrameGraph& graph, int pass) : graph_(graph), pass_(pass) {}
    PassBuilder& add_params(std::string_view block, std::span<const std::byte> bytes);
    PassRecord& record();

    FrameGraph& graph_;
    int pass_;
};

/// One step of a compiled frame: a pass, and which resources end their life after it.
struct Step {
    int pass = 0;
    std::vector<std::uint32_t> last_use;  ///< transient resources that may be reused after this step
};

/// One frame's passes and images, as data. Built anew each frame; holds no GL.
class FrameGraph {
  public:
    /// `states` must outlive it, and is carried from frame to frame.
    explicit FrameGraph(PersistentStates& states) : states_(&states) {}

    /// Passes added from now on belong to this part of the frame; empty: to none.
    void group(std::string_view name) { group_ = name; }
    /// A pass that shades every pixel of its targets once. Shaders are files, relative to a shader folder; they get `in vec2 ndc`.
    PassBuilder fullscreen(std::string_view name, std::string_view fragment);
    /// A pass of a compute shader; say with dispatch how much of it runs.
    PassBuilder compute(std::string_view name, std::string_view shader);
    /// A pass that draws meshes; say with draws which.
    PassBuilder geometry(std::string_view name, std::string_view vertex, std::string_view fragment);

    /// A transient image that nobody has written yet.
    ImageId create(std::string_view name, const TextureDesc& desc);
    /// A transient buffer that nobody has written yet.
    BufferId create_buffer(std::string_view name, std::uint64_t bytes);
    /// A GL texture of somebody else, who keeps it alive until the frame has run.
    ImageId import_image(std::string_view name, const TextureDesc& desc, std::uint32_t native);
    /// The same of a GL buffer.
    BufferId import_buffer(std::string_view name, std::uint64_t bytes, std::uint32_t native);
    /// An image that survives frames under its name.
    ImageId persistent(std::string_view name, const TextureDesc& desc);
    /// A buffer that survives frames under its name.
    BufferId persistent_buffer(std::string_view name, std::uint64_t bytes);
    /// Whether a layer of a persistent image (or a buffer: layer 0) must be drawn: its contents were not made from `key`. Remembers that they
    /// will be, once a pass that writes the layer has run.
    bool needs_redraw(ResourceId resource, std::uint32_t layer, std::uint64_t key);
    /// What a layer of a persistent image was last made from; 0: of nothing.
    std::uint64_t drawn_key(ResourceId resource, std::uint32_t layer) const;
    /// Last frame's and this frame's image under one name; `valid` is false in the first frame and after a resize.
    struct History {
        ImageId previous, current;
        bool valid = false;
    };
    /// What is written into `current` is `previous` in the next frame.
    History history(std::string_view name, const TextureDesc& desc);
    /// A 1×1 black image: what a shader reads where a scene has nothing to give.
    ImageId black();
    /// The newest version of the image called `name`; none when there is no such image.
    ImageId find_image(std::string_view name) const;

    /// Marks an image as wanted from outside: what makes it is kept, and it stays readable until the next frame.
    void want(ImageId image);

    /// Drops passes that nobody needs and settles lifetimes. Registration order is kept: handles only point backwards.
    std::vector<Step> compile();
    /// Tells the persistent images what they now hold. Called once the compiled steps have run.
    void commit(std::span<const Step> steps);

    const std::vector<PassRecord>& passes() const { return passes_; }
    const std::vector<ResourceRecord>& resources() const { return resources_; }
    bool wanted(std::uint32_t resource) const;
    PersistentStates& states() { return *states_; }

    /// What a pass reads and writes, for people.
    struct PassImages {
        std::vector<std::string> reads, writes;
    };
    PassImages images_of(const PassRecord& pass) const;
    /// The compiled frame for people (--print-graph).
    std::string table(std::span<const Step> steps) const;
    std::string mermaid(std::span<const Step> steps) const;

  private:
    friend class PassBuilder;
    PassBuilder add_pass(std::string_view name, PassKind kind, ProgramDesc program);
    ResourceId add_resource(ResourceRecord record);
    void check_current(ResourceId id, int pass, const char* verb) const;
    ResourceId next_version(ResourceId id, int pass);

    struct PendingKey {
        std::uint32_t resource, layer;
        std::uint64_t key;
    };
    PersistentStates* states_;
    std::vector<PassRecord> passes_;
    std::vector<ResourceRecord> resources_;
    std::vector<std::uint32_t> wanted_;
    std::vector<PendingKey> pending_;
    ImageId black_;
    std::string group_;
};

}  // namespace sl
