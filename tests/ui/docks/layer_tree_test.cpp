// SPDX-License-Identifier: GPL-3.0-or-later
// Groups and objects in the panel Layers, with mouse and keys.
#include "app/document/document_builder.h"
#include "ui/docks/layers_panel.h"

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
        QVERIFY(!model.setData(panel.at(1), "line", Qt::EditRole)); // objects have no name here
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
