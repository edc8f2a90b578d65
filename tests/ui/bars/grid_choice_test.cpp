// SPDX-License-Identifier: GPL-3.0-or-later
#include <QToolButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::bars_grid_choice_test {

// The grid in the bar across the top, by mouse and keys.
class GridChoiceTest : public QObject {
    Q_OBJECT

    struct Bar {
        Bar() { t.show(); }
        template <class Widget>
        Widget* named(const char* name)
        {
            for (auto* widget : t.window->findChildren<Widget*>())
                if (widget->accessibleName() == name)
                    return widget;
            return nullptr;
        }
        QToolButton* button() { return named<QToolButton>("Grid"); }
        void type(const char* text)
        {
            auto* field = named<QDoubleSpinBox>("Grid spacing");
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, text);
            QTest::keyClick(field, Qt::Key_Return);
        }
        const app::Grid& grid() { return t.window->session().display().grid; }

        TestWindow t;
    };

private slots:
    void theButtonAndTheKeySwitchTheGrid()
    {
        Bar bar;
        QVERIFY(!bar.grid().shown);
        QTest::mouseClick(bar.button(), Qt::LeftButton);
        QVERIFY(bar.grid().shown && bar.t.action("grid")->isChecked());
        QTest::keyClick(bar.t.drawingArea(), Qt::Key_F5, Qt::ShiftModifier);
        QVERIFY(!bar.grid().shown && !bar.button()->isChecked());
    }
    void aTypedSpacingShowsTheGrid()
    {
        Bar bar;
        bar.type("1in/2");
        QVERIFY(bar.grid().shown);
        QVERIFY(std::abs(bar.grid().spacing - 12.7) < 1e-9);
        QCOMPARE(bar.t.window->focusWidget(), bar.t.drawingArea());
        bar.type("0"); // no grid
        QVERIFY(std::abs(bar.grid().spacing - 12.7) < 1e-9);
    }
    void theGridIsRemembered()
    {
        Bar bar;
        bar.type("25");
        bar.t.action("grid-isometric")->trigger();
        bar.t.action("grid-dots")->trigger();
        const auto next = windowWithMenus();
        QCOMPARE(next->session().display().grid, bar.grid());
        QCOMPARE(bar.grid(),
                 (app::Grid{true, 25, app::Grid::Pattern::Isometric, app::Grid::Marks::Dots}));
    }
};

} // namespace ui::bars_grid_choice_test

TEST_CLASS(ui::bars_grid_choice_test::GridChoiceTest, Widgets)
#include "tests/ui/bars/grid_choice_test.moc"
