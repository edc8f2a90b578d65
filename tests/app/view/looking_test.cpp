// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view.h"

#include <QTest>

#include "tests/test_class.h"

namespace view_looking_test {

using clipping::Window;

namespace {

constexpr Window clipWindow{{0, 0}, {1000, 800}};

app::View viewOf(app::Point centre, double zoom) { return {{800, 600}, centre, zoom}; }

app::Point sizeOf(const app::View& view) { return view.visible().max - view.visible().min; }

bool sees(const app::View& view, const Window& piece)
{
    const Window all = view.visible();
    return all.min.x <= piece.min.x && all.min.y <= piece.min.y && piece.max.x <= all.max.x
           && piece.max.y <= all.max.y;
}

} // namespace

class LookingTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsWellSeenIsLeftWhereItIs()
    {
        const app::View view = viewOf({500, 400}, 1);
        QCOMPARE(app::lookingAt(view, {{300, 300}, {301, 341}}, clipWindow), view);
    }
    void whatIsLargeEnoughButElsewhereIsMovedTo()
    {
        const app::View view = viewOf({5000, 400}, 1);
        const auto to = app::lookingAt(view, {{300, 300}, {301, 341}}, clipWindow);
        QCOMPARE(to, viewOf({300.5, 320.5}, 1));
    }
    void aSmallPieceIsSeenInItsSurroundings_data()
    {
        QTest::addColumn<double>("length");
        for (const double length : {0., 1e-9, 1., 10., 30.})
            QTest::addRow("%g", length) << length;
    }
    void aSmallPieceIsSeenInItsSurroundings()
    {
        QFETCH(double, length);
        const Window piece{{700, 100}, {700, 100 + length}};
        const auto to = app::lookingAt(viewOf({500, 400}, 0.6), piece, clipWindow);
        const double least = std::min(sizeOf(to).x, sizeOf(to).y);
        QVERIFY(sees(to, piece));
        QVERIFY(least >= 100 - 1e-9);                        // a tenth of the window
        QVERIFY(length <= 0.2 * least + 1e-9);               // a fifth of the view
        QVERIFY(least <= std::max(100., 5 * length) + 1e-9); // and no farther away than that
    }
    void whoIsCloserAlreadyStaysThere()
    {
        const auto to = app::lookingAt(viewOf({0, 0}, 50), {{700, 100}, {700, 100}}, clipWindow);
        QCOMPARE(to, viewOf({700, 100}, 50));
    }
    void whatDoesNotFitIsSeenAsAWhole()
    {
        for (const Window& piece : {Window{{100, 0}, {101, 800}}, Window{{0, 0}, {5000, 10}}}) {
            const auto to = app::lookingAt(viewOf({100, 100}, 90), piece, clipWindow);
            QVERIFY(sees(to, piece));
            QVERIFY(to.zoom < 1);
        }
    }
    void aLineOffTheViewIsBroughtIntoIt()
    {
        const app::View view = viewOf({500, 400}, 1); // (100,100)-(900,700)
        QCOMPARE(app::bringing(view, {{0, 0}, {200, 200}}), view);
        QCOMPARE(app::bringing(view, {{0, 0}, {90, 90}}), viewOf({45, 45}, 1));
        // Its box is seen, but not the line.
        QCOMPARE(app::bringing(view, {{0, 150}, {150, 0}}), viewOf({75, 75}, 1));
    }
};

} // namespace view_looking_test

TEST_CLASS(view_looking_test::LookingTest, Core)
#include "tests/app/view/looking_test.moc"
