// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/status_bar.h"
#include "ui/docks/layers_panel.h"
#include "ui/editing/keeping.h"
#include "ui/tools/tool.h"
#include "ui/widgets/tool_list.h"

#include <QDockWidget>
#include <QLineEdit>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"
#include "tests/ui/test_window.h"

namespace first_use_test {

using namespace ui;

namespace {

QStringList warnings;

void collect(QtMsgType type, const QMessageLogContext&, const QString& text)
{
    if (type == QtWarningMsg)
        warnings << text;
}

// Renames the current row of a list, and ends the editing with a key, or (Key_unknown) as by a
// click elsewhere.
void rename(MainWindow& window, QListView& list, const char* name, Qt::Key end)
{
    list.edit(list.currentIndex());
    auto* editor = list.viewport()->findChild<QLineEdit*>();
    QVERIFY(editor);
    QTest::keyClicks(editor, name);
    if (end == Qt::Key_unknown)
        window.canvas().setFocus();
    else
        QTest::keyClick(editor, end);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QTRY_VERIFY(!list.viewport()->findChild<QLineEdit*>());
}

void openAndClose(TestWindow& test, QComboBox& list, Qt::Key end)
{
    const QByteArray name = list.accessibleName().toUtf8();
    list.setFocus();
    list.showPopup();
    QTRY_VERIFY(list.view()->isVisible());
    QTest::keyClick(list.view(), end);
    QTRY_VERIFY2(!list.view()->isVisible(), name);
    QTRY_VERIFY2(test.window->focusWidget() == test.drawingArea(), name);
}

} // namespace

// Small things that users notice in the first hour.
class FirstUseTest : public QObject {
    Q_OBJECT

private slots:
    void keepOutsideCountsTheLinesOutside()
    {
        TestWindow t;
        t.open(t.twoLines()); // with a window around both
        t.show();
        QTRY_COMPARE(t.window->status().visibility(), "2 of 2 visible");
        ui::setKeep(t.window->session(), app::Keep::Outside);
        QTRY_COMPARE(t.window->status().visibility(), "0 of 2 visible");
    }
    void repeatedPastesAreOffset()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        app::Session& session = t.window->session();
        session.select({0});
        t.action("copy")->trigger();
        for (int i = 0; i < 5; ++i)
            t.action("paste")->trigger();
        const auto start = [&](std::size_t object) {
            return session.now().objects()[object].path().subpaths()[0].start;
        };
        QCOMPARE(session.now().objects().size(), std::size_t(6));
        for (std::size_t i = 1; i < 6; ++i)
            QVERIFY(near(start(i), {0 + 5.0 * double(i), 50 + 5.0 * double(i)}, 1e-9));
        session.history.undo(); // its place is free again
        t.action("paste")->trigger();
        QVERIFY(near(start(5), {25, 75}, 1e-9));
        t.action("paste-in-place")->trigger();
        QVERIFY(near(start(6), {0, 50}, 1e-9));
        QCOMPARE(session.selection(), (app::ObjectRanges{6}));
    }
    void theHoverEndsWhenThePointerLeaves()
    {
        const auto leave = [](Stage& stage) {
            QEvent event(QEvent::Leave);
            QApplication::sendEvent(&stage.surface(), &event);
        };
        for (const ui::ToolInfo& info : tools()) {
            // the window's corner, its side, its inside; the line; a handle around the selection
            for (const app::Point p :
                 {app::Point(50, 20), {100, 20}, {60, 60}, {30, 50}, {10, 50}}) {
                Stage stage(Backend::Raster);
                stage.session.select({0});
                stage.canvas->setTool(info.key);
                const QImage before = stage.picture();
                const Qt::CursorShape cursor = stage.surface().cursor().shape();
                stage.move(p);
                leave(stage);
                const QString where = info.name + QString(" at %1, %2").arg(p.x).arg(p.y);
                QVERIFY2(stage.picture() == before, qPrintable(where));
                QVERIFY2(stage.surface().cursor().shape() == cursor, qPrintable(where));
            }
        }
    }
    void thePreviewedCornerDisappearsWithThePointer()
    {
        Stage stage(Backend::Raster, {});
        stage.canvas->setTool("polyline");
        stage.click({20, 20});
        QEvent event(QEvent::Leave);
        QApplication::sendEvent(&stage.surface(), &event);
        const QImage before = stage.picture();
        stage.move({120, 70});
        QVERIFY(stage.picture() != before);
        QApplication::sendEvent(&stage.surface(), &event);
        QVERIFY(stage.picture() == before);
    }
    void aClickBesideTheRowsKeepsTheSelection()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.window->raisePanel("algorithm");
        t.show();
        t.window->findChild<LayersPanel*>()->findChild<QToolButton*>()->click(); // a second layer
        int lists = 0;
        for (auto* list : t.window->findChildren<QAbstractItemView*>()) {
            if (!list->isVisible() || !list->currentIndex().isValid()
                || list->selectionMode() != QAbstractItemView::SingleSelection)
                continue;
            ++lists;
            list->setCurrentIndex(list->model()->index(0, 0));
            const QRect row = list->visualRect(list->currentIndex());
            const QPoint below(20, list->viewport()->height() - 2);
            if (!list->indexAt(below).isValid()) {
                QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, below);
                QCOMPARE(list->currentIndex().row(), 0);
            }
            QTRY_VERIFY2(list->selectionModel()->isSelected(list->currentIndex()),
                         qPrintable(list->accessibleName()));
            QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::ControlModifier, row.center());
            QTRY_VERIFY2(list->selectionModel()->isSelected(list->currentIndex()),
                         qPrintable(list->accessibleName()));
        }
        QVERIFY(lists >= 2); // layers and algorithms
    }
    void renamingALayerKeepsItSelected()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        auto* panel = t.window->findChild<LayersPanel*>();
        panel->findChild<QToolButton*>()->click();
        auto* list = panel->findChild<QListView*>();
        QTRY_VERIFY(list->viewport()->findChild<QLineEdit*>()); // the new layer is given a name
        QTest::keyClick(list->viewport()->findChild<QLineEdit*>(), Qt::Key_Return);
        QTRY_VERIFY(!list->viewport()->findChild<QLineEdit*>());
        const auto before = qInstallMessageHandler(collect);
        for (const int row : {0, 1}) {
            list->setCurrentIndex(list->model()->index(row, 0));
            for (const auto& [name, end] :
                 {std::pair("Sky", Qt::Key_Return), std::pair("Sea", Qt::Key_unknown),
                  std::pair("Land", Qt::Key_Escape)}) {
                rename(*t.window, *list, name, end);
                QCOMPARE(list->currentIndex().row(), row);
                QVERIFY(list->selectionModel()->isSelected(list->currentIndex()));
            }
            QCOMPARE(list->model()->index(row, 0).data().toString(), "Sea");
            t.action("undo")->trigger();
            QCOMPARE(list->model()->index(row, 0).data().toString(), "Sky");
        }
        qInstallMessageHandler(before);
        QCOMPARE(warnings, QStringList());
    }
    void listsReturnTheFocus()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        QVERIFY(QTest::qWaitForWindowActive(t.window.get()));
        t.window->canvas().setTool("rectangle"); // whose bar has a list
        QCoreApplication::processEvents();
        // The focus within the window: without a window manager, closing a list does not make the
        // window active again.
        const auto focus = [&] { return t.window->focusWidget(); };
        const auto lists = t.window->findChildren<QComboBox*>();
        int tried = 0;
        for (QComboBox* list : lists) {
            if (!list->isVisible())
                continue;
            ++tried;
            const QByteArray name = list->accessibleName().toUtf8();
            for (const Qt::Key end : {Qt::Key_Return, Qt::Key_Escape})
                openAndClose(t, *list, end);
            list->setFocus(); // closed, by the keyboard alone
            QTest::keyClick(list, Qt::Key_Down);
            QVERIFY2(focus() == list, name);
            QTest::keyClick(list, Qt::Key_Escape);
            QVERIFY2(focus() == t.drawingArea(), name);
        }
        QVERIFY(tried >= 1); // dashes
        QTest::keyClick(t.window->focusWidget(), Qt::Key_L);
        QCOMPARE(t.window->canvas().tool(), std::string_view("line"));
    }
    void listsOfTheComparisonPanelsGiveTheKeyboardBack()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        int tried = 0;
        for (const char* key : {"difference", "cost-map", "exactness"}) {
            t.window->togglePanel(key);
            for (QComboBox* list :
                 t.window->findChild<QDockWidget*>(key)->findChildren<QComboBox*>())
                if (list->isVisible() && ++tried)
                    openAndClose(t, *list, Qt::Key_Return);
        }
        QCOMPARE(tried, 5); // A and B, algorithm and measure, algorithm
    }
    void escapeReturnsTheFocusToTheCanvas()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        QVERIFY(QTest::qWaitForWindowActive(t.window.get()));
        int tried = 0;
        for (QWidget* widget : t.window->findChildren<QWidget*>()) {
            const bool canBe = widget->isVisible() && widget->isEnabled() && !widget->focusProxy()
                               && widget->focusPolicy() & Qt::TabFocus
                               && widget->window() == t.window.get();
            if (!canBe)
                continue;
            ++tried;
            widget->setFocus();
            QTest::keyClick(widget, Qt::Key_Escape);
            QVERIFY2(t.drawingArea()->hasFocus(),
                     qPrintable(widget->accessibleName() + widget->metaObject()->className()));
        }
        QVERIFY(tried > 10);
    }
};

} // namespace first_use_test

TEST_CLASS(first_use_test::FirstUseTest, Widgets)
#include "tests/ui/first_use_test.moc"
