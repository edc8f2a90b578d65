// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene.h"

#include <QTest>

#include <glm/common.hpp>

#include <random>

#include "tests/app/document/kept_in.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/block_scene.h"
#include "tests/test_class.h"

namespace scene_scene_test {

namespace {

app::Shape randomShape(std::mt19937_64& random)
{
    app::Shape shape;
    std::uniform_real_distribution<double> number(-10, 10);
    app::Subpath path{{number(random), number(random)}, {}, random() % 2 == 0};
    for (auto n = random() % 5; n > 0; --n)
        path.segments.push_back({{number(random), number(random)}});
    shape.paths.push_back(path);
    shape.hidden = random() % 4 == 0;
    return shape;
}

/// A pen line that wanders over a corner of the sheet.
app::Shape stroke(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> step(-0.2, 0.2), place(-10, 10);
    app::Point at(place(random), place(random));
    app::Subpath path{at, {}, false};
    for (int i = 0; i < 100; ++i)
        path.segments.push_back({at += app::Point(step(random), step(random))});
    app::Shape shape;
    shape.paths.push_back(path);
    return shape;
}

app::Shape moved(app::Shape shape)
{
    for (app::Subpath& path : shape.paths) {
        path.start += 1.5;
        for (app::PathSegment& segment : path.segments)
            segment.to += 1.5;
    }
    return shape;
}

/// Exchanges some shapes for others.
void editAtRandom(app::EditedDocument& document, std::mt19937_64& random)
{
    const std::size_t size = sheetOf(document).shapes.size();
    const std::size_t first = random() % (size + 1);
    const std::size_t count = random() % (size - first + 1);
    std::vector<app::Shape> shapes;
    for (auto n = random() % 4; n > 0; --n)
        shapes.push_back(randomShape(random));
    ::splice(document, first, count, std::move(shapes));
}

/// Whether a frame is, bit for bit, what the algorithm says of every segment.
bool clipsAsAll(const app::Scene& scene, const clipping::Algorithm& algorithm,
                const clipping::Window& window)
{
    std::vector<clipping::Clipped> all(scene.lines().size());
    all.resize(algorithm.corrected.clipAll(segmentsOf(scene.lines()), window, all));
    const app::ClipRegion region{{{window, app::WindowOperation::Add}}};
    FrameClipping clipping;
    const auto frame = clipping.clip(scene.lines(), region, {.algorithm = &algorithm});
    return frame.total == scene.lines().size() && same(keptIn(frame), all);
}

} // namespace

class SceneTest : public QObject {
    Q_OBJECT

private slots:
    void splicingEqualsStartingAnew()
    {
        std::mt19937_64 random(1);
        app::EditedDocument document;
        const app::Scene spliced(document);
        for (int round = 0; round < 500; ++round) {
            editAtRandom(document, random);
            const app::Scene fresh(document);
            QVERIFY(segmentsOf(fresh.lines()) == segmentsOf(spliced.lines()));
            for (std::size_t i = 0; i <= sheetOf(document).shapes.size(); ++i)
                QCOMPARE(spliced.lines().firstLineOf(i), fresh.lines().firstLineOf(i));
        }
    }

    void blocksMadeBeforeGiveTheSameLines()
    {
        std::mt19937_64 random(3);
        app::EditedDocument document, edited;
        app::Scene scene(document);
        for (int round = 0; round < 200; ++round) {
            const app::Document before = edited.now();
            for (int i = 0; i < 3; ++i)
                editAtRandom(edited, random);
            scene.expect(app::blocksFor(round % 3 == 0 ? before : edited.now()));
            document.load(edited.now());
            const app::Scene fresh(document);
            QVERIFY(segmentsOf(fresh.lines()) == segmentsOf(scene.lines()));
        }
    }

    void framesAreWhatClippingEverythingGives()
    {
        std::mt19937_64 random(2);
        std::uniform_real_distribution<double> number(-11, 11);
        app::EditedDocument document;
        app::Scene scene(document);
        std::size_t seen = 0;
        for (int round = 0; round < 500; ++round) {
            const std::size_t size = sheetOf(document).shapes.size();
            if (round % 10 == 0)
                ::splice(document, random() % (size + 1), 0, {stroke(random), stroke(random)});
            else if (round % 10 == 5) // as long as before: only boxes change
                ::splice(document, size - 1, 1, {moved(sheetOf(document).shapes.back())});
            else
                ::splice(document, size, 0, {randomShape(random)});
            if (round % 50 == 49)
                ::setLayers(document, {{.name = "layer", .visible = round % 100 == 99}});
            if (round % 150 == 149)
                editAtRandom(document, random);
            const app::Point a(number(random), number(random)), b(number(random), number(random));
            const clipping::Window window{glm::min(a, b), glm::max(a, b)};
            for (const auto& algorithm : clipping::algorithms())
                QVERIFY2(clipsAsAll(scene, algorithm, window), algorithm.key.data());
            seen += scene.lines().size();
        }
        QVERIFY(seen > 100'000);
    }
};

} // namespace scene_scene_test

TEST_CLASS(scene_scene_test::SceneTest, None)
#include "tests/app/scene/scene_test.moc"
