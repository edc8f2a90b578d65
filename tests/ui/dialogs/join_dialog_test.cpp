// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/join_dialog.h"
#include "ui/widgets/length_field.h"

#include <QLabel>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace dialogs_join_dialog_test {

using namespace ui;

class JoinDialogTest : public QObject {
    Q_OBJECT

    /// Two lines, 0.5 mm apart, and the question about them.
    struct Dialog : Hand {
        Dialog()
            : Hand({shape({{{20, 20}, {{{30, 20}}}, false}}),
                    shape({{{30.5, 20}, {{{40, 20}}}, false}})})
        {
            session.changeDisplay([](app::Display& display) { display.unit = app::Unit::Mm; });
            session.select({0, 1});
            t.run("join-ends");
            dialog = t.window->findChild<JoinDialog*>();
        }
        LengthField& field() const { return *dialog->findChild<LengthField*>(); }
        void type(const QString& text) const
        {
            field().selectAll();
            QTest::keyClicks(&field(), text);
        }
        QString sentence() const
        {
            for (const QLabel* label : dialog->findChildren<QLabel*>())
                if (label->wordWrap())
                    return label->text();
            return {};
        }
        QPointer<JoinDialog> dialog;
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }

    void theDistanceIsAskedAndSaid()
    {
        Dialog d;
        QVERIFY(d.dialog && d.dialog->isVisible());
        QCOMPARE(d.field().value(), 0.1); // mm
        QTest::keyClick(d.dialog, Qt::Key_Return);
        QVERIFY(d.dialog->isVisible()); // and says why
        QVERIFY2(d.sentence().contains("within 0.1 mm of each other"), qPrintable(d.sentence()));
        QCOMPARE(d.session.history.count(), 0);
        d.type("1mm");
        QTest::keyClick(&d.field(), Qt::Key_Return);
        QVERIFY(!d.dialog || !d.dialog->isVisible());
        QCOMPARE(d.session.history.count(), 1);
        QCOMPARE(d.session.now().objects().size(), std::size_t(1));
        QCOMPARE(d.t.window->message(),
                 "2 objects became 1: 1 pair of ends was joined within 1 mm.");
    }
    void theDistanceIsRemembered()
    {
        Dialog d;
        d.type("0.02in");
        QTest::keyClick(&d.field(), Qt::Key_Return);
        QCOMPARE(d.session.now().objects().size(), std::size_t(1));
        d.t.run("undo");
        d.session.select({0, 1});
        d.t.run("join-ends");
        for (const auto* dialog : d.t.window->findChildren<JoinDialog*>())
            if (dialog->isVisible())
                QCOMPARE(dialog->findChild<LengthField*>()->value(), 0.508);
    }
    void cancelChangesNothing()
    {
        Dialog d;
        QTest::keyClick(d.dialog, Qt::Key_Escape);
        QCOMPARE(d.session.history.count(), 0);
    }
    void twoChosenEndsAreJoinedWithoutAQuestion()
    {
        Dialog d;
        QTest::keyClick(d.dialog, Qt::Key_Escape);
        d.t.window->canvas().setTool("nodes");
        d.session.nodes.select([](app::NodePath& path) {
            path[0].nodes[1].selected = path[1].nodes[0].selected = true;
        });
        d.t.run("join-ends");
        QCOMPARE(d.session.now().objects().size(), std::size_t(1));
        QCOMPARE(d.session.history.count(), 1);
    }
};

} // namespace dialogs_join_dialog_test

TEST_CLASS(dialogs_join_dialog_test::JoinDialogTest, Widgets)
#include "tests/ui/dialogs/join_dialog_test.moc"
