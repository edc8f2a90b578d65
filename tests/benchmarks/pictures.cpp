// SPDX-License-Identifier: GPL-3.0-or-later
// Saves how the editor's window shows a drawing, light and dark, with one pane and with four. What
// differs between two runs, the times of frames, is covered: pictures FILE FOLDER
#include "app/base/background.h"
#include "app/settings/settings_format.h"
#include "ui/files/files.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QDir>
#include <QEventLoop>
#include <QPainter>
#include <QSettings>
#include <QTemporaryDir>
#include <QThreadPool>
#include <QTimer>

namespace {

const QStringList timed{QStringLiteral("ui::StatusBar"), QStringLiteral("ui::PaneHeading")};

QPixmap pictureOf(ui::MainWindow& window)
{
    constexpr int forVerdict =
        700; // milliseconds; panels compute when nothing has changed for a while
    for (int i = 0; i < 2; ++i) {
        QEventLoop loop;
        QTimer::singleShot(forVerdict, &loop, &QEventLoop::quit);
        loop.exec();
        app::paintingThreads().waitForDone();
    }
    window.canvas().settle();
    QCoreApplication::processEvents();
    QPixmap picture = window.grab();
    QPainter painter(&picture);
    for (const QWidget* widget : window.findChildren<QWidget*>())
        if (timed.contains(QLatin1StringView(widget->metaObject()->className())))
            painter.fillRect(QRect(widget->mapTo(&window, QPoint()), widget->size()), Qt::gray);
    return picture;
}

// Another window for each picture: none shows what was done before it.
bool save(const QString& drawing, ui::Theme theme, std::size_t panes, const QString& picture)
{
    ui::applyTheme(*qApp, theme);
    ui::MainWindow window(ui::Backend::Raster);
    ui::addMenus(window);
    window.resize(1280, 800);
    app::Panes many = window.canvas().panes();
    many.show(panes);
    window.canvas().setPanes(many);
    window.files().open(drawing);
    window.files().wait();
    window.show();
    QCoreApplication::processEvents();
    return pictureOf(window).save(picture);
}

} // namespace

int main(int argc, char** argv)
{
    const QTemporaryDir own; // neither shows the user's settings nor changes them
    qputenv("XDG_RUNTIME_DIR", own.path().toLocal8Bit());
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Clearcut"));
    QCoreApplication::setApplicationName(QStringLiteral("Clearcut"));
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, own.path());
    app::useSafeSettings();
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 3)
        qFatal("Usage: pictures FILE FOLDER");
    const QDir folder(arguments[2]);
    for (const auto& [name, theme] :
         {std::pair("light", ui::Theme::Light), std::pair("dark", ui::Theme::Dark)})
        for (const std::size_t panes : {1U, 4U})
            if (!save(arguments[1], theme, panes,
                      folder.filePath(QStringLiteral("%1-%2.png").arg(name).arg(panes))))
                qFatal("Cannot write to %s", qPrintable(folder.path()));
}
