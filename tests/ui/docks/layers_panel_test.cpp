// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/selection_style.h"
#include "ui/docks/layers_panel.h"
#include "ui/widgets/colour_popup.h"

#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_layers_panel_test {

using namespace ui;

// The panel Layers, with mouse and keys.
class LayersPanelTest : public QObject {
    Q_OBJECT

    /// Layers a, b and c, from bottom to top, with one, two and three lines.
    struct Panel : TestWindow {
        Panel()
        {
            app::DocumentBuilder builder;
            double x = 0;
            for (const int count : {1, 2, 3}) {
                builder.open({.name = QString(QChar('a' + count - 1))});
                for (int i = 0; i < count; ++i, ++x)
                    builder.add(
                        {app::Path(clipping::Segment{{x, 0}, {x, 1}}), {.stroke = app::Colour{}}});
                builder.close();
            }
            window->session().load({builder.take({}), {}});
            show();
            list = window->findChild<LayerList*>();
        }
        QRect row(int number) { return list->visualRect(list->model()->index(number, 0)); }
        void click(const QPoint& at, Qt::KeyboardModifiers modifiers = {})
        {
            QTest::mouseClick(list->viewport(), Qt::LeftButton, modifiers, at);
        }
        void key(int key, Qt::KeyboardModifiers modifiers = {})
        {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key(key), modifiers);
        }
        void drag(const QPoint& from, const QPoint& to)
        {
            QTest::mousePress(list->viewport(), Qt::LeftButton, {}, from);
            for (const QPoint& at : {(from + to) / 2, to}) {
                QMouseEvent event(QEvent::MouseMove, at, list->viewport()->mapToGlobal(at),
                                  Qt::NoButton, Qt::LeftButton, {});
                QApplication::sendEvent(list->viewport(), &event);
            }
            QTest::mouseRelease(list->viewport(), Qt::LeftButton, {}, to);
        }
        /// "a b(c)", from bottom to top; hidden layers in lower case, the others in capitals.
        QString tree(app::ContainerId of = 0)
        {
            const app::Containers& all = window->session().now().containers();
            QStringList names;
            for (const app::ContainerId id : all.childrenOf(of)) {
                const QString inner = tree(id), name = all[id].name;
                names << (all[id].visible ? name.toUpper() : name)
                             + (inner.isEmpty() ? QString() : '(' + inner + ')');
            }
            return names.join(' ');
        }
        LayerList* list = nullptr;
    };

