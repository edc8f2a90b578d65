// SPDX-License-Identifier: GPL-3.0-or-later
// Groups and objects in the panel Layers, with mouse and keys.
#include "app/document/document_builder.h"
#include "ui/docks/layers_panel.h"
#include "ui/widgets/search_field.h"

#include <QLineEdit>
#include <QSignalSpy>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_layer_tree_test {

using namespace ui;

class LayerTreeTest : public QObject {
    Q_OBJECT

    /// Layers "low" with lines 0 and 1, and "high" with line 2, a group of lines 3 and 4, line 5.
    struct Panel : TestWindow {
        Panel()
        {
            app::DocumentBuilder builder;
            builder.open({.name = "low"});
            add(builder, 2);
            builder.close();
            builder.open({.name = "high"});
            add(builder, 1);
            builder.open({.kind = app::Container::Kind::Group, .name = "pair"});
            add(builder, 2);
            builder.close();
            add(builder, 1);
            builder.close();
            window->session().load({builder.take({}), {}});
            show();
            window->raisePanel("layers");
            list = window->findChild<LayerList*>();
            QTRY_VERIFY(list->isVisible());
        }
        void add(app::DocumentBuilder& builder, int count)
        {
            for (; count > 0; --count, ++x)
                builder.add(
                    {app::Path(clipping::Segment{{x, 0}, {x, 9}}), {.stroke = app::Colour{}}});
        }
        app::Session& session() { return window->session(); }
        QModelIndex at(int row) { return list->model()->index(row, 0); }
        QStringList rows()
        {
            QStringList all;
            for (int row = 0; row < list->model()->rowCount(); ++row)
                all << QString(at(row).data(LayerModel::DepthRole).toInt() - 1, '.')
                           + at(row).data().toString();
            return all;
        }
        int rowOf(const QString& name) { return int(rows().indexOf(name)); }
        void click(const QString& name, Qt::KeyboardModifiers modifiers = {})
        {
            QTest::mouseClick(list->viewport(), Qt::LeftButton, modifiers,
                              list->visualRect(at(rowOf(name))).center());
        }
        void clickChevron(const QString& name)
        {
            const QRect row = list->visualRect(at(rowOf(name)));
            const int depth = at(rowOf(name)).data(LayerModel::DepthRole).toInt();
            QTest::mouseClick(
                list->viewport(), Qt::LeftButton, {},
                {row.left() + space::dockMargin + 27 + 14 * (depth - 1), row.center().y()});
        }
        void key(Qt::Key key) { QTest::keyClick(list, key); }

