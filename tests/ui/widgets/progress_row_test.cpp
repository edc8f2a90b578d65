// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/progress_row.h"

#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace widgets_progress_row_test {

using namespace ui;

class ProgressRowTest : public QObject {
    Q_OBJECT

private slots:
    void barAndCancelAreShownDuringTheWork()
    {
        ProgressRow row;
        row.show();
        auto& bar = *row.findChild<QProgressBar*>();
        auto& cancel = *row.findChild<QPushButton*>();
        const QSize before = row.sizeHint();
        QVERIFY(!bar.isVisible() && !cancel.isVisible());
        row.setWorking(true);
        QVERIFY(bar.isVisible() && cancel.isVisible());
        QCOMPARE(row.sizeHint(), before);
        row.setWorking(false);
        QVERIFY(!bar.isVisible() && !cancel.isVisible());
    }
    void progressIsShownAndStartsAgain()
    {
        ProgressRow row;
        const auto& bar = *row.findChild<QProgressBar*>();
        row.showProgress(0.25, "2 s left");
        QCOMPARE(row.sentence(), QString("2 s left"));
        QCOMPARE(bar.value(), bar.maximum() / 4);
        row.start();
        QCOMPARE(row.sentence(), QString("Starting…"));
        QCOMPARE(bar.value(), 0);
        row.tell("Done.");
        QCOMPARE(row.sentence(), QString("Done."));
    }
    void cancelIsAskedFor()
    {
        ProgressRow row;
        row.setWorking(true);
        const QSignalSpy asked(&row, &ProgressRow::cancelWanted);
        row.findChild<QPushButton*>()->click();
        QCOMPARE(asked.size(), 1);
    }
    void aLongSentenceDoesNotWidenTheRow()
    {
        ProgressRow row;
        const int before = row.sizeHint().width();
        row.tell(QString(1000, 'x'));
        QCOMPARE(row.sizeHint().width(), before);
    }
};

} // namespace widgets_progress_row_test

TEST_CLASS(widgets_progress_row_test::ProgressRowTest, Widgets)
#include "tests/ui/widgets/progress_row_test.moc"
