// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/rearrange_selection.h"
#include "ui/docks/layer_model.h"

#include <QElapsedTimer>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_groups_test {

namespace {

app::Shape horizontal(double y) { return shape({{{20, y}, {{{100, y}}}, false}}); }

} // namespace

// Groups, painting order and copies, with mouse and keys only.
class GroupsTest : public QObject {
    Q_OBJECT

    /// Horizontal lines at y = 20, 40, 60 and 80; the second and the third are in a group.
    struct Drawing : Hand {
        Drawing() : Hand({horizontal(20), horizontal(40), horizontal(60), horizontal(80)})
        {
            app::Edit noWindow;
            noWindow.windows = app::ClipWindows();
            session.document.apply(noWindow);
            click({30, 40});
            click({30, 60}, Qt::ShiftModifier);
            key(Qt::Key_G, Qt::ControlModifier);
            key(Qt::Key_Escape);
        }
        app::ContainerId group() { return session.now().containers().containerOf(1); }
        bool isGroup(app::ContainerId id)
        {
            return session.now().containers()[id].kind == app::Container::Kind::Group;
        }
        double heightOf(std::size_t object)
        {
            return session.now().objects()[object].singleLine()->a.y;
        }
    };

private slots:
    void aClickSelectsTheGroup()
    {
        Drawing drawing;
        QVERIFY(drawing.isGroup(drawing.group()));
        QVERIFY(drawing.session.selection().empty());
        drawing.click({50, 60});
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1, 2}));
        drawing.click({50, 20}, Qt::ShiftModifier);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{0, 1, 2}));
        drawing.click({50, 40}, Qt::ShiftModifier);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{0}));
        drawing.click({50, 40}, Qt::AltModifier);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1}));
    }
    void boxesSelectWholeGroups()
    {
        Drawing drawing;
        drawing.drag({10, 10}, {110, 50}); // contains one line of the group
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{0}));
        drawing.drag({110, 50}, {50, 10}); // touches it
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{0, 1, 2}));
    }
    void aDoubleClickEntersAndEscapeLeaves()
    {
        Drawing drawing;
        drawing.doubleClick({50, 40});
        QCOMPARE(drawing.session.entered.id(), drawing.group());
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1}));
        drawing.click({50, 60});
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{2}));
        drawing.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1, 2}));
        drawing.click({50, 60});
        drawing.doubleClick({50, 60}); // a path in it: its nodes
        QCOMPARE(drawing.canvas.tool(), "nodes");
        drawing.key(Qt::Key_Escape);
        QCOMPARE(drawing.canvas.tool(), "select");
        QCOMPARE(drawing.session.entered.id(), drawing.group());
        drawing.key(Qt::Key_Escape);
        QCOMPARE(drawing.session.entered.id(), app::ContainerId(0));
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1, 2}));
        drawing.key(Qt::Key_Escape);
        QVERIFY(drawing.session.selection().empty());
    }
    void escapeBacksOutOneLevelEachTime() // field, node, nodes, group, selection
    {
        Drawing drawing;
        const auto field = [] { return qobject_cast<QLineEdit*>(QApplication::focusWidget()); };
        drawing.doubleClick({50, 40});
        drawing.doubleClick({50, 40});
        drawing.click({100, 40});
        QCOMPARE(drawing.session.nodes.summary().selected, std::size_t(1));
        drawing.type("5");
        QVERIFY(field());
        drawing.key(Qt::Key_Escape);
        QVERIFY(!field());
        QCOMPARE(drawing.session.nodes.summary().selected, std::size_t(1));
        drawing.key(Qt::Key_Escape);
        QVERIFY(!drawing.session.nodes.someSelected() && drawing.canvas.tool() == "nodes");
        drawing.key(Qt::Key_Escape);
        QVERIFY(drawing.canvas.tool() == "select" && drawing.session.entered.id() != 0);
        drawing.key(Qt::Key_Escape);
        QVERIFY(drawing.session.entered.id() == 0 && !drawing.session.selection().empty());
        drawing.key(Qt::Key_Escape);
        QVERIFY(drawing.session.selection().empty());
        QCOMPARE(drawing.session.history.count(), 1); // the group itself
        QCOMPARE(drawing.session.now().objects().size(), std::size_t(4));
    }
    void aClickOutsideLeavesTheGroup()
    {
        Drawing drawing;
        drawing.doubleClick({50, 40});
        drawing.click({50, 80});
        QCOMPARE(drawing.session.entered.id(), app::ContainerId(0));
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{3}));
    }
    void theEnteredGroupIsShown()
    {
        Drawing drawing;
        drawing.canvas.settle();
        const QImage before = drawing.surface().grab().toImage();
        drawing.click({50, 40});
        drawing.key(Qt::Key_Return, Qt::ControlModifier);
        QVERIFY(drawing.session.entered.id() != 0);
        drawing.key(Qt::Key_Escape);
        drawing.key(Qt::Key_Escape);
        drawing.move({150, 95}, {});
        drawing.canvas.settle();
        QCOMPARE(drawing.surface().grab().toImage(), before);
        drawing.doubleClick({50, 40});
        drawing.canvas.settle();
        const QImage entered = drawing.surface().grab().toImage();
        const auto darkness = [&](const QImage& picture) {
            return qGray(picture.pixel(drawing.at({60, 80})));
        };
        QVERIFY(darkness(entered) > darkness(before)); // what is outside is paler
    }
    void movingAGroupMovesAllOfIt()
    {
        Drawing drawing;
        drawing.click({50, 40});
        drawing.type("g0,5\n");
        QCOMPARE(drawing.heightOf(1), 45.0);
        QCOMPARE(drawing.heightOf(2), 65.0);
        drawing.type("gc0,3\n"); // a copy of the group is a group
        QCOMPARE(drawing.session.now().objects().size(), std::size_t(6));
        const auto copy =
            drawing.session.now().containers().containerOf(drawing.session.selection().first());
        QVERIFY(drawing.isGroup(copy) && copy != drawing.group());
        QCOMPARE(drawing.session.now().containers().rangeOf(copy).size(), std::size_t(2));
    }
    void newObjectsGoIntoTheEnteredGroup()
    {
        Drawing drawing;
        drawing.doubleClick({50, 40});
        drawing.key(Qt::Key_R);
        drawing.drag({120, 30}, {140, 40});
        QCOMPARE(drawing.session.now().containers().rangeOf(drawing.group()).size(),
                 std::size_t(3));
        drawing.key(Qt::Key_Escape);
        QCOMPARE(drawing.session.entered.id(), app::ContainerId(0));
        drawing.drag({120, 50}, {140, 60});
        QCOMPARE(drawing.session.now().containers().rangeOf(drawing.group()).size(),
                 std::size_t(3));
    }
    void ungroupIsUndoneAsOneStep()
    {
        Drawing drawing;
        drawing.click({50, 40});
        drawing.key(Qt::Key_G, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!drawing.isGroup(drawing.group()));
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1, 2}));
        drawing.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(drawing.isGroup(drawing.group()));
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1, 2}));
    }
    void keysChangeTheOrder()
    {
        Drawing drawing;
        drawing.click({50, 20});
        drawing.key(Qt::Key_Home);
        QCOMPARE(drawing.heightOf(3), 20.0);
        drawing.key(Qt::Key_End);
        QCOMPARE(drawing.heightOf(0), 20.0);
        QSignalSpy refused(&drawing.session, &app::Session::refused);
        drawing.key(Qt::Key_PageUp); // nothing overlaps
        QCOMPARE(refused.count(), 1);
        drawing.key(Qt::Key_G);
        drawing.type("0,20\n"); // onto the line at 40
        drawing.key(Qt::Key_PageUp);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{2}));
    }
    void copiesStayWhereTheyAre()
    {
        Drawing drawing;
        drawing.click({50, 80});
        drawing.key(Qt::Key_D, Qt::ControlModifier);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{4}));
        QCOMPARE(drawing.heightOf(4), 80.0);
        drawing.key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{3}));
        drawing.key(Qt::Key_C, Qt::ControlModifier);
        drawing.key(Qt::Key_V, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(drawing.heightOf(4), 80.0);
        drawing.key(Qt::Key_V, Qt::ControlModifier);
        drawing.key(Qt::Key_V, Qt::ControlModifier);
        QCOMPARE(drawing.heightOf(5), 85.0);
        QCOMPARE(drawing.heightOf(6), 90.0);
    }
    void aLockedLayerIsRefusedInOneSentence()
    {
        Drawing drawing;
        auto* model = drawing.t.window->findChild<ui::LayerModel*>();
        model->setData(model->index(0), true, ui::LayerModel::LockedRole);
        const int steps = drawing.session.history.count();
        QSignalSpy refused(&drawing.session, &app::Session::refused);
        drawing.click({50, 40});
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused.last().first().toString().contains("locked"));
        drawing.key(Qt::Key_L);
        drawing.click({10, 10});
        QCOMPARE(refused.count(), 2);
        QCOMPARE(drawing.session.history.count(), steps);
        QVERIFY(drawing.t.window->message().contains("locked"));
        model->setData(model->index(0), false, ui::LayerModel::LockedRole);
        QVERIFY(drawing.t.window->message().isEmpty()); // it is settled
    }
    // Measured, not judged: a busy machine is slow. With all panels, without painting.
    void manyObjects()
    {
        Drawing drawing;
        app::DocumentBuilder builder;
        builder.open({});
        const auto style = builder.style({.stroke = app::Colour{}});
        for (int i = 0; i < 100'000; ++i)
            builder.addLine({{i % 400 * 0.5, i / 400 * 0.4}, {i % 400 * 0.5 + 3, i / 400 * 0.4}},
                            style);
        builder.close();
        drawing.session.load({builder.take({}), {}});
        drawing.canvas.settle();
        const auto timed = [&](const char* what, int key, Qt::KeyboardModifiers modifiers = {}) {
            QElapsedTimer timer;
            timer.start();
            drawing.key(key, modifiers);
            qInfo("%s: %lld ms", what, timer.elapsed());
        };
        timed("select all", Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(drawing.session.selection().size(), std::size_t(100'000));
        timed("group", Qt::Key_G, Qt::ControlModifier);
        timed("undo", Qt::Key_Z, Qt::ControlModifier);
        drawing.key(Qt::Key_Escape);
        drawing.click({101, 50});
        QCOMPARE(drawing.session.selection().size(), std::size_t(1));
        timed("raise", Qt::Key_PageUp);
        timed("to front", Qt::Key_Home);
        timed("undo", Qt::Key_Z, Qt::ControlModifier);
        timed("invert", Qt::Key_I, Qt::ControlModifier);
        timed("lower", Qt::Key_PageDown);
        timed("duplicate", Qt::Key_D, Qt::ControlModifier);
        timed("undo", Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(drawing.session.selection().size(), std::size_t(99'999));
    }
    void objectsAreFoundByName()
    {
        Drawing drawing;
        auto* model = drawing.t.window->findChild<ui::LayerModel*>();
        model->setData(model->index(0), "Walls", Qt::EditRole);
        ::setWindow(drawing.session.document, {{-5000, -5000}, {-4900, -4900}});
        drawing.canvas.fitWindow(); // far from what is found
        drawing.key(Qt::Key_F, Qt::ControlModifier);
        QTRY_VERIFY(QApplication::activeModalWidget());
        auto* field = QApplication::activeModalWidget()->findChild<QLineEdit*>("find");
        QApplication::activeModalWidget()->activateWindow();
        QTRY_VERIFY(field->hasFocus());
        for (const char* c = "wall\n"; *c; ++c)
            *c == '\n' ? drawing.key(Qt::Key_Return)
                       : QTest::keyClick(QApplication::focusWidget(), *c);
        QCOMPARE(drawing.session.selection().size(), std::size_t(4));
        QVERIFY(drawing.canvas.view().visible().max.x > 0);
        drawing.key(Qt::Key_Escape);
        QTRY_VERIFY(!QApplication::activeModalWidget());
        drawing.t.window->activateWindow();
        drawing.canvas.setFocus();
        QTRY_VERIFY(QApplication::focusWidget());
        drawing.click({50, 20});
        drawing.key(Qt::Key_I, Qt::ControlModifier);
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1, 2, 3}));
    }
    void theMenuOfTheRightButtonHasWhatApplies()
    {
        Drawing drawing;
        const auto menuAt = [&](app::Point p) {
            QContextMenuEvent event(QContextMenuEvent::Mouse, drawing.at(p),
                                    drawing.surface().mapToGlobal(drawing.at(p)));
            QApplication::sendEvent(&drawing.surface(), &event);
            QStringList names;
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            for (const QAction* action : menu ? menu->actions() : QList<QAction*>())
                names << (action->menu() ? action->menu()->objectName() : action->objectName());
            if (menu)
                menu->close();
            return names;
        };
        const QStringList onGroup = menuAt({50, 40});
        QCOMPARE(drawing.session.selection(), (app::ObjectRanges{1, 2}));
        QVERIFY(onGroup.contains("ungroup") && onGroup.contains("move-to-layer"));
        QVERIFY(!onGroup.contains("leave-group"));
        const QStringList onLine = menuAt({50, 80});
        QVERIFY(onLine.contains("group") && !onLine.contains("ungroup"));
        const QStringList beside = menuAt({150, 50});
        QVERIFY(beside.contains("paste") && beside.contains("select-all"));
        QVERIFY(!beside.contains("ungroup"));
    }
};

} // namespace tools_groups_test

TEST_CLASS(tools_groups_test::GroupsTest, Widgets)
#include "tests/ui/tools/groups_test.moc"
