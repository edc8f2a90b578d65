// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/files.h"

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet.h"
#include "tests/ui/files/slow_disk.h"
#include "tests/ui/test_window.h"

namespace ui {

inline const clipping::Window middle{{25, 25}, {75, 75}}, small{{40, 40}, {60, 60}};

/// A window with a changed drawing, of two lines unless another file is given.
struct Desk : TestWindow {
    explicit Desk(const QString& drawing = {})
    {
        TestWindow::open(drawing.isEmpty() ? twoLines() : drawing);
        show();
        change(middle);
    }
    app::Session& session() const { return window->session(); }
    Files& files() const { return window->files(); }
    void change(const clipping::Window& clip) const
    {
        session().history.push(windowStep(session().document, clip));
    }
    /// As the system sends it.
    void type(Qt::Key key, Qt::KeyboardModifiers with = {}) const
    {
        QTest::keyClick(window->windowHandle(), key, with);
    }
    void drop(const QString& file) const
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(window.get(), &enter);
        QDropEvent event(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QCoreApplication::sendEvent(window.get(), &event);
    }
    QString otherFile() const
    {
        return file("other.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' "
                                 "height='9mm'><path d='M0 0L5 5' stroke='#000'/></svg>");
    }
    clipping::Window savedWindow(const char* name = "two.svg") const
    {
        return app::sheetOf(app::readFile(path(name)).value->document).window;
    }
};

inline QWidget* waitingDialog()
{
    QWidget* modal = QApplication::activeModalWidget();
    return qobject_cast<WaitingDialog*>(modal);
}

inline void clickCancel()
{
    QTRY_VERIFY(waitingDialog());
    QTest::mouseClick(waitingDialog()->findChild<QPushButton*>(), Qt::LeftButton);
}

} // namespace ui
