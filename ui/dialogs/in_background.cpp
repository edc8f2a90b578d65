// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/in_background.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QProgressDialog>
#include <QThread>
#include <QTimer>

namespace ui {

namespace {

constexpr int patienceMilliseconds = 500;

} // namespace

bool runInBackground(QWidget* parent, const QString& label, std::function<void()> work)
{
    auto* thread = QThread::create(std::move(work));
    QEventLoop loop;
    QProgressDialog progress(label, QCoreApplication::translate("Progress", "Cancel"), 0, 0,
                             parent);
    progress.setWindowModality(Qt::ApplicationModal);
    progress.setMinimumDuration(0);
    progress.reset(); // otherwise it would appear by its own rule
    QTimer patience;
    patience.setSingleShot(true);
    bool finished = false;
    QObject::connect(&patience, &QTimer::timeout, &progress, &QWidget::show);
    QObject::connect(&progress, &QProgressDialog::canceled, &loop, &QEventLoop::quit);
    QObject::connect(thread, &QThread::finished, &loop, [&] {
        finished = true;
        loop.quit();
    });
    QObject::connect(thread, &QThread::finished, thread, &QObject::deleteLater);
    QObject::connect(qApp, &QCoreApplication::aboutToQuit, thread, [thread] { thread->wait(); });
    patience.start(patienceMilliseconds);
    thread->start();
    // The drawing must not change meanwhile, so input waits until the dialog is visible.
    while (!finished && !progress.wasCanceled() && !progress.isVisible())
        loop.processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
    if (!finished && !progress.wasCanceled())
        loop.exec();
    return finished;
}

} // namespace ui
