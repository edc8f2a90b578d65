// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>

#include "tests/ui/test_window.h"

namespace ui {

/// The editor with a drawing and one of the sheets that write it (`live()` makes what is written).
template <class Shown>
class OutputDesk : public TestWindow {
public:
    OutputDesk(const char* command, const QString& name, const QByteArray& drawing)
        : command_(command)
    {
        open(file(name, drawing));
        show();
    }
    Shown& openSheet()
    {
        run(command_);
        settle();
        return sheet();
    }
    Shown& sheet() { return static_cast<Shown&>(*window->sheet()); }
    void settle()
    {
        sheet().live().wait();
        QCoreApplication::processEvents();
    }
    template <class Widget = QWidget>
    Widget& part(const char* name)
    {
        // A sheet that was closed may be there still.
        auto* found = window->sheet() ? window->sheet()->findChild<Widget*>(name) : nullptr;
        if (!found)
            found = window->findChild<Widget*>(name);
        if (!found)
            qFatal("there is no %s", name);
        return *found;
    }

private:
    const char* command_;
};

} // namespace ui
