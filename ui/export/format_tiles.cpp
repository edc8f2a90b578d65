// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/format_tiles.h"

#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QAbstractButton>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace ui {

namespace {

constexpr int roomForFour = 340;   // pixels of the whole section; with less three are in a row
constexpr QSize leastTile(66, 42); // pixels
constexpr int inset = 7;

class Tile : public QAbstractButton {
public:
    Tile(const QString& name, const QString& purpose) : purpose_(purpose)
    {
        setText(name);
        setAccessibleDescription(purpose);
        setCheckable(true);
        setAttribute(Qt::WA_Hover);
        setFocusPolicy(Qt::StrongFocus);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override { return leastTile; }
    QSize minimumSizeHint() const override { return leastTile; }

protected:
    void paintEvent(QPaintEvent*) override
    {
        const Look& look = lookOf(palette());
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const bool strong = isChecked() || hasFocus();
        const double pen = hasFocus() ? 2 : 1;
        painter.setPen(QPen(strong ? look.selection : look.control, pen));
        painter.setBrush(isChecked() || isDown() ? look.tint
                         : underMouse()          ? look.hover
                                                 : look.base);
        painter.drawRoundedRect(QRectF(rect()).adjusted(pen / 2, pen / 2, -pen / 2, -pen / 2),
                                space::radius, space::radius);
        const QRect above(inset, 3, width() - 2 * inset, height() / 2 - 2);
        painter.setPen(look.text);
        painter.setFont(isChecked() ? semiBold(font()) : font());
        painter.drawText(above, Qt::AlignVCenter, text());
        painter.setPen(look.muted);
        painter.setFont(captionFont(font()));
        const QRect below(inset, height() / 2, above.width(), height() / 2 - 3);
        painter.drawText(below, Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(purpose_, Qt::ElideRight, below.width()));
    }

private:
    QString purpose_;
};

} // namespace

FormatTiles::FormatTiles(QWidget* parent)
    : ExportSection(Text::tr("Format"), parent), formats_(app::exportFormats()),
      tiles_(new QGridLayout)
{
    tiles_->setSpacing(6);
    for (std::size_t i = 0; i < formats_.size(); ++i) {
        const app::Format& format = *formats_[i];
        auto* tile = new Tile(format.shortName(), format.purpose);
        tile->setObjectName(QStringLiteral("export-as-") + app::latin(format.key));
        tile->setToolTip(format.limits.isEmpty()
                             ? format.name
                             : Text::tr("%1: at most %2").arg(format.name, format.limits));
        group_.addButton(tile, int(i));
    }
    grid().addLayout(tiles_, 1, 0, 1, 2);
    lay(4);
    connect(&group_, &QButtonGroup::idClicked, this,
            [this](int id) { emit picked(*formats_[std::size_t(id)]); });
}

void FormatTiles::lay(int inRow)
{
    if (std::exchange(inRow_, inRow) == inRow)
        return;
    for (std::size_t i = 0; i < formats_.size(); ++i)
        tiles_->addWidget(group_.button(int(i)), int(i) / inRow, int(i) % inRow);
}

void FormatTiles::resizeEvent(QResizeEvent* event)
{
    ExportSection::resizeEvent(event);
    lay(width() < roomForFour ? 3 : 4);
}

void FormatTiles::choose(const app::Format& format)
{
    const auto found = std::ranges::find(formats_, &format);
    if (found != formats_.end())
        group_.button(int(found - formats_.begin()))->setChecked(true);
}

} // namespace ui

#include "moc_format_tiles.cpp"
