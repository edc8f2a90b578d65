// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/panel_layout.h"

#include <QLabel>
#include <QMainWindow>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

namespace ui {

/// A panel without content, of a given height.
class PlainPanel : public QLabel {
public:
    int least = 60, wanted = 100; ///< heights in logical pixels

    QSize sizeHint() const override { return {200, wanted}; }
    QSize minimumSizeHint() const override { return {100, least}; }
};

/// A window with plain panels, and settings of its own.
class PlainWindow {
public:
    PlainWindow()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
        QCoreApplication::setOrganizationName("Clearcut");
        QCoreApplication::setApplicationName("Clearcut");
        window.setCentralWidget(new QWidget);
        layout = std::make_unique<PanelLayout>(window, docks);
        window.resize(1280, 900);
    }

    void show()
    {
        layout->restore();
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        QCoreApplication::processEvents();
    }
    /// Makes the window so low that clip windows and layers share a place.
    void beLow()
    {
        for (const char* key : {"window", "layers"})
            panel(dock(key)).least = 300;
        window.resize(1280, 640);
        QCoreApplication::processEvents();
        layout->fit();
    }
    /// The panels that are in front, by their keys.
    QStringList inFront() const
    {
        QCoreApplication::processEvents();
        QStringList keys;
        for (const Dock* dock : docks.all())
            if (dock->isVisible() && !dock->isBehind())
                keys << dock->objectName();
        return keys;
    }
    Dock& dock(const QString& key) const { return *docks.named({key}).front(); }
    static PlainPanel& panel(const Dock& dock) { return static_cast<PlainPanel&>(dock.body()); }

private:
    static Dock* plain(const char* key)
    {
        return new Dock(key, QLatin1StringView(key), new PlainPanel);
    }

    QTemporaryDir folder_;

public:
    QMainWindow window;
    PanelDocks docks{plain("start"),
                     {plain("algorithm"), plain("window"), plain("cut-edges"), plain("properties"),
                      plain("line"), plain("layers"), plain("history")},
                     {plain("compare"), plain("difference")}};
    std::unique_ptr<PanelLayout> layout;
};

} // namespace ui
