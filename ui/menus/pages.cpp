// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/pages.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDialog>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace ui {

namespace {

QTextBrowser* openPage(MainWindow& window, const QString& title)
{
    auto* dialog = new QDialog(&window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    dialog->resize(620, 560);
    auto* page = new QTextBrowser;
    page->setFrameShape(QFrame::NoFrame);
    page->setOpenExternalLinks(true);
    page->document()->setDocumentMargin(20);
    page->setAccessibleName(title);
    auto* column = new QVBoxLayout(dialog);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(page);
    dialog->show();
    return page;
}

/// The first two shortcuts on a common keyboard; standard keys for copy and paste may include F13
/// and above.
QStringList keysOf(const QAction& action)
{
    QStringList keys;
    for (const QKeySequence& sequence : action.shortcuts())
        if (const auto key = sequence[0].key(); key < Qt::Key_F13 || key > Qt::Key_F35)
            keys << sequence.toString(QKeySequence::NativeText).toHtmlEscaped();
    return keys.mid(0, 2);
}

void addShortcuts(QString& rows, const QMenu& menu)
{
    for (const QAction* action : menu.actions()) {
        if (action->menu())
            addShortcuts(rows, *action->menu());
        if (action->shortcut().isEmpty())
            continue;
        QString name = action->text();
        rows += QStringLiteral("<tr><td style='padding:2px 24px 2px 0'>%1</td><td "
                               "style='padding:2px 0'>%2</td></tr>")
                    .arg(name.remove(u'&').remove(u'…').toHtmlEscaped(),
                         keysOf(*action).join(Text::tr(" or ")));
    }
}

} // namespace

void showShortcuts(MainWindow& window)
{
    QString text = QStringLiteral("<table>"); // one, so that the keys of all menus are aligned
    for (const QAction* top : window.menuBar()->actions()) {
        QString rows;
        addShortcuts(rows, *top->menu());
        QString name = top->text();
        if (!rows.isEmpty())
            text += QStringLiteral("<tr><td colspan='2'><h3>%1</h3></td></tr>%2")
                        .arg(name.remove(u'&'), rows);
    }
    text +=
        QStringLiteral("</table><h3>%1</h3><p>%2</p>")
            .arg(Text::tr("On the canvas"),
                 Text::tr(
                     "Wheel: zoom around the pointer. Middle button or Space and drag: move the "
                     "view. Alt and arrow keys: move the clip window; Shift: ten times as far. "
                     "Esc: one step back."));
    openPage(window, Text::tr("Keyboard shortcuts"))->setHtml(text);
}

void showAbout(MainWindow& window)
{
    openPage(window, Text::tr("About Clearcut"))
        ->setMarkdown(
            Text::tr(
                "# Clearcut %1\n\nAn editor for line art with a movable clip window, and the "
                "library "
                "that does the clipping. It grew out of D. Matthes, V. Drakopoulos: *Another "
                "Simple "
                "but Faster Method for 2D Line Clipping*, IJCGA 9, 2019.\n\nThe program is free "
                "software under the GNU General Public License, version 3 or later; the clipping "
                "library under the MIT licence; the samples are free for any use (CC0).\n\nThe "
                "letters "
                "of strokes are the Hershey Fonts, originally created by Dr. A. V. Hershey while "
                "working at the U. S. National Bureau of Standards. The format of the font data "
                "was "
                "originally created by James Hurt, Cognition, Inc., 900 Technology Park Drive, "
                "Billerica, MA 01821.\n\n%2")
                .arg(QCoreApplication::applicationVersion(), window.canvas().backendReason()));
}

} // namespace ui
