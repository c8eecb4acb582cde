// SPDX-License-Identifier: MIT
#include "engine/render/graph/frame_graph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sl {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr TextureDesc screen{.width = 64, .height = 32, .format = Format::rgba32f};

std::vector<std::string> names(const FrameGraph& graph, const std::vector<Step>& steps) {
    std::vector<std::string> result;
    for (const Step& step : steps) result.push_back(graph.passes()[static_cast<std::size_t>(step.pass)].name);
    return result;
}

/// One executor-less frame: the caller's passes, compiled and committed.
template <class Build>
std::vector<std::string> run_frame(PersistentStates& states, Build&& build) {
    FrameGraph graph(states);
    build(graph);
    const std::vector<Step> steps = graph.compile();
    graph.commit(steps);
    return names(graph, steps);
}

TEST(FrameGraph, KeepsOnlyWhatSomebodyAskedFor) {
    PersistentStates states;
    FrameGraph graph(states);
    const ImageId lit = graph.fullscreen("light", "l.frag").create("lit", screen);
    (void)graph.fullscreen("unused", "u.frag").create("nobody", screen);
    auto shown = graph.fullscreen("show", "s.frag");
    shown.read("lit", lit);
    graph.want(shown.create("final", screen));
    EXPECT_THAT(names(graph, graph.compile()), ElementsAre("light", "show"));
}

TEST(FrameGraph, WithoutAnyWishThereIsNoPass) {
    PersistentStates states;
    FrameGraph graph(states);
    (void)graph.fullscreen("light", "l.frag").create("lit", screen);
    EXPECT_THAT(graph.compile(), IsEmpty());
}

TEST(FrameGraph, AKeptPassBringsWhatItReads) {
    PersistentStates states;
    FrameGraph graph(states);
    const ImageId image = graph.fullscreen("make", "m.frag").create("image", screen);
    auto kept = graph.fullscreen("kept", "k.frag");
    kept.read("image", image).keep();
    (void)kept.create("out", screen);
    EXPECT_THAT(names(graph, graph.compile()), ElementsAre("make", "kept"));
}

TEST(FrameGraph, EarlierWritersOfABlendedImageStay) {
    PersistentStates states;
    FrameGraph graph(states);
    ImageId sum = graph.fullscreen("first", "a.frag").create("sum", screen, Load::clear);
    auto second = graph.fullscreen("second", "a.frag");
    sum = second.blend_add().write("sum", sum, Load::keep);
    graph.want(sum);
    EXPECT_THAT(names(graph, graph.compile()), ElementsAre("first", "second"));
}

TEST(FrameGraph, BuffersCarryDependencies) {
    PersistentStates states;
    FrameGraph graph(states);
    const BufferId list = graph.compute("list", "l.comp").write_storage("Pixels", graph.create_buffer("pixels", 64));
    auto pass = graph.fullscreen("use", "u.frag");
    pass.storage("Pixels", list);
    graph.want(pass.create("final", screen));
    EXPECT_THAT(names(graph, graph.compile()), ElementsAre("list", "use"));
}

TEST(FrameGraph, AnImageMayBeReusedOnlyAfterItsLastReader) {
    PersistentStates states;
    FrameGraph graph(states);
    const ImageId a = graph.fullscreen("a", "a.frag").create("a", screen);
    auto b = graph.fullscreen("b", "b.frag");
    b.read("a", a);
    const ImageId b_image = b.create("b", screen);
    auto c = graph.fullscreen("c", "c.frag");
    c.read("a", a).read("b", b_image);
    graph.want(c.create("c", screen));
    const std::vector<Step> steps = graph.compile();
    ASSERT_EQ(steps.size(), 3u);
    EXPECT_THAT(steps[0].last_use, IsEmpty());
    EXPECT_THAT(steps[1].last_use, IsEmpty());
    EXPECT_THAT(steps[2].last_use, ElementsAre(a.index, b_image.index)) << "the wanted image stays, the others end here";
}

TEST(FrameGraph, UnchangedPersistentLayersAreNotDrawnAgain) {
    PersistentStates states;
    const TextureDesc maps{.width = 8, .height = 8, .layers = 2, .format = Format::depth32f};
    const auto frame = [&](std::uint64_t first, std::uint64_t second) {
        return run_frame(states, [&](FrameGraph& graph) {
            ImageId shadow = graph.persistent("shadow", maps);
            const std::uint64_t keys[] = {first, second};
            for (std::uint32_t layer = 0; layer < 2; ++layer) {
                if (graph.needs_redraw(shadow, layer, keys[layer])) {
                    shadow = graph.geometry(fmt::format("shadow_{}", layer), "s.vert", "s.frag").depth(shadow, Load::clear, layer);
                }
            }
            auto light = graph.fullscreen("light", "l.frag");
            light.read("shadow", shadow);
            graph.want(light.create("lit", screen));
        });
    };
    EXPECT_THAT(frame(1, 2), ElementsAre("shadow_0", "shadow_1", "light"));
    EXPECT_THAT(frame(1, 2), ElementsAre("light"));
    EXPECT_THAT(frame(1, 3), ElementsAre("shadow_1", "light"));
}

TEST(FrameGraph, APersistentBufferIsMadeOncePerKeyAndSize) {
    PersistentStates states;
    const auto frame = [&](std::uint64_t key, std::uint64_t bytes) {
        return run_frame(states, [&](FrameGraph& graph) {
            BufferId list = graph.persistent_buffer("list", bytes);
            if (graph.needs_redraw(list, 0, key)) list = graph.compute("fill", "f.comp").write_storage("List", list);
            auto use = graph.fullscreen("use", "u.frag");
            use.storage("List", list);
            graph.want(use.create("colour", screen));
        });
    };
    EXPECT_THAT(frame(1, 64), ElementsAre("fill", "use"));
    EXPECT_THAT(frame(1, 64), ElementsAre("use"));
    EXPECT_THAT(frame(2, 64), ElementsAre("fill", "use"));
    EXPECT_THAT(frame(2, 128), ElementsAre("fill", "use")) << "another size has forgotten";
}

