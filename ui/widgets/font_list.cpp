// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/font_list.h"

#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"
#include "app/view/outline.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QAbstractItemView>
#include <QFontDatabase>
#include <QPainter>
#include <QPainterPath>
#include <QStandardItemModel>
#include <QStyledItemDelegate>

namespace ui {
namespace {

constexpr int popupWidth = 280, mostVisible = 16, minimumLength = 12;
constexpr double capital = 0.5; ///< the height of capitals of strokes, of a row's

/// Writes each name in its own letters, where these are Latin.
class FontDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        (void)option, (void)index; // asking each font for its width would load it
        return {popupWidth, space::rowHeight};
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        const QString font = index.data(Qt::UserRole).toString();
        if (!font.isEmpty() && !app::findStrokeFont(font)
            && QFontDatabase::writingSystems(font).contains(QFontDatabase::Latin))
            option->font.setFamilies({font, option->font.family()});
        option->fontMetrics = QFontMetrics(option->font);
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const QString font = index.data(Qt::UserRole).toString();
        if (!app::findStrokeFont(font))
            return QStyledItemDelegate::paint(painter, option, index);
        QStyleOptionViewItem row(option);
        initStyleOption(&row, index);
        const QStyle& style = *row.widget->style();
        const QRectF room = style.subElementRect(QStyle::SE_ItemViewItemText, &row, row.widget);
        row.text.clear();
        style.drawControl(QStyle::CE_ItemViewItem, &row, painter, row.widget);
        const double height = std::round(capital * QFontMetricsF(row.font).height());
        const auto letters =
            app::lettered({font, font, height, {room.left() + 2, room.center().y() + height / 2}});
        const bool chosen = row.state & QStyle::State_Selected;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(
            QPen(row.palette.color(chosen ? QPalette::HighlightedText : QPalette::Text), 1));
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(app::painterPath(letters.paths, app::FillRule::NonZero));
        painter->restore();
    }
};

} // namespace

FontList::FontList(QWidget* parent) : ToolList(parent)
{
    setAccessibleName(Text::tr("Font"));
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(minimumLength);
    setMaxVisibleItems(mostVisible);
    view()->setMinimumWidth(popupWidth);
    view()->setTextElideMode(Qt::ElideRight);
    setItemDelegate(new FontDelegate(this));
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

// Also a letter in the closed list chooses.
bool FontList::event(QEvent* event) { return takesLetter(*event) || ToolList::event(event); }

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
