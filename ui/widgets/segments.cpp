// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/segments.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/widgets/spoken_role.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace ui {

namespace {

enum class Place : std::uint8_t { First, Middle, Last };

class Segment : public QToolButton {
public:
    Segment(const QString& text, Place place) : place_(place)
    {
        setText(text);
        setCheckable(true);
        setAutoExclusive(true); // as the group does: so that it is read as a radio button
        setFocusPolicy(Qt::TabFocus);
    }
    void setPicture(const QIcon& picture)
    {
        isPicture_ = true;
        setIcon(picture);
        setIconSize({pictureWidth, pictureHeight});
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override
    {
        if (isPicture_)
            return {std::max(pictureWidth, fontMetrics().horizontalAdvance(text())) + 10,
                    pictureHeight + fontMetrics().height() + 12};
        return {icon().isNull() ? fontMetrics().horizontalAdvance(text()) + 20 : 32,
                space::fieldHeight};
    }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent*) override
    {
        const Look& look = lookOf(palette());
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        // One outline around all buttons: each paints its part, shared sides once.
        QRectF box = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
        if (place_ != Place::First)
            box.setLeft(-4);
        if (place_ != Place::Last)
            box.setRight(width() + 4);
        QPainterPath outline;
        outline.addRoundedRect(box, space::radius, space::radius);
        painter.fillPath(outline, isChecked() ? look.tint : underMouse() ? look.hover : look.base);
        painter.strokePath(outline, QPen(isEnabled() ? look.control : look.border, 1));
        if (place_ != Place::First)
            painter.fillRect(0, 0, 1, height(), isEnabled() ? look.control : look.border);
        if (isChecked())
            painter.fillRect(0, height() - 2, width(), 2, look.selection);
        if (hasFocus()) {
            painter.setPen(QPen(look.selection, 2));
            painter.drawRect(rect().adjusted(1, 1, -1, -1));
        }
        if (isPicture_) {
            const int under = height() - fontMetrics().height() - 5;
            icon().paint(&painter, {(width() - pictureWidth) / 2, 5, pictureWidth, pictureHeight});
            painter.setPen(palette().color(QPalette::WindowText));
            return painter.drawText(QRect(0, under, width(), fontMetrics().height()),
                                    Qt::AlignCenter, text());
        }
        if (!icon().isNull()) {
            QRect middle({}, iconSize());
            middle.moveCenter(rect().center());
            return icon().paint(&painter, middle, Qt::AlignCenter,
                                isEnabled() ? QIcon::Normal : QIcon::Disabled);
        }
        painter.setPen(palette().color(QPalette::WindowText)); // fainter while disabled
        painter.drawText(rect(), Qt::AlignCenter, text());
    }

private:
    static constexpr int pictureWidth = 26, pictureHeight = 20;

    Place place_;
    bool isPicture_ = false; ///< the icon is above the text, not instead of it
};

} // namespace

Segments::Segments(const QString& name, const QStringList& choices, QWidget* parent)
    : QWidget(parent)
{
    setSpokenRole(*this, QAccessible::Grouping);
    setAccessibleName(name);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    for (int i = 0; i < choices.size(); ++i) {
        auto* button = new Segment(choices[i], i == 0                    ? Place::First
                                               : i + 1 == choices.size() ? Place::Last
                                                                         : Place::Middle);
        button->setAccessibleName(name + QStringLiteral(": ") + choices[i]);
        row->addWidget(button);
        group_.addButton(button, i);
    }
    setFocusPolicy(Qt::TabFocus); // with the proxy: so that setTabOrder() moves all buttons
    setFocusProxy(group_.button(0));
    connect(&group_, &QButtonGroup::idClicked, this, [this](int id) {
        if (isAncestorOf(QApplication::focusWidget())) // no ring beside what was clicked
            group_.button(id)->setFocus();
        emit picked(id);
    });
    choose(0);
}

void Segments::setIcons(const std::vector<std::string_view>& keys)
{
    for (std::size_t i = 0; i < keys.size(); ++i) {
        QAbstractButton* button = group_.button(int(i));
        button->setIcon(icon(keys[i]));
        button->setIconSize({18, 18});
        button->setToolTip(button->text());
    }
}

void Segments::setPictures(const std::vector<QIcon>& pictures)
{
    for (std::size_t i = 0; i < pictures.size(); ++i)
        static_cast<Segment*>(group_.button(int(i)))->setPicture(pictures[i]);
}

void Segments::setTips(const QStringList& tips)
{
    tips_ = tips;
    for (int i = 0; i < tips.size(); ++i)
        group_.button(i)->setToolTip(tips[i]);
}

void Segments::setReason(int index, const QString& why)
{
    QAbstractButton* button = group_.button(index);
    button->setEnabled(why.isEmpty());
    button->setToolTip(why.isEmpty() ? tips_.value(index, button->text()) : why);
}

void Segments::choose(int index) { group_.button(index)->setChecked(true); }

void Segments::chooseNone()
{
    group_.setExclusive(false);
    for (QAbstractButton* button : group_.buttons())
        button->setChecked(false);
    group_.setExclusive(true);
}

} // namespace ui

#include "moc_segments.cpp"
