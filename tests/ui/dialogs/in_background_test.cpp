// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/in_background.h"

#include <QApplication>
#include <QProgressDialog>
#include <QPushButton>
#include <QSemaphore>
#include <QTest>
#include <QTimer>

#include <memory>

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
        const auto answer = ui::inBackground(nullptr, "Working…", [] { return 42; });
        QCOMPARE(answer.value_or(0), 42);
        QVERIFY(!seen);
    }
    void slowWorkShowsADialogAndEnds()
    {
        auto seen = std::make_shared<QSemaphore>();
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [&] {
            if (!shownDialog())
                return;
            watch.stop();
            seen->release();
        });
        watch.start(5);
        const auto answer = ui::inBackground(nullptr, "Working…", [seen] {
            seen->acquire(); // until the dialog is visible
            return 42;
        });
        QCOMPARE(answer.value_or(0), 42);
    }
    void aCancelledJobGivesNoResult()
    {
        QTimer watch;
        connect(&watch, &QTimer::timeout, this, [] {
            if (QProgressDialog* dialog = shownDialog())
                QTest::mouseClick(dialog->findChild<QPushButton*>(), Qt::LeftButton);
        });
        watch.start(5);
        auto over = std::make_shared<QSemaphore>();
        const auto answer = ui::inBackground(nullptr, "Working…", [over] {
            over->acquire();
            return 42;
        });
        QVERIFY(!answer);
        over->release(); // the thread ends without a result
    }
};

QTEST_MAIN(InBackgroundTest)
#include "in_background_test.moc"
