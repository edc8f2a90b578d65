// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/cut_options.h"
#include "ui/docks/window_panel.h"
#include "ui/widgets/length_field.h"

#include <QAction>
#include <QCheckBox>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_cut_options_test {

using namespace ui;

namespace {

/// A line, and above it a filled square with a stroke, of which the left half is in the window.
QString drawing(const TestWindow& t)
{
    return t.file("drawing.svg",
                  "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                  "viewBox='0 0 100 100' xmlns:clearcut='urn:clearcut:1'><metadata>"
                  "<clearcut:window xmin='0' ymin='0' xmax='50' ymax='100'/></metadata>"
                  "<path d='M0 50H100' stroke='#000' fill='none'/>"
                  "<rect x='10' y='10' width='80' height='80' stroke='#000' fill='#c00'/></svg>");
}

QCheckBox* check(TestWindow& t, const QString& text)
{
    for (auto* box : t.window->findChild<CutOptionsBox*>()->findChildren<QCheckBox*>())
        if (box->text() == text)
            return box;
    return nullptr;
}

} // namespace

class CutOptionsTest : public QObject {
    Q_OBJECT

private slots:
    void areasAreClosedIfWanted()
    {
        for (const bool closed : {false, true}) {
            TestWindow t;
            t.open(drawing(t));
            t.show();
            check(t, "Close cut areas")->setChecked(closed);
            QCOMPARE(t.window->session().display().cutting.closeAreas, closed);
            t.run("crop");
            QCOMPARE(t.window->session().history.count(), 1);
            QCOMPARE(t.window->session().now().objects().size(), closed ? 2u : 3u);
        }
    }

    void theChoicesAreRemembered()
    {
        TestWindow t;
        t.open(drawing(t));
        t.show();
        check(t, "Close cut areas")->setChecked(true);
        check(t, "Cut hidden objects")->setChecked(true);
        auto* field = t.window->findChild<LengthField*>("least-piece");
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, "2mm");
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(t.window->session().display().cutting, (app::CutChoices{true, true, 2}));
        QCOMPARE(windowWithMenus()->session().display().cutting, (app::CutChoices{true, true, 2}));
    }

    void theCanvasDropsShortPiecesToo()
    {
        TestWindow t;
        t.open(drawing(t));
        t.show();
        Canvas& canvas = t.window->canvas();
        const auto darkest = [&](double millimetres) { // around the line, left of the square
            t.window->session().changeDisplay([&](app::Display& display) {
                display.removed = app::RemovedPart::Hidden;
                display.cutting.leastMillimetres = millimetres;
            });
            canvas.settle();
            const QImage seen = canvas.paneSurface(0)->grab().toImage();
            const app::Point at = canvas.view().toScreen({5, 50});
            int least = 255;
            for (int y = -3; y <= 3; ++y)
                least = std::min(least, qGray(seen.pixel(qRound(at.x), qRound(at.y) + y)));
            return least;
        };
        QVERIFY(darkest(0) < 150);
        QVERIFY(darkest(49) < 150);
        QVERIFY(darkest(51) > 200); // 50 mm of the line are in the window
    }

    void coveredLinesAreRemovedInOneStep()
    {
        TestWindow t;
        t.open(drawing(t));
        t.show();
        app::Session& session = t.window->session();
        const app::Document before = session.now();
        t.run("occlude");
        QCOMPARE(session.history.count(), 1);
        QCOMPARE(session.now().objects()[0].path().subpathCount(), 2u);
        QVERIFY(!session.now().objects()[1].style().fill);
        session.history.undo();
        QVERIFY(session.now().objects() == before.objects());
    }
};

} // namespace docks_cut_options_test

TEST_CLASS(docks_cut_options_test::CutOptionsTest, Widgets)
#include "tests/ui/docks/cut_options_test.moc"
