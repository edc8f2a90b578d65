// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/in_background.h"

#include <QApplication>
#include <QProgressDialog>
#include <QPushButton>
#include <QTest>
#include <QThread>
#include <QTimer>

namespace {

QProgressDialog* shownDialog()
{
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<QProgressDialog*>(widget); dialog && dialog->isVisible())
            return dialog;
    return nullptr;
}

} // namespace

class InBackgroundTest : public QObject {
    Q_OBJECT

private slots:
    void quickWorkShowsNothing()
    {
        bool seen = false;
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [&] { seen = seen || shownDialog(); });
        watch.start(5);
        const auto answer = ui::inBackground(nullptr, "Working…", [] {
            QThread::msleep(50);
            return 42;
        });
        QCOMPARE(answer.value_or(0), 42);
        QVERIFY(!seen);
    }
    void slowWorkShowsADialogAndEnds()
    {
        bool seen = false;
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [&] { seen = seen || shownDialog(); });
        watch.start(5);
        const auto answer = ui::inBackground(nullptr, "Working…", [] {
            QThread::msleep(900);
            return 42;
        });
        QCOMPARE(answer.value_or(0), 42);
        QVERIFY(seen);
    }
    void cancellingGivesNothing()
    {
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [] {
            if (QProgressDialog* dialog = shownDialog())
                QTest::mouseClick(dialog->findChild<QPushButton*>(), Qt::LeftButton);
        });
        watch.start(5);
        const auto answer = ui::inBackground(nullptr, "Working…", [] {
            QThread::msleep(2000);
            return 42;
        });
        QVERIFY(!answer);
    }
};

QTEST_MAIN(InBackgroundTest)
#include "in_background_test.moc"
