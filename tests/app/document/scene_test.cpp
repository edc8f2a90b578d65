// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/scene.h"

#include <QTest>

#include <random>

namespace {

app::Shape randomShape(std::mt19937_64& random)
{
    app::Shape shape;
    std::uniform_real_distribution<double> number(-10, 10);
    app::Path path{{number(random), number(random)}, {}, random() % 2 == 0};
    for (auto n = random() % 5; n > 0; --n)
        path.stretches.push_back({{number(random), number(random)}});
    shape.paths.push_back(path);
    shape.hidden = random() % 4 == 0;
    return shape;
}

} // namespace

class SceneTest : public QObject {
    Q_OBJECT

private slots:
    void splicingEqualsStartingAnew()
    {
        std::mt19937_64 random(1);
        app::Drawing drawing;
        const app::Scene spliced(drawing);
        for (int round = 0; round < 500; ++round) {
            const std::size_t size = drawing.sheet().shapes.size();
            const std::size_t first = random() % (size + 1);
            const std::size_t count = random() % (size - first + 1);
            std::vector<app::Shape> shapes;
            for (auto n = random() % 4; n > 0; --n)
                shapes.push_back(randomShape(random));
            drawing.splice(first, count, std::move(shapes));

            const app::Scene fresh(drawing);
            QVERIFY(std::ranges::equal(fresh.segments(), spliced.segments()));
            for (std::size_t i = 0; i <= drawing.sheet().shapes.size(); ++i)
                QCOMPARE(spliced.firstSegmentOf(i), fresh.firstSegmentOf(i));
        }
    }
};

QTEST_APPLESS_MAIN(SceneTest)
#include "scene_test.moc"
