// SPDX-License-Identifier: GPL-3.0-or-later
// The stroke in the bar across the top, and in the capsule of selected objects.
#include "ui/bars/option_bar.h"
#include "ui/properties/stroke_row.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/tool_list.h"

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace properties_stroke_row_test {

using namespace ui;

class StrokeRowTest : public QObject {
    Q_OBJECT

    struct Rows : TestWindow {
        Rows()
        {
            open(file("two.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                                 "height='100mm' viewBox='0 0 100 100' stroke='black'>"
                                 "<path stroke-width='2' d='M20 30L60 30L60 50'/>"
                                 "<path stroke-width='3' d='M10 80L30 80'/></svg>"));
            show();
        }
        app::Session& session() { return window->session(); }
        StrokeRow& bar() { return *window->optionBar().findChild<StrokeRow*>(); }
        StrokeRow& capsule() { return *window->canvas().findChild<StrokeRow*>(); }
        /// Into the capsule's field, without Enter.
        LengthField& type(const char* text)
        {
            LengthField& width = capsule().width();
            (void)QTest::qWaitFor([&] { return width.isVisible(); });
            width.setFocus();
            width.selectAll();
            QTest::keyClicks(&width, text);
            return width;
        }
        double width(std::size_t i) { return session().now().objects()[i].style().width; }
    };

private slots:
    void theStrokeOfSelectedObjectsIsInTheirCapsule()
    {
        Rows rows;
        QVERIFY(!rows.bar().isVisible() && !rows.capsule().isVisible());
        rows.session().select({0});
        QTRY_VERIFY(!rows.bar().isVisible() && rows.capsule().isVisible());
        rows.window->canvas().setCapsuleHome(app::CapsuleHome::Off);
        QTRY_VERIFY(rows.bar().isVisible() && !rows.capsule().isVisible());
    }
    void eachShowsWhatItIsFor()
    {
        Rows rows;
        for (const app::ObjectRanges& selection :
             {app::ObjectRanges({0}), app::ObjectRanges({0, 1}), app::ObjectRanges()}) {
            rows.window->canvas().setTool(selection.empty() ? "line" : "select");
            rows.session().select(selection);
            StrokeRow& shown = selection.empty() ? rows.bar() : rows.capsule();
            QTRY_VERIFY(shown.isVisible());
            const double wide =
                selection.empty() ? rows.session().pen.style.width : rows.width(selection.first());
            QCOMPARE(shown.width().text().isEmpty(), selection.size() == 2); // mixed
            if (selection.size() != 2)
                QCOMPARE(shown.width().value(), wide);
        }
    }
    // A line has no area.
    void theFillOfSelectedObjectsIsInTheirCapsule()
    {
        Rows rows;
        const auto fills = [&](StrokeRow& row) {
            QList<ColourChoice*> shown;
            for (auto* colour : row.findChildren<ColourChoice*>())
                if (colour->part() == &app::Style::fill && colour->isVisible())
                    shown << colour;
            return shown;
        };
        QVERIFY(fills(rows.bar()).empty());
        rows.session().select({0});
        QTRY_COMPARE(fills(rows.capsule()).size(), 1);
        fills(rows.capsule()).front()->choose(app::Colour{200, 100, 50});
        QCOMPARE(rows.session().now().objects()[0].style().fill, (app::Colour{200, 100, 50}));
        rows.session().select({1});
        QTRY_VERIFY(rows.capsule().isVisible() && fills(rows.capsule()).empty());
        QVERIFY(rows.capsule().width().isVisible());
    }
    // There is no room for the capsule: the bar has the stroke, and always the panel Style.
    void aNarrowCanvasHasTheStrokeInTheBar()
    {
        Rows rows;
        auto* style = rows.window->optionBar().findChild<QWidget*>("style");
        rows.session().select({0});
        QTRY_VERIFY(!rows.bar().isVisible() && style->isVisible());
        app::Panes panes = rows.window->canvas().panes();
        panes.showAll();
        rows.window->canvas().setPanes(panes);
        QTRY_VERIFY(rows.bar().isVisible() && style->isVisible());
        panes.show(1);
        rows.window->canvas().setPanes(panes);
        QTRY_VERIFY(!rows.bar().isVisible() && style->isVisible());
    }
    void whatIsTypedStaysUntilItIsTaken()
    {
        Rows rows;
        rows.session().select({0});
        LengthField& width = rows.type("9");
        rows.session().changeDisplay([](app::Display& d) { d.guides = !d.guides; });
        QTest::keyClick(&width, Qt::Key_Return);
        QCOMPARE(rows.width(0), 9.0);
    }
    void aTypedWidthIsForTheObjectsThatWereShown()
    {
        Rows rows;
        rows.session().select({0});
        LengthField& width = rows.type("5");
        QTest::keyClick(&width, Qt::Key_Return);
        QCOMPARE(rows.width(0), 5.0);
        QCOMPARE(rows.window->focusWidget(), rows.drawingArea());
        rows.type("7");
        rows.session().select({1}); // while the field is open
        QCOMPARE(rows.width(0), 5.0);
        QCOMPARE(rows.width(1), 3.0);
        QCOMPARE(rows.window->focusWidget(), rows.drawingArea());
    }
};

} // namespace properties_stroke_row_test

TEST_CLASS(properties_stroke_row_test::StrokeRowTest, Widgets)
#include "tests/ui/properties/stroke_row_test.moc"
