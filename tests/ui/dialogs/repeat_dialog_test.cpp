// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/repeat_dialog.h"

#include <QAbstractButton>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace dialogs_repeat_dialog_test {

using namespace ui;

// The copies are shown on the canvas while the dialog is open.
class RepeatDialogTest : public QObject {
    Q_OBJECT

    struct Dialog : Hand {
        Dialog() : Hand({shape({{{20, 20}, {{{30, 20}}, {{30, 26}}}, true}})})
        {
            session.select({0});
            canvas.settle();
            before = t.window->canvas().grab().toImage();
            t.run("repeat");
            dialog = t.window->findChild<RepeatDialog*>();
        }
        QSpinBox* count(const QString& name) const
        {
            for (QSpinBox* field : dialog->findChildren<QSpinBox*>())
                if (field->accessibleName() == name)
                    return field;
            return nullptr;
        }
        std::size_t shown() const { return session.preview().copies.size(); }
        QImage picture()
        {
            canvas.settle();
            return canvas.grab().toImage();
        }
        /// The colour in the middle of the lower side of the triangle's copy in a row and column.
        QColor sideOfCopy(int row, int column)
        {
            const QPoint p = at({25.0 + 15 * column, 20.0 + 11 * row});
            const QPoint inCanvas = surface().mapTo(&canvas, p);
            return picture().pixelColor(inCanvas);
        }

        QPointer<RepeatDialog> dialog;
        QImage before;
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void withoutASelectionWhatWasJustDrawnIsRepeated()
    {
        Hand hand({shape({{{120, 20}, {{{130, 20}}, {{130, 26}}}, true}})});
        QVERIFY(!hand.t.action("repeat")->isEnabled());
        hand.canvas.setTool("line");
        hand.drag({20, 20}, {40, 30});
        QVERIFY(hand.session.selection().empty());
        hand.t.run("repeat");
        auto* dialog = hand.t.window->findChild<RepeatDialog*>();
        QVERIFY(dialog);
        QCOMPARE(hand.session.selection(), app::ObjectRanges{1});
        dialog->reject();
        hand.session.select({});
        hand.session.history.undo();
        QVERIFY(!hand.t.action("repeat")->isEnabled());
    }
    void everyNumberIsShownAtOnce()
    {
        Dialog t;
        QVERIFY(t.dialog);
        QCOMPARE(t.shown(), std::size_t(5)); // 2 rows of 3
        QVERIFY(t.picture() != t.before);
        QVERIFY(t.sideOfCopy(1, 2) != QColor(Qt::white));
        QCOMPARE(t.sideOfCopy(1, 3), QColor(Qt::white));
        t.count("Columns")->setValue(4);
        QCOMPARE(t.shown(), std::size_t(7));
        QVERIFY(t.sideOfCopy(1, 3) != QColor(Qt::white));
        for (auto* button : t.dialog->findChildren<QAbstractButton*>())
            if (button->text() == "Around a point")
                button->click();
        QCOMPARE(t.shown(), std::size_t(5)); // six in all
    }
    void cancelLeavesNothing()
    {
        Dialog t;
        QVERIFY(t.shown() > 0);
        QTest::keyClick(t.dialog, Qt::Key_Escape);
        QCOMPARE(t.shown(), std::size_t(0));
        QCOMPARE(t.picture(), t.before);
        QCOMPARE(t.session.history.count(), 0);
        QCOMPARE(t.session.selection().size(), std::size_t(1));
    }
    void repeatingIsOneStep()
    {
        Dialog t;
        QTest::keyClick(t.dialog, Qt::Key_Return);
        QCOMPARE(t.shown(), std::size_t(0));
        QCOMPARE(t.session.now().objects().size(), std::size_t(6));
        QCOMPARE(t.session.history.count(), 1);
        t.canvas.undo();
        QCOMPARE(t.session.now().objects().size(), std::size_t(1));
    }
    void tooManyAreNotShown()
    {
        Dialog t;
        t.count("Rows")->setValue(app::mostCopies);
        t.count("Columns")->setValue(app::mostCopies);
        QCOMPARE(t.shown(), std::size_t(0));
        t.count("Rows")->setValue(1);
        QCOMPARE(t.shown(), std::size_t(app::mostCopies - 1));
        t.picture(); // is painted soon
    }
};

} // namespace dialogs_repeat_dialog_test

TEST_CLASS(dialogs_repeat_dialog_test::RepeatDialogTest, Widgets)
#include "tests/ui/dialogs/repeat_dialog_test.moc"