TEST(FrameGraph, PassesKnowWhichPartOfTheFrameAskedForThem) {
    PersistentStates states;
    FrameGraph graph(states);
    (void)graph.fullscreen("before", "b.frag");
    graph.group("part");
    (void)graph.fullscreen("within", "w.frag");
    graph.group({});
    (void)graph.fullscreen("after", "a.frag");
    std::vector<std::string> groups;
    for (const PassRecord& pass : graph.passes()) groups.push_back(pass.group);
    EXPECT_THAT(groups, ElementsAre("", "part", ""));
}

TEST(FrameGraph, AMapThatNobodyReadIsStillToBeDrawnLater) {
    PersistentStates states;
    const auto frame = [&](bool read) {
        return run_frame(states, [&](FrameGraph& graph) {
            ImageId map = graph.persistent("map", screen);
            if (graph.needs_redraw(map, 0, 7)) map = graph.fullscreen("draw", "d.frag").write("map", map, Load::clear);
            auto use = graph.fullscreen("use", "u.frag");
            if (read) use.read("map", map);
            graph.want(use.create("final", screen));
        });
    };
    EXPECT_THAT(frame(false), ElementsAre("use"));
    EXPECT_THAT(frame(true), ElementsAre("draw", "use"));
    EXPECT_THAT(frame(true), ElementsAre("use"));
}

TEST(FrameGraph, AnotherSizeForgetsWhatAPersistentImageHeld) {
    PersistentStates states;
    const auto draws = [&](std::uint32_t size) {
        FrameGraph graph(states);
        ImageId map = graph.persistent("map", {.width = size, .height = size, .format = Format::r32f});
        const bool redraw = graph.needs_redraw(map, 0, 7);
        if (redraw) map = graph.fullscreen("draw", "d.frag").write("map", map, Load::clear);
        graph.want(map);
        graph.commit(graph.compile());
        return redraw;
    };
    EXPECT_TRUE(draws(8));
    EXPECT_FALSE(draws(8));
    EXPECT_TRUE(draws(16));
}

TEST(FrameGraph, HistoryIsValidFromTheSecondFrameAndNotAfterAResize) {
    PersistentStates states;
    const auto frame = [&](std::uint32_t width) {
        FrameGraph graph(states);
        FrameGraph::History history = graph.history("past", {.width = width, .height = 4, .format = Format::rgba8});
        auto pass = graph.fullscreen("blend", "b.frag");
        pass.read("past", history.previous);
        graph.want(pass.write("present", history.current, Load::discard));
        graph.commit(graph.compile());
        return history.valid;
    };
    EXPECT_FALSE(frame(8));
    EXPECT_TRUE(frame(8));
    EXPECT_TRUE(frame(8));
    EXPECT_FALSE(frame(9));
    EXPECT_TRUE(frame(9));
}

TEST(FrameGraph, BlackIsDrawnOnceHoweverManyAsk) {
    PersistentStates states;
    const auto frame = [&] {
        return run_frame(states, [](FrameGraph& graph) {
            const ImageId black = graph.black();
            EXPECT_EQ(graph.black(), black) << "who asked first must not hold an old version";
            auto use = graph.fullscreen("use", "u.frag");
            use.read("image", black);
            graph.want(use.create("final", screen));
        });
    };
    EXPECT_EQ(frame().size(), 2u);
    EXPECT_THAT(frame(), ElementsAre("use"));
}

TEST(FrameGraph, TableAndMermaidNamePassesAndImages) {
    PersistentStates states;
    FrameGraph graph(states);
    const ImageId lit = graph.fullscreen("light", "l.frag").create("lit", screen);
    auto show = graph.fullscreen("show", "s.frag");
    show.read("lit", lit);
    graph.want(show.create("final", screen));
    const std::vector<Step> steps = graph.compile();
    EXPECT_THAT(graph.table(steps), HasSubstr("lit 64x32"));
    EXPECT_THAT(graph.table(steps), HasSubstr("show"));
    EXPECT_THAT(graph.mermaid(steps), HasSubstr("flowchart LR"));
    EXPECT_THAT(graph.mermaid(steps), HasSubstr("p0[\"light\"] --> r0([\"lit 64x32\"])"));
    EXPECT_THAT(graph.mermaid(steps), HasSubstr("r0([\"lit 64x32\"]) --> p1[\"show\"]"));
}

TEST(FrameGraphDeathTest, ARetiredHandleStopsWithBothPasses) {
    PersistentStates states;
    FrameGraph graph(states);
    const ImageId old = graph.fullscreen("make", "m.frag").create("image", screen);
    (void)graph.fullscreen("overwrite", "o.frag").write("image", old, Load::keep);
    EXPECT_DEATH(graph.fullscreen("late", "l.frag").read("image", old), "pass 'late'.*'image'.*pass 'overwrite'");
    EXPECT_DEATH((void)graph.fullscreen("late", "l.frag").write("image", old, Load::keep), "pass 'late'.*pass 'overwrite'");
}

TEST(FrameGraphDeathTest, APassCannotReadWhatALaterOneMakes) {
    PersistentStates states;
    FrameGraph graph(states);
    auto early = graph.fullscreen("early", "e.frag");
    const ImageId image = graph.fullscreen("later", "l.frag").create("image", screen);
    EXPECT_DEATH(early.read("image", image), "pass 'early'.*pass 'later'.*ask for it first");
}

}  // namespace
}  // namespace sl
