// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/font_list.h"

#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"
#include "ui/look/text.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QStandardItemModel>

namespace ui {
namespace {

constexpr int popupWidth = 280, mostVisible = 20, minimumLength = 12;

} // namespace

FontList::FontList(QWidget* parent) : ToolList(parent)
{
    setAccessibleName(Text::tr("Font"));
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(minimumLength);
    setMaxVisibleItems(mostVisible);
    view()->setMinimumWidth(popupWidth);
    view()->setTextElideMode(Qt::ElideRight);
}

// Only when it is first shown: asking the system for its fonts takes time.
void FontList::fill()
{
    addHeading(Text::tr("Single strokes, for plotters"));
    for (const app::StrokeFont& font : app::strokeFonts())
        addItem(font.name, font.name);
    if (app::outlineFonts().isEmpty())
        return;
    addHeading(Text::tr("Outlines, of installed fonts"));
    for (const QString& font : app::outlineFonts())
        addItem(font, font);
}

// A letter chooses a font, also where it is the key of a tool on the canvas.
bool FontList::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        const bool isCommand = key.modifiers() & (Qt::ControlModifier | Qt::AltModifier);
        if (!isCommand && !key.text().isEmpty() && key.text().front().isPrint()) {
            event->accept();
            return true;
        }
    }
    return ToolList::event(event);
}

void FontList::addHeading(const QString& text)
{
    addItem(text);
    const int row = count() - 1;
    qobject_cast<QStandardItemModel*>(model())->item(row)->setEnabled(false);
    QFont small = view()->font();
    small.setBold(true);
    setItemData(row, small, Qt::FontRole);
}

void FontList::show(const QString& font)
{
    if (count() == 0)
        fill();
    setPlaceholderText(font);
    setCurrentIndex(findData(font));
    const bool strokes = app::findStrokeFont(font);
    setToolTip(strokes          ? Text::tr("Font: single strokes, which a plotter follows once")
               : font.isEmpty() ? Text::tr("Font")
                                : Text::tr("Font: outlines, filled or stroked as the style says"));
}

QString FontList::font() const { return currentData().toString(); }

} // namespace ui

#include "moc_font_list.cpp"
