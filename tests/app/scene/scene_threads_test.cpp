// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/block_clipping.h"
#include "app/scene/scene.h"

#include <QTest>

#include <atomic>
#include <thread>

#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/mixed_windows.h"
#include "tests/test_class.h"

namespace scene_scene_threads_test {

using namespace app;

/// Background work examines a copy of the lines.
class SceneThreadsTest : public QObject {
    Q_OBJECT

private slots:
    void readersOfACopyWhileTheDrawingIsEdited()
    {
        Sheet sheet;
        for (int i = 0; i < 2000; ++i) {
            Shape line;
            line.paths = {{{double(i), 0}, {{{double(i), 5}}}}};
            sheet.shapes.push_back(std::move(line));
        }
        EditedDocument document;
        const Scene scene(document);
        ::load(document, sheet);
        const auto all = segmentsOf(scene.lines());
        std::vector<std::jthread> readers;
        for (int i = 0; i < 4; ++i)
            readers.emplace_back([lines = scene.lines(), &all] {
                for (int round = 0; round < 20; ++round)
                    if (segmentsOf(SceneLines(lines)) != all)
                        qFatal("the copy has changed");
            });
        for (int i = 0; i < 200; ++i) {
            ::splice(document, std::size_t(i), 2, {sheet.shapes[std::size_t(i)]});
            QCOMPARE(scene.lines().size(), all.size() - std::size_t(i) - 1);
        }
    }
    // As SceneClipping does, but with threads that ThreadSanitizer knows: it does not see how Qt
    // hands work to those of a pool.
    void blocksAreClippedAtTheSamePreparedRegion()
    {
        MixedWindows mixed(3);
        Sheet sheet;
        for (int i = 0; i < 20'000; ++i) {
            const auto [a, b] = mixed.line();
            Shape line;
            line.paths = {{{a, {{b}}}}};
            sheet.shapes.push_back(std::move(line));
        }
        EditedDocument document;
        const Scene scene(document);
        ::load(document, sheet);
        const auto& blocks = scene.lines().blocks();
        QVERIFY(blocks.size() > 3);
        const ClipRegion region = regionOf(mixed.windows(3, Mixed::Any), 0.001);
        BlockClipping first;
        first.start(region, clipping::exactAlgorithm().corrected.clipAll, {});
        const auto visibleIn = [&] {
            BlockClipping clipping;
            clipping.startAs(first);
            for (const auto& block : blocks) {
                std::vector<Remains> remains(block->chunks.size());
                SceneFrame::Block frame{&*block, 0, 0, remains, {}};
                clipping.clip(frame, remains);
            }
            return clipping.visible();
        };
        std::atomic<std::size_t> visible = 0;
        std::vector<std::jthread> threads;
        for (int i = 0; i < 4; ++i)
            threads.emplace_back([&] { visible += visibleIn(); });
        threads.clear();
        QCOMPARE(visible.load(), 4 * visibleIn());
        QVERIFY(visible > 0);
    }
};

} // namespace scene_scene_threads_test

TEST_CLASS(scene_scene_threads_test::SceneThreadsTest, None)
#include "tests/app/scene/scene_threads_test.moc"
