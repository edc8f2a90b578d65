// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"
#include "ui/docks/dock.h"

#include <QApplication>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace menus_panes_rows_test {

using namespace ui;

class PanesRowsTest : public QObject {
    Q_OBJECT

    static QString place(const TestWindow& t)
    {
        const QWidget* focus = QApplication::focusWidget();
        if (t.window->optionBar().isAncestorOf(focus))
            return "bar";
        for (const Dock* dock : t.window->findChildren<Dock*>())
            if (dock->isAncestorOf(focus))
                return "panels";
        return QStringLiteral("pane %1").arg(t.window->canvas().panes().active() + 1);
    }

private slots:
    void f6GoesThroughTheWindow()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        t.window->canvas().setFocus();
        const auto way = [&t](Qt::KeyboardModifiers with, int steps) {
            QStringList places;
            for (int i = 0; i < steps; ++i) {
                QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6, with);
                places << place(t);
            }
            return places.join(", ");
        };
        QCOMPARE(way({}, 4), "bar, panels, pane 1, bar");
        QCOMPARE(way(Qt::ShiftModifier, 3), "pane 1, panels, bar");
        t.action("panes-2")->trigger();
        t.window->canvas().activatePane(0);
        t.window->canvas().setFocus();
        QCOMPARE(way({}, 4), "pane 2, bar, panels, pane 1");
    }
};

} // namespace menus_panes_rows_test

TEST_CLASS(menus_panes_rows_test::PanesRowsTest, Widgets)
#include "tests/ui/menus/panes_rows_test.moc"