private slots:
    void objectsAreCounted()
    {
        Panel panel;
        QCOMPARE(panel.list->model()->index(0, 0).data(LayerModel::CountRole).toInt(), 3);
        QCOMPARE(panel.list->model()->index(2, 0).data(LayerModel::CountRole).toInt(), 1);
    }
    void aClickOnTheColourChoosesThatOfNewObjects()
    {
        Panel panel;
        app::Session& session = panel.window->session();
        const auto* colours = panel.window->findChild<LayersPanel*>()->findChild<ColourPopup*>();
        const QPoint swatch(panel.row(1).left() + space::dockMargin + 41,
                            panel.row(1).center().y());
        panel.click(swatch);
        QVERIFY(colours->isVisible());
        for (const char c : {'f', 'f', '0', '0', '0', '0'})
            QTest::keyClick(QApplication::focusWidget(), c);
        panel.key(Qt::Key_Return);
        QVERIFY(!colours->isVisible());
        QCOMPARE(session.history.undoText(), "Layer colour");
        QCOMPARE(panel.list->model()->index(1, 0).data(Qt::DecorationRole).value<QColor>(),
                 QColor(255, 0, 0));
        QVERIFY(session.now().containers()[session.pen.layer].name == "b"); // it is chosen, too
        QVERIFY(app::newStyle(session).stroke == (app::Colour{255, 0, 0}));
        session.history.undo();
        QCOMPARE(panel.list->model()->index(1, 0).data(Qt::DecorationRole).value<QColor>(),
                 QColor(0, 0, 0));
    }
    void layersAreDragged()
    {
        Panel panel;
        const QPoint top(0, -panel.row(0).height() / 2 + 1);
        panel.drag(panel.row(2).center(), panel.row(0).center() + top); // above the first row
        QCOMPARE(panel.tree(), "B C A");
        panel.drag(panel.row(0).center(), panel.row(2).center()); // into the last row
        QCOMPARE(panel.tree(), "B(A) C");
        panel.drag(panel.row(2).center(), panel.row(2).center() + QPoint(0, 200)); // to the bottom
        QCOMPARE(panel.tree(), "A B C");
        QCOMPARE(panel.window->session().history.count(), 3);
        panel.drag(panel.row(1).center(), panel.row(1).center() + QPoint(0, 1)); // no drag
        QCOMPARE(panel.window->session().history.count(), 3);
    }
    /// The drawing may be another one when the button is released.
    void aDraggedLayerMayBeGone()
    {
        Panel panel;
        const QPoint from = panel.row(0).center(), to = panel.row(2).center();
        QTest::mousePress(panel.list->viewport(), Qt::LeftButton, {}, from);
        QMouseEvent move(QEvent::MouseMove, to, panel.list->viewport()->mapToGlobal(to),
                         Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(panel.list->viewport(), &move);
        app::Session& session = panel.window->session();
        session.load({app::DocumentBuilder().take({}), {}});
        QSignalSpy refused(&session, &app::Session::refused);
        QTest::mouseRelease(panel.list->viewport(), Qt::LeftButton, {}, to);
        QCOMPARE(refused.size(), 0);
        QCOMPARE(session.history.count(), 0);
    }
    void keysMoveLayers()
    {
        Panel panel;
        panel.click(panel.row(2).center());
        QVERIFY(panel.list->hasFocus());
        panel.key(Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(panel.tree(), "B A C");
        panel.key(Qt::Key_Right, Qt::AltModifier);
        QCOMPARE(panel.tree(), "B C(A)");
        panel.key(Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(panel.tree(), "B A C");
        panel.key(Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(panel.tree(), "A B C");
    }
    void aLayerIsRenamedInPlace()
    {
        Panel panel;
        panel.click(panel.row(1).center());
        panel.key(Qt::Key_F2); // not the microscope
        QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        for (const char c : {'x', 'y'})
            QTest::keyClick(QApplication::focusWidget(), c);
        panel.key(Qt::Key_Return);
        QTRY_COMPARE(panel.tree(), "A XY C"); // the editor closes later
        QVERIFY(!panel.window->session().microscope.isOpen());
    }
    void aNewLayerIsNamedInPlace()
    {
        Panel panel;
        auto* button = panel.window->findChild<LayersPanel*>()->findChildren<QToolButton*>(
            QString(), Qt::FindDirectChildrenOnly)[0];
        for (const char* name : {"Sky", "Sea"}) {
            QTest::mouseClick(button, Qt::LeftButton);
            QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
            QTest::keyClicks(QApplication::focusWidget(), name);
            if (QLatin1String(name) == "Sky")
                panel.key(Qt::Key_Return);
            else // a click elsewhere keeps the name, too
                QTest::mouseClick(panel.drawingArea(), Qt::LeftButton);
            QTRY_VERIFY(!qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        }
        QTRY_COMPARE(panel.tree(), "A B C SKY SEA");
    }
    void keysThatTheListDoesNotUseGoToTheCanvas()
    {
        Panel panel;
        auto& session = panel.window->session();
        session.worksInDraw = true;
        const auto clickRow = [&] { panel.click(panel.row(1).center()); };
        panel.window->canvas().setTool("select");
        clickRow();
        panel.key(Qt::Key_Shift);
        QVERIFY(qobject_cast<LayerList*>(QApplication::focusWidget()));
        panel.key(Qt::Key_L);
        QVERIFY(panel.window->canvas().tool() == "line");
        QVERIFY(panel.window->canvas().isAncestorOf(QApplication::focusWidget()));
        clickRow();
        panel.key(Qt::Key_1); // a number of the line, not an algorithm
        QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        panel.key(Qt::Key_Escape);
        panel.key(Qt::Key_V);
        panel.window->session().select({0});
        clickRow();
        panel.key(Qt::Key_Escape);
        QVERIFY(session.selection().empty());
        panel.window->session().select({0});
        panel.window->refreshActions();
        clickRow();
        panel.key(Qt::Key_Delete);
        QCOMPARE(session.now().objects().size(), std::size_t(5));
    }
    void eyeAndPadlockAreClicked()
    {
        Panel panel;
        const auto eye = [&](int row) {
            return QPoint(panel.row(row).left() + space::dockMargin + 8,
                          panel.row(row).center().y());
        };
        panel.click(eye(0));
        QCOMPARE(panel.tree(), "A B c");
        panel.click(eye(0));
        panel.click(eye(1), Qt::AltModifier);
        QCOMPARE(panel.tree(), "a B c");
        panel.click(eye(1), Qt::AltModifier);
        QCOMPARE(panel.tree(), "A B C");
        const QRect row = panel.row(0);
        panel.click({row.right() - space::dockMargin - 8, row.center().y()});
        const auto& session = panel.window->session();
        QVERIFY(session.now().containers()[session.now().containers().childrenOf(0)[2]].locked);
    }
    void severalEyesAndPadlocksAreDraggedOver()
    {
        Panel panel;
        const auto eye = [&](int row) {
            return QPoint(panel.row(row).left() + space::dockMargin + 8,
                          panel.row(row).center().y());
        };
        const auto lock = [&](int row) {
            return QPoint(panel.row(row).right() - space::dockMargin - 8,
                          panel.row(row).center().y());
        };
        const auto drag = [&](const QPoint& from, const QPoint& to) {
            QWidget* const at = panel.list->viewport();
            QTest::mousePress(at, Qt::LeftButton, {}, from);
            QMouseEvent move(QEvent::MouseMove, to, at->mapToGlobal(to), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(at, &move);
        };
        const auto release = [&](const QPoint& at) {
            QTest::mouseRelease(panel.list->viewport(), Qt::LeftButton, {}, at);
        };
        auto& session = panel.window->session();
        drag(eye(0), eye(1));
        QCOMPARE(panel.tree(), "A B C"); // only shown until the release
        release(eye(1));
        QCOMPARE(panel.tree(), "A b c");
        QCOMPARE(session.history.count(), 1);
        QCOMPARE(session.history.undoText(), QString("Hide 2 rows"));
        session.history.undo();
        QCOMPARE(panel.tree(), "A B C");
        drag(eye(2), eye(1));
        QTest::keyClick(panel.list, Qt::Key_Escape);
        release(eye(1));
        QCOMPARE(panel.tree(), "A B C");
        drag(lock(0), lock(2));
        release(lock(2));
        for (const app::ContainerId layer : session.now().containers().childrenOf(0))
            QVERIFY(session.now().containers()[layer].locked);
        QCOMPARE(session.history.undoText(), QString("Lock 3 rows"));
    }
    void theMenuHasWhatApplies()
    {
        Panel panel;
        const QPoint at = panel.row(0).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, at,
                                panel.list->viewport()->mapToGlobal(at));
        QApplication::sendEvent(panel.list->viewport(), &event);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu);
        QStringList texts;
        for (const QAction* action : menu->actions())
            texts << action->text();
        QVERIFY(texts.filter("Rename").size() == 1 && texts.filter("Move down").size() == 1);
        QVERIFY(texts.filter("Move up").isEmpty()); // it is the topmost
        menu->close();
    }
};

} // namespace docks_layers_panel_test

TEST_CLASS(docks_layers_panel_test::LayersPanelTest, Widgets)
#include "tests/ui/docks/layers_panel_test.moc"
