// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace files_outline_strokes_test {

using namespace ui;

class OutlineStrokesTest : public QObject {
    Q_OBJECT

    /// A wide line, a filled square with a stroke, and a disc without one.
    static QString drawing(const TestWindow& t)
    {
        return t.file("drawing.svg",
                      "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                      "viewBox='0 0 100 100'>"
                      "<path d='M0 50H100' stroke='#00c' stroke-width='9' fill='none'/>"
                      "<rect x='10' y='10' width='20' height='20' stroke='#000' fill='#c00'/>"
                      "<circle cx='70' cy='20' r='9' fill='#c00'/></svg>");
    }

private slots:
    void selectedStrokesBecomeAreasInOneStep()
    {
        TestWindow t;
        t.open(drawing(t));
        t.show();
        app::Session& session = t.window->session();
        const app::Document before = session.now();
        t.run("select-all");
        t.run("stroke-outline");
        QCOMPARE(session.history.count(), 1);
        QCOMPARE(session.history.undoText(), "Outline of stroke");
        QCOMPARE(t.window->message(), "Strokes that became filled areas: 2.");
        QCOMPARE(session.now().objects().size(), 4u);
        for (std::size_t i = 0; i < 4; ++i)
            QVERIFY(!session.now().objects()[i].style().stroke);
        QCOMPARE(session.now().objects()[0].style().fill, (app::Colour{0, 0, 0xcc}));
        QCOMPARE(session.selection().size(), 3u); // what was made
        session.history.undo();
        QVERIFY(session.now().objects() == before.objects());
    }

    void withoutAStrokeTheCommandSaysWhy()
    {
        TestWindow t;
        t.open(drawing(t));
        t.show();
        for (const std::size_t object : {2, 0}) {
            t.window->session().select({object});
            QCOMPARE(t.action("stroke-outline")->isEnabled(), object == 0);
        }
        t.window->session().select({2});
        QVERIFY(t.action("stroke-outline")->toolTip().contains("Select an object with a stroke"));
    }

    // A point with flat caps has a stroke, of which nothing is seen.
    void whatIsNotSeenStays()
    {
        TestWindow t;
        t.open(t.file("point.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                                   "height='100mm' viewBox='0 0 100 100'><path d='M50 50h0' "
                                   "stroke='#000' stroke-width='9'/></svg>"));
        t.show();
        t.run("select-all");
        t.run("stroke-outline");
        QCOMPARE(t.window->session().history.count(), 0);
        QVERIFY(t.window->message().startsWith("Nothing was outlined"));
    }
};

} // namespace files_outline_strokes_test

TEST_CLASS(files_outline_strokes_test::OutlineStrokesTest, Widgets)
#include "tests/ui/files/outline_strokes_test.moc"
