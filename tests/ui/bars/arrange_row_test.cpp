// SPDX-License-Identifier: GPL-3.0-or-later
// What arranges selected objects, in the bar across the top.
#include "ui/bars/arrange_row.h"
#include "ui/bars/option_bar.h"

#include <QComboBox>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::bars_arrange_row_test {

class ArrangeRowTest : public QObject {
    Q_OBJECT

    struct Bar : TestWindow {
        Bar()
        {
            open(file("two.svg",
                      "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                      "viewBox='0 0 100 100'>"
                      "<path stroke='black' d='M20 30L60 30L60 50L20 50Z'/>"
                      "<path stroke='black' d='M10 80L30 80'/></svg>"));
            show();
            window->resize(1280, 800);
            session().select({0});
            QTRY_VERIFY(row().isVisible());
        }
        app::Session& session() const { return window->session(); }
        ArrangeRow& row() const { return *window->optionBar().findChild<ArrangeRow*>(); }
        QToolButton* button(const QString& name) const
        {
            for (auto* button : row().findChildren<QToolButton*>())
                if (button->accessibleName() == name)
                    return button;
            return nullptr;
        }
        double height() const
        {
            const auto& box = *session().selectionBounds();
            return box.max.y - box.min.y;
        }
    };

private slots:
    void itIsThereWithSelectedObjects()
    {
        Bar bar;
        QTRY_VERIFY(bar.row().isVisible());
        bar.session().select({});
        QTRY_VERIFY(!bar.row().isVisible());
        bar.session().select({0});
        QTRY_VERIFY(bar.row().isVisible());
        bar.window->canvas().setTool("line");
        QTRY_VERIFY(!bar.row().isVisible());
    }
    void buttonsArrangeAndNameTheirShortcuts()
    {
        Bar bar;
        for (auto* button : bar.row().findChildren<QToolButton*>())
            QVERIFY(!button->toolTip().isEmpty() && !button->icon().isNull());
        QToolButton* rotate = bar.button("Rotate 90° left");
        QVERIFY(rotate->toolTip().contains("Shift+O"));
        QCOMPARE(bar.height(), 20.0);
        QTest::mouseClick(rotate, Qt::LeftButton);
        QVERIFY(std::abs(bar.height() - 40) < 1e-9);
        QCOMPARE(bar.window->focusWidget(), bar.drawingArea());
    }
    void theTargetIsChosenInTheList()
    {
        Bar bar;
        auto* list = bar.row().findChild<QComboBox*>();
        QToolButton* spread = bar.button("Spread evenly across");
        bar.session().select({0, 1});
        QVERIFY(!spread->isEnabled() && spread->toolTip().endsWith(u'.'));
        list->setFocus();
        while (list->currentText() != "to page")
            QTest::keyClick(list, Qt::Key_Down);
        QTest::keyClick(list, Qt::Key_Return);
        QVERIFY(bar.window->canvas().focusProxy()->hasFocus());
        QVERIFY(bar.action("to-page")->isChecked()); // the menu shows the same
        QVERIFY(spread->isEnabled());
        QTest::mouseClick(spread, Qt::LeftButton); // over the whole page, 100 mm
        const auto at = [&](std::size_t object) {
            bar.session().select({object});
            return *bar.session().selectionBounds();
        };
        QCOMPARE(at(1).min.x, 0.0); // its middle is the first
        QCOMPARE(at(0).max.x, 100.0);
        bar.run("to-selection");
        QCOMPARE(list->currentText(), QString("to selection"));
    }
    void strokesAreScaledByChoice()
    {
        Bar bar;
        auto* choice = bar.row().findChild<QCheckBox*>();
        const auto width = [&](std::size_t i) {
            return bar.session().now().objects()[i].style().width;
        };
        const double before = width(1);
        bar.session().select({0, 1}); // the upper object is the model
        bar.run("same-width");
        QCOMPARE(width(0), before);
        bar.window->canvas().undo();
        QTest::mouseClick(choice, Qt::LeftButton, {}, {8, choice->height() / 2});
        QVERIFY(bar.action("scale-strokes")->isChecked());
        bar.run("same-width"); // 40 wide to 20 wide
        QVERIFY(std::abs(width(0) - before * std::sqrt(0.5)) < 1e-9);
        QCOMPARE(width(1), before);
        bar.run("scale-strokes");
        QVERIFY(!choice->isChecked());
    }
};

} // namespace ui::bars_arrange_row_test

TEST_CLASS(ui::bars_arrange_row_test::ArrangeRowTest, Widgets)
#include "tests/ui/bars/arrange_row_test.moc"
