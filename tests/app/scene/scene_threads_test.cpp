// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene.h"

#include <QTest>

#include <thread>

#include "tests/app/document/sheet_edits.h"
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
};

} // namespace scene_scene_threads_test

TEST_CLASS(scene_scene_threads_test::SceneThreadsTest, None)
#include "tests/app/scene/scene_threads_test.moc"