        double x = 0;
        LayerList* list = nullptr;
    };
    using Ranges = app::ObjectRanges;

private slots:
    void aLayerIsOpened()
    {
        Panel panel;
        QCOMPARE(panel.rows(), QStringList({"high", "low"}));
        panel.clickChevron("high");
        QCOMPARE(panel.rows(), QStringList({"high", ".Line 6", ".pair", ".Line 3", "low"}));
        panel.clickChevron(".pair");
        QCOMPARE(panel.rows(), QStringList({"high", ".Line 6", ".pair", "..Line 5", "..Line 4",
                                            ".Line 3", "low"}));
        QVERIFY(panel.session().selection().empty());
        panel.clickChevron("high");
        QCOMPARE(panel.rows(), QStringList({"high", "low"}));
    }
    void aClickSelects()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.clickChevron("low");
        panel.click(".Line 3");
        QCOMPARE(panel.session().selection(), Ranges({2}));
        panel.click(".pair", Qt::ControlModifier);
        QCOMPARE(panel.session().selection(), Ranges({2, 3, 4}));
        panel.click(".Line 3", Qt::ControlModifier);
        QCOMPARE(panel.session().selection(), Ranges({3, 4}));
        panel.click(".Line 6");
        panel.click(".Line 3", Qt::ShiftModifier);
        QCOMPARE(panel.session().selection(), Ranges({2, 3, 4, 5}));
        QVERIFY(panel.at(panel.rowOf(".pair")).data(LayerModel::SelectedRole).toBool());
        QVERIFY(panel.at(panel.rowOf("high")).data(LayerModel::HoldsRole).toBool());
        QVERIFY(!panel.at(panel.rowOf("low")).data(LayerModel::HoldsRole).toBool());
        panel.click("low"); // a layer is chosen for new objects; the selection stays
        QCOMPARE(panel.session().selection().size(), std::size_t(4));
        QVERIFY(panel.at(panel.rowOf("low")).data(LayerModel::PenRole).toBool());
    }
    void whatIsLockedIsRefused()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.list->model()->setData(panel.at(0), true, LayerModel::LockedRole);
        const QSignalSpy refused(&panel.session(), &app::Session::refused);
        panel.click(".Line 3");
        QVERIFY(panel.session().selection().empty());
        QVERIFY(refused.size() > 0);
    }
    void whatIsSelectedInThePictureIsShown()
    {
        Panel panel;
        panel.session().select({3, 4}); // the group
        QCOMPARE(panel.rows(), QStringList({"high", ".Line 6", ".pair", ".Line 3", "low"}));
        panel.session().select({1});
        QCOMPARE(panel.rows(), QStringList({"high", "low", ".Line 2", ".Line 1"}));
        panel.session().select({});
        QCOMPARE(panel.rows(), QStringList({"high", "low"}));
        panel.session().select({1});
        panel.click(".Line 1"); // what is used stays open
        panel.session().select({});
        QCOMPARE(panel.rows(), QStringList({"high", "low", ".Line 2", ".Line 1"}));
    }
    void keysOpenAndSelect()
    {
        Panel panel;
        panel.list->setFocus();
        panel.list->setCurrentIndex(panel.at(0));
        panel.key(Qt::Key_Right);
        QCOMPARE(panel.rows().size(), 5);
        panel.key(Qt::Key_Down);
        QCOMPARE(panel.session().selection(), Ranges({5}));
        panel.key(Qt::Key_Down);
        QCOMPARE(panel.session().selection(), Ranges({3, 4}));
        panel.key(Qt::Key_Left); // to what is around it
        QCOMPARE(panel.list->currentIndex().row(), 0);
        panel.key(Qt::Key_Left);
        QCOMPARE(panel.rows(), QStringList({"high", "low"}));
    }
    void objectsAreDraggedToALayer()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".Line 3");
        panel.click(".Line 6", Qt::ControlModifier);
        const auto middle = [&](const char* name) {
            return panel.list->visualRect(panel.at(panel.rowOf(name))).center();
        };
        QTest::mousePress(panel.list->viewport(), Qt::LeftButton, {}, middle(".Line 3"));
        QCOMPARE(panel.session().selection(), Ranges({2, 5})); // both are dragged
        for (const QPoint& at : {middle(".pair"), middle("low")}) {
            QMouseEvent event(QEvent::MouseMove, at, panel.list->viewport()->mapToGlobal(at),
                              Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(panel.list->viewport(), &event);
        }
        QTest::mouseRelease(panel.list->viewport(), Qt::LeftButton, {}, middle("low"));
        QCOMPARE(panel.session().history.count(), 1);
        const app::Containers& tree = panel.session().now().containers();
        const auto layers = tree.childrenOf(0);
        QCOMPARE(tree.rangeOf(layers[0]).size(), std::size_t(4));
        QCOMPARE(tree.rangeOf(layers[1]).size(), std::size_t(2));
    }
    /// Drags a row to a height of another row: 0 is its top, 1 its bottom; x: at its own level or,
    /// negative, further out.
    static void drag(Panel& panel, const QString& name, const QString& to, double height, int x = 0)
    {
        const QRect row = panel.list->visualRect(panel.at(panel.rowOf(to)));
        const int left = x < 0 ? row.left() + space::dockMargin + 22 : row.center().x();
        const QPoint place(left, row.top() + int(height * (row.height() - 1)));
        QTest::mousePress(panel.list->viewport(), Qt::LeftButton, {},
                          panel.list->visualRect(panel.at(panel.rowOf(name))).center());
        QMouseEvent event(QEvent::MouseMove, place, panel.list->viewport()->mapToGlobal(place),
                          Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(panel.list->viewport(), &event);
        QTest::mouseRelease(panel.list->viewport(), Qt::LeftButton, {}, place);
    }
    void objectsAreDraggedBetweenOthers()
    {
        Panel panel;
        const app::Document before = panel.session().now();
        panel.clickChevron("high");
        drag(panel, ".Line 3", ".Line 6", 0);
        QCOMPARE(panel.rows(), QStringList({"high", ".Line 3", ".Line 6", ".pair", "low"}));
        QCOMPARE(panel.session().history.count(), 1);
        drag(panel, ".Line 3", ".Line 6", 1);
        QCOMPARE(panel.rows(), QStringList({"high", ".Line 6", ".Line 3", ".pair", "low"}));
        drag(panel, ".Line 6", ".pair", 1); // below the closed group
        QCOMPARE(panel.rows(), QStringList({"high", ".Line 3", ".pair", ".Line 6", "low"}));
        drag(panel, ".pair", ".Line 3", 0); // a group as a whole
        QCOMPARE(panel.rows(), QStringList({"high", ".pair", ".Line 3", ".Line 6", "low"}));
        drag(panel, ".Line 6", ".pair", 0.5); // into it, which opens it
        QCOMPARE(panel.rows(), QStringList({"high", ".pair", "..Line 6", "..Line 5", "..Line 4",
                                            ".Line 3", "low"}));
        panel.session().history.setIndex(0);
        QVERIFY(panel.session().now() == before);
    }
    // Below the last row of a group, the place of the pointer across says how deep.
    void theDepthFollowsThePointer()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.clickChevron(".pair");
        drag(panel, ".Line 6", "..Line 4", 1, -1);
        QCOMPARE(panel.rows(), QStringList({"high", ".pair", "..Line 5", "..Line 4", ".Line 6",
                                            ".Line 3", "low"}));
        drag(panel, ".Line 6", "..Line 4", 1);
        QCOMPARE(panel.rows(), QStringList({"high", ".pair", "..Line 5", "..Line 4", "..Line 6",
                                            ".Line 3", "low"}));
        drag(panel, ".pair", "..Line 4", 0); // not into itself
        QCOMPARE(panel.session().history.count(), 2);
    }
    void theFieldFilters()
    {
        Panel panel;
        auto* field = panel.window->findChild<SearchField*>();
        field->setFocus();
        QTest::keyClicks(field, "line 5");
        QTRY_COMPARE(panel.rows(), QStringList({"high", ".pair", "..Line 5"}));
        QCOMPARE(field->accessibleDescription(), QStringLiteral("found: 1"));
        QTest::keyClick(field, Qt::Key_Return);
        QVERIFY(panel.list->hasFocus());
        panel.click("..Line 5");
        QCOMPARE(panel.session().selection(), Ranges({4}));
        panel.run("delete");
        QTRY_COMPARE(panel.rows(), QStringList());
        QCOMPARE(field->accessibleDescription(), QStringLiteral("found: none"));
        panel.run("undo");
        QTRY_COMPARE(panel.rows().size(), 3);
        field->setFocus();
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(field->text().isEmpty() && field->hasFocus());
        QVERIFY(panel.rows().contains("low"));
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!field->hasFocus());
    }
    void theCurrentRowStaysWithItsObject()
    {
        Panel panel;
        panel.window->findChild<SearchField*>()->setText("line");
        QTRY_COMPARE(panel.rows().size(), 9);
        panel.click("..Line 5");
        panel.session().select({2});
        panel.run("delete");
        QTRY_COMPARE(panel.rows().size(), 8);
        QCOMPARE(panel.list->currentIndex().data().toString(), QStringLiteral("Line 5"));
        panel.run("undo");
        QTRY_COMPARE(panel.rows().size(), 9);
        QCOMPARE(panel.list->currentIndex().data().toString(), QStringLiteral("Line 5"));
    }
    // The only one that is found lies below so many that the search takes a while.
    void whatIsFoundStaysInTheListWhileTheSearchGoesOn()
    {
        Panel panel;
        app::DocumentBuilder builder;
        builder.open({.name = "low"});
        builder.open({.kind = app::Container::Kind::Group, .name = "pair"});
        panel.add(builder, 2);
        builder.close();
        const app::StyleEntry style = builder.style({.stroke = app::Colour{}});
        for (int i = 0; i < 300'000; ++i)
            builder.addLine({{0, 0}, {1, 1}}, style);
        builder.close();
        panel.session().load({builder.take({}), {}});
        auto* field = panel.window->findChild<SearchField*>();
        auto* model = qobject_cast<LayerModel*>(panel.list->model());
        field->setText("pair 2"); // every number is looked at
        QTRY_COMPARE(field->accessibleDescription(), QStringLiteral("found: 1"));
        panel.click(".pair");
        const QSignalSpy removed(model, &QAbstractItemModel::rowsRemoved);
        QSignalSpy found(model, &LayerModel::foundChanged);
        QVERIFY(model->setData(panel.list->currentIndex(), false, LayerModel::VisibleRole));
        QTRY_VERIFY(!found.isEmpty());
        QCOMPARE(field->accessibleDescription(), QStringLiteral("found: 1"));
        QCOMPARE(removed.size(), 0);
        QCOMPARE(panel.list->currentIndex().data().toString(), QStringLiteral("pair"));
    }
    void aHiddenPanelDoesNotSearch()
    {
        Panel panel;
        auto* field = panel.window->findChild<SearchField*>();
        field->setText("line");
        QTRY_COMPARE(field->accessibleDescription(), QStringLiteral("found: 6"));
        panel.list->parentWidget()->hide();
        const QSignalSpy found(panel.list->model(), SIGNAL(foundChanged()));
        panel.session().select({2});
        panel.run("delete");
        QCoreApplication::processEvents();
        QCOMPARE(found.size(), 0);
        panel.list->parentWidget()->show();
        QTRY_COMPARE(field->accessibleDescription(), QStringLiteral("found: 5"));
        QCOMPARE(panel.rows().size(), 8);
    }
    // Below the last row is no layer.
    void objectsThatAreDroppedNowhereStay()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".Line 3");
        const QSignalSpy refused(&panel.session(), &app::Session::refused);
        const QPoint from = panel.list->visualRect(panel.at(3)).center();
        const QPoint to(from.x(), panel.list->viewport()->height() - 2);
        QVERIFY(!panel.list->indexAt(to).isValid());
        QTest::mousePress(panel.list->viewport(), Qt::LeftButton, {}, from);
        QMouseEvent event(QEvent::MouseMove, to, panel.list->viewport()->mapToGlobal(to),
                          Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(panel.list->viewport(), &event);
        QTest::mouseRelease(panel.list->viewport(), Qt::LeftButton, {}, to);
        QCOMPARE(refused.size(), 0);
        QCOMPARE(panel.session().history.count(), 0);
    }
    void whatThePressSelectsStays()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".Line 6");
        const QPoint at = panel.list->visualRect(panel.at(panel.rowOf(".Line 3"))).center();
        QTest::mousePress(panel.list->viewport(), Qt::LeftButton, Qt::ShiftModifier, at);
        QTest::mouseRelease(panel.list->viewport(), Qt::LeftButton, {}, at); // Shift came up first
        QCOMPARE(panel.session().selection(), Ranges({2, 3, 4, 5}));
        panel.click(".Line 3"); // one of several that are selected
        QCOMPARE(panel.session().selection(), Ranges({2}));
    }
    void anEyeChoosesNoLayer()
    {
        Panel panel;
        panel.click("low");
        const QRect row = panel.list->visualRect(panel.at(0));
        const QPoint eye(row.left() + space::dockMargin + 8, row.center().y());
        for (const bool visible : {false, true}) {
            QTest::mouseClick(panel.list->viewport(), Qt::LeftButton, {}, eye);
            QCOMPARE(panel.at(0).data(LayerModel::VisibleRole).toBool(), visible);
            QVERIFY(panel.at(1).data(LayerModel::PenRole).toBool());
        }
        QTest::mouseDClick(panel.list->viewport(), Qt::LeftButton, {}, eye); // its second press
        QTest::mouseRelease(panel.list->viewport(), Qt::LeftButton, {}, eye);
        QVERIFY(!panel.at(0).data(LayerModel::VisibleRole).toBool());
        QVERIFY(!qobject_cast<QLineEdit*>(QApplication::focusWidget()));
    }
    void anObjectIsHiddenAlone()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".Line 3");
        const auto clickEye = [&] {
            const QRect row = panel.list->visualRect(panel.at(panel.rowOf(".Line 3")));
            QTest::mouseClick(panel.list->viewport(), Qt::LeftButton, {},
                              {row.left() + space::dockMargin + 8, row.center().y()});
        };
        clickEye();
        QVERIFY(panel.session().now().objects()[2].hidden());
        QVERIFY(panel.session().selection().empty()); // what is hidden cannot be edited
        QCOMPARE(panel.session().scene.lines().size(), std::size_t(5));
        QCOMPARE(panel.session().history.undoText(), QStringLiteral("Hide Line 3"));
        QCOMPARE(panel.at(3).data(Qt::AccessibleTextRole).toString(),
                 QStringLiteral("Line 3, hidden, level 2"));
        clickEye();
        QVERIFY(!panel.session().now().objects()[2].hidden());
        panel.click(".Line 3");
        panel.session().history.undo();
        QVERIFY(panel.session().selection().empty());
        panel.session().history.redo();
        panel.list->model()->setData(panel.at(0), true, LayerModel::LockedRole);
        clickEye();
        QVERIFY(!panel.session().now().objects()[2].hidden());
    }
    void anObjectIsNamed()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".Line 3");
        panel.key(Qt::Key_F2);
        auto* editor = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        QVERIFY(editor);
        QVERIFY(editor->text().isEmpty()); // it has no name of its own yet
        QTest::keyClicks(editor, "Front  door");
        QTest::keyClick(editor, Qt::Key_Return);
        const auto id = [&](std::size_t object) {
            return panel.session().now().objects()[object].particulars().id;
        };
        QTRY_COMPARE(id(2), QString("Front_door"));
        QVERIFY(panel.rowOf(".Front_door") >= 0);
        QCOMPARE(panel.session().history.undoText(), QString("Name Front_door"));
        const auto rename = [&](const char* row, const QString& name) {
            return panel.list->model()->setData(panel.at(panel.rowOf(row)), name, Qt::EditRole);
        };
        const QSignalSpy refused(&panel.session(), &app::Session::refused);
        QVERIFY(!rename(".Line 6", "Front_door")); // each name stands once
        QCOMPARE(refused.count(), 1);
        QVERIFY(refused[0][0].toString().contains("Front_door"));
        QVERIFY(!rename(".Front_door", "Front door")); // the same
        QVERIFY(rename(".Line 6", QString(10000, 'x')));
        QCOMPARE(id(5).size(), qsizetype(1000));
        QVERIFY(rename(".Front_door", ""));
        QVERIFY(panel.rowOf(".Line 3") >= 0);
    }
    // The drawing is not moved instead.
    void itsKeysStayInTheListAtItsEnds()
    {
        Panel panel;
        panel.session().select({0});
        panel.list->setFocus();
        panel.list->setCurrentIndex(panel.at(panel.list->model()->rowCount() - 1));
        for (const Qt::Key key : {Qt::Key_Down, Qt::Key_End, Qt::Key_Right})
            panel.key(key);
        panel.list->setCurrentIndex(panel.at(0));
        for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Home, Qt::Key_Left, Qt::Key_Left})
            panel.key(key);
        QCOMPARE(panel.session().history.count(), 0);
    }
    void F2RenamesAGroup()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".pair");
        panel.list->setFocus();
        QTest::keyClick(panel.list, Qt::Key_F2);
        QVERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()));
        QTest::keyClicks(QApplication::focusWidget(), "two");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QTRY_COMPARE(panel.rows()[2], QStringLiteral(".two"));
        QVERIFY(!panel.session().microscope.isOpen());
    }
    void keysSelectSeveral()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".Line 6");
        panel.list->setFocus();
        QTest::keyClick(panel.list, Qt::Key_Down, Qt::ShiftModifier);
        QCOMPARE(panel.session().selection(), Ranges({3, 4, 5}));
        QTest::keyClick(panel.list, Qt::Key_Down, Qt::ControlModifier);
        QCOMPARE(panel.session().selection(), Ranges({3, 4, 5}));
        QTest::keyClick(panel.list, Qt::Key_Space, Qt::ControlModifier);
        QCOMPARE(panel.session().selection(), Ranges({2, 3, 4, 5}));
    }
    void aScreenReaderHearsWhatIsSeen()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".pair");
        const auto says = [&](int row) {
            return panel.at(row).data(Qt::AccessibleTextRole).toString();
        };
        QCOMPARE(says(0), QStringLiteral("high, shown, not locked, open"));
        QCOMPARE(says(2), QStringLiteral("pair, shown, not locked, closed, selected, level 2"));
        QCOMPARE(says(3), QStringLiteral("Line 3, level 2"));
    }
    void groupsAreRenamedAndHidden()
    {
        Panel panel;
        panel.clickChevron("high");
        auto& model = *panel.list->model();
        const QModelIndex pair = panel.at(panel.rowOf(".pair"));
        QVERIFY(model.setData(pair, "two", Qt::EditRole));
        QCOMPARE(panel.session().history.undoText(), QStringLiteral("Rename group"));
        QVERIFY(model.setData(panel.at(2), false, LayerModel::VisibleRole));
        QCOMPARE(panel.session().history.undoText(), QStringLiteral("Hide group"));
        QVERIFY(model.setData(panel.at(1), "line", Qt::EditRole));
        QCOMPARE(panel.session().history.undoText(), QStringLiteral("Name line"));
        panel.session().history.setIndex(0);
        QCOMPARE(panel.rows()[2], QStringLiteral(".pair"));
    }
    void theRightButtonOpensTheMenuOfObjects()
    {
        Panel panel;
        panel.clickChevron("high");
        const QSignalSpy wanted(panel.list, &LayerList::objectMenuWanted);
        const QPoint at = panel.list->visualRect(panel.at(1)).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, at,
                                panel.list->viewport()->mapToGlobal(at));
        QApplication::sendEvent(panel.list->viewport(), &event);
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(panel.session().selection(), Ranges({5}));
    }
    void undoAndOtherDrawingsAreFollowed()
    {
        Panel panel;
        panel.clickChevron("high");
        panel.click(".Line 6");
        panel.window->canvas().setFocus();
        panel.run("delete");
        QCOMPARE(panel.rows(), QStringList({"high", ".pair", ".Line 3", "low"}));
        panel.run("undo");
        QCOMPARE(panel.rows().size(), 5);
        panel.open(panel.twoLines());
        QCOMPARE(panel.list->model()->rowCount(), 1);
    }
};

} // namespace docks_layer_tree_test

TEST_CLASS(docks_layer_tree_test::LayerTreeTest, Widgets)
#include "tests/ui/docks/layer_tree_test.moc"
