// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/selection_panel.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/reference_point.h"
#include "ui/widgets/unit_box.h"
#include "ui/window/workspaces.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace properties_selection_panel_test {

using namespace ui;

// Numbers of the selection, typed in its panel.
class SelectionPanelTest : public QObject {
    Q_OBJECT

    struct Panel : TestWindow {
        Panel()
        {
            open(file("two.svg",
                      "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                      "viewBox='0 0 100 100'>"
                      "<path stroke='black' d='M20 30L60 30L60 50L20 50Z'/>"
                      "<path stroke='black' d='M10 80L30 80'/></svg>"));
            show();
            window->choose(findWorkspace("workspace-draw"));
            session().select({0});
            waitForFinalSize(panel());
        }
        static void settle() { QTest::qWait(20); } // the panel follows after the events
        app::Session& session() const { return window->session(); }
        LengthField* field(const QString& name) const
        {
            for (LengthField* field : panel().findChildren<LengthField*>())
                if (field->accessibleName() == name)
                    return field;
            return nullptr;
        }
        SelectionPanel& panel() const { return *window->findChild<SelectionPanel*>(); }
        void type(const QString& name, const QString& text) const
        {
            field(name)->setFocus();
            field(name)->selectAll();
            QTest::keyClicks(field(name), text);
            QTest::keyClick(field(name), Qt::Key_Return);
            settle();
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void typedWidthResizesTheSelection()
    {
        Panel t;
        const double before = t.field("Width")->value();
        QVERIFY(before > 0);
        t.type("Width", QString::number(before * 2));
        QVERIFY(std::abs(t.field("Width")->value() - before * 2) < 1e-9);
        QCOMPARE(t.session().history.count(), 1);
        QVERIFY(t.window->canvas().focusProxy()->hasFocus()); // the canvas goes on
        t.window->canvas().undo();
        Panel::settle();
        QVERIFY(std::abs(t.field("Width")->value() - before) < 1e-9);
    }
    void typedSkewLeansTheSelection()
    {
        Panel t;
        auto* point = t.panel().findChild<ReferencePoint*>();
        point->choose({-1, 1}); // bottom left
        const double width = t.field("Width")->value(), height = t.field("Height")->value();
        t.type("Skew", "45");
        QVERIFY(std::abs(t.field("Width")->value() - (width + height)) < 1e-9);
        QCOMPARE(t.field("Height")->value(), height);
        QCOMPARE(t.field("Skew")->value(), 0.0);
        QCOMPARE(t.session().history.count(), 1);
        t.type("Skew", "90");
        QVERIFY(t.window->message().endsWith(u'.'));
        QCOMPARE(t.session().history.count(), 1);
    }
    void nothingSelectedHasNoNumbersAtTheSameHeight()
    {
        Panel t;
        const QSize size(t.panel().width(), t.panel().sizeHint().height());
        t.session().select({});
        waitForFinalSize(t.panel());
        QVERIFY(std::abs(t.panel().height() - size.height()) <= 1); // Qt keeps one
        QVERIFY(!t.field("Width")->isVisible());
        t.session().select({0, 1});
        Panel::settle();
        QVERIFY(t.field("Width")->isVisible() && !t.field("Width")->text().isEmpty());
    }
    void referencePointIsChosenByMouseAndKeys()
    {
        Panel t;
        auto* point = t.panel().findChild<ReferencePoint*>();
        const double x = t.field("X")->value();
        QTest::mouseClick(point, Qt::LeftButton, {}, {point->width() - 5, point->height() - 5});
        QCOMPARE(point->chosen(), (app::Handle{1, 1}));
        Panel::settle();
        QVERIFY(t.field("X")->value() > x);
        QTest::keyClick(point, Qt::Key_Left);
        QTest::keyClick(point, Qt::Key_Up);
        QCOMPARE(point->chosen(), (app::Handle{0, 0}));
    }
    void impossibleNumberIsRefusedWithASentence()
    {
        Panel t;
        t.session().select({1});
        Panel::settle();
        const double before = t.field("Height")->value();
        t.type("Height", "5"); // a horizontal line
        QVERIFY(t.window->message().endsWith(u'.'));
        QCOMPARE(t.field("Height")->value(), before);
        QCOMPARE(t.session().history.count(), 0);
    }
    void theUnitIsShownAndChosen()
    {
        Panel t;
        UnitButton* unit = t.panel().findChild<UnitButton*>();
        QCOMPARE(unit->text(), QString("mm"));
        QTest::mouseClick(unit, Qt::LeftButton);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        for (QAction* action : menu->actions())
            if (action->text() == "cm")
                QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(action).center());
        Panel::settle();
        QCOMPARE(unit->text(), QString("cm"));
        QVERIFY(std::abs(t.field("Width")->value() - 4) < 1e-9);
        QVERIFY(t.field("Angle")->text().endsWith(u'°'));
        t.type("Angle", "90°");
        QVERIFY(std::abs(t.field("Height")->value() - 4) < 1e-9);
    }
};

} // namespace properties_selection_panel_test

TEST_CLASS(properties_selection_panel_test::SelectionPanelTest, Widgets)
#include "tests/ui/properties/selection_panel_test.moc"
