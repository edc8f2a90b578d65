// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/application.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"
#include "app/judge/child.h"
#include "ui/editor/editor.h"

int main(int argc, char** argv)
{
    app::holdStandardStreams();
    app::refuseLongFiles();
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    if (app::plug_in::isChild(arguments))
        return app::plug_in::runChild(arguments);
    if (app::isCommandLine(arguments)) {
        const auto application = app::applicationFor(arguments, argc, argv);
        return app::runCommandLine(arguments);
    }
    return ui::runEditor(argc, argv, arguments);
}
