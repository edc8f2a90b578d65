// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_style.h"

#include "ui/look/look.h"

#include <QCheckBox>
#include <QDateTime>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPainterPath>
#include <QRadioButton>
#include <QStyleOption>
#include <QToolBar>

namespace ui {

namespace {

constexpr int chevronWidth = 22;

bool has(const QStyleOption& option, QStyle::StateFlag flag) { return option.state & flag; }

/// Paints a rounded field or button: its background, and a border that becomes the focus ring.
void drawBox(QPainter& painter, const QRect& rect, const QColor& ground, const QColor& border,
             double width = 1)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(border, width));
    painter.setBrush(ground);
    const double inset = width / 2;
    painter.drawRoundedRect(QRectF(rect).adjusted(inset, inset, -inset, -inset), space::radius,
                            space::radius);
    painter.restore();
}

void drawField(QPainter& painter, const QStyleOption& option, const QRect& rect)
{
    const Look& look = lookOf(option.palette);
    const bool focus = has(option, QStyle::State_HasFocus) && has(option, QStyle::State_Enabled);
    const bool enabled = has(option, QStyle::State_Enabled);
    drawBox(painter, rect, enabled ? look.base : look.window,
            focus     ? look.selection
            : enabled ? look.control
                      : look.border,
            focus ? 2 : 1);
}

void drawChevron(QPainter& painter, const QRect& rect, const QColor& colour, double towards)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.25, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const QPointF c = QRectF(rect).center();
    const double w = rect.height() > 16 ? 3.5 : 2.5;
    painter.drawPolyline(QPolygonF{{c.x() - w, c.y() - w / 2 * towards},
                                   {c.x(), c.y() + w / 2 * towards},
                                   {c.x() + w, c.y() - w / 2 * towards}});
    painter.restore();
}

/// The part of a bar that is filled: up to its value, or a quarter that travels to and fro.
QRect filledPart(const QStyleOptionProgressBar& bar)
{
    constexpr int thereAndBack = 3000; // ms
    QRect filled = bar.rect;
    const int values = bar.maximum - bar.minimum;
    if (values > 0) {
        filled.setWidth(int(bar.rect.width() * double(bar.progress - bar.minimum) / values));
        return filled;
    }
    const double time = double(QDateTime::currentMSecsSinceEpoch() % thereAndBack) / thereAndBack;
    const double share = 1 - std::abs(2 * time - 1); // from 0 to 1 and back
    filled.setWidth(bar.rect.width() / 4);
    filled.translate(int((bar.rect.width() - filled.width()) * share), 0);
    return filled;
}

void drawProgress(QPainter& painter, const QStyleOptionProgressBar& bar)
{
    const QRect filled = filledPart(bar);
    if (filled.width() > 2 * space::radius)
        drawBox(painter, filled, lookOf(bar.palette).selection, lookOf(bar.palette).selection);
}

void drawButton(QPainter& painter, const QStyleOption& option)
{
    const Look& look = lookOf(option.palette);
    const bool enabled = has(option, QStyle::State_Enabled);
    const bool hovered = has(option, QStyle::State_MouseOver) && enabled;
    const bool down = has(option, QStyle::State_Sunken) || has(option, QStyle::State_On);
    const bool focus = has(option, QStyle::State_HasFocus) && enabled;
    drawBox(painter, option.rect,
            down      ? look.tint
            : hovered ? look.hover
                      : look.base,
            focus     ? look.selection
            : enabled ? look.control
                      : look.border,
            focus ? 2 : 1);
}

/// Flat unless hovered; a checked button has the tint and a border in the selection colour.
void drawToolButton(QPainter& painter, const QStyleOption& option)
{
    const Look& look = lookOf(option.palette);
    const bool on = has(option, QStyle::State_On);
    const bool enabled = has(option, QStyle::State_Enabled);
    if (on)
        drawBox(painter, option.rect, look.tint, look.selection);
    else if (enabled && (has(option, QStyle::State_Sunken) || has(option, QStyle::State_MouseOver)))
        drawBox(painter, option.rect, look.hover, look.hover);
}

void drawFocusRing(QPainter& painter, const QStyleOption& option)
{
    drawBox(painter, option.rect, Qt::transparent, lookOf(option.palette).selection, 2);
}

void drawCheck(QPainter& painter, const QStyleOption& option, double radius)
{
    const Look& look = lookOf(option.palette);
    const bool on = has(option, QStyle::State_On);
    const bool enabled = has(option, QStyle::State_Enabled);
    const QColor colour = !enabled ? look.border : on ? look.selection : look.control;
    const QRectF box = QRectF(option.rect).adjusted(0.75, 0.75, -0.75, -0.75);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colour, 1.5));
    painter.setBrush(on ? colour : look.base);
    painter.drawRoundedRect(box, radius, radius);
    if (on && radius > 4) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(look.onSelection);
        painter.drawEllipse(box.center(), 2.5, 2.5);
    } else if (on) {
        painter.setPen(QPen(look.onSelection, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPointF c = box.center();
        painter.drawPolyline(
            QPolygonF{c + QPointF(-3, 0.2), c + QPointF(-0.8, 2.4), c + QPointF(3.2, -2.6)});
    }
    painter.restore();
}

void drawTab(QPainter& painter, const QStyleOptionTab& tab)
{
    const Look& look = lookOf(tab.palette);
    const bool selected = has(tab, QStyle::State_Selected);
    const bool hovered = has(tab, QStyle::State_MouseOver);
    painter.fillRect(tab.rect, selected ? look.panel : hovered ? look.hover : look.window);
    if (selected)
        painter.fillRect(QRect(tab.rect.topLeft(), QSize(tab.rect.width(), 3)), look.selection);
    else
        painter.fillRect(QRect(tab.rect.bottomLeft(), QSize(tab.rect.width(), 1)), look.rule);
}

void drawTabLabel(QPainter& painter, const QStyleOptionTab& tab)
{
    const Look& look = lookOf(tab.palette);
    const bool selected = has(tab, QStyle::State_Selected);
    painter.save();
    painter.setFont(selected ? semiBold(painter.font()) : painter.font());
    painter.setPen(selected ? look.text : look.muted);
    painter.drawText(tab.rect, Qt::AlignCenter | Qt::TextShowMnemonic, tab.text);
    if (has(tab, QStyle::State_HasFocus))
        drawBox(painter, tab.rect.adjusted(2, 4, -2, -2), Qt::transparent, look.selection, 2);
    painter.restore();
}

/// One rule at the side towards the canvas.
void drawToolBar(QPainter& painter, const QStyleOption& option, const QWidget* widget)
{
    const Look& look = lookOf(option.palette);
    painter.fillRect(option.rect, look.window);
    const auto* bar = qobject_cast<const QToolBar*>(widget);
    const QRect r = option.rect;
    if (bar && bar->orientation() == Qt::Vertical)
        painter.fillRect(r.right(), r.top(), 1, r.height(), look.rule);
    else
        painter.fillRect(r.left(), r.bottom(), r.width(), 1, look.rule);
}

void drawBarSeparator(QPainter& painter, const QStyleOption& option)
{
    const Look& look = lookOf(option.palette);
    const QRect r = option.rect;
    if (has(option, QStyle::State_Horizontal))
        painter.fillRect(r.center().x(), r.top() + 8, 1, r.height() - 16, look.rule);
    else
        painter.fillRect(r.left() + 8, r.center().y(), r.width() - 16, 1, look.rule);
}

} // namespace

LookStyle::LookStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

void LookStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                              QPainter* painter, const QWidget* widget) const
{
    switch (element) {
    case PE_PanelButtonCommand:
        return drawButton(*painter, *option);
    case PE_PanelButtonTool:
        if (widget && widget->property("framed").toBool())
            return drawButton(*painter, *option);
        return drawToolButton(*painter, *option);
    case PE_FrameLineEdit:
        return;
    case PE_PanelLineEdit:
        if (const auto* frame = qstyleoption_cast<const QStyleOptionFrame*>(option);
            frame && frame->lineWidth > 0)
            return drawField(*painter, *option, option->rect);
        return;
    case PE_IndicatorCheckBox:
        return drawCheck(*painter, *option, 3);
    case PE_IndicatorRadioButton:
        return drawCheck(*painter, *option, 8);
    case PE_IndicatorToolBarSeparator:
        return drawBarSeparator(*painter, *option);
    case PE_IndicatorToolBarHandle:
    case PE_FrameStatusBarItem:
    case PE_FrameTabBarBase:
        return;             // bars have no frames
    case PE_FrameFocusRect: // the others paint their own rings
        if (qobject_cast<const QCheckBox*>(widget) || qobject_cast<const QRadioButton*>(widget))
            drawFocusRing(*painter, *option);
        return;
    case PE_PanelStatusBar:
    case PE_PanelMenuBar:
        return painter->fillRect(option->rect, option->palette.window());
    case PE_IndicatorDockWidgetResizeHandle:
        return painter->fillRect(option->rect, lookOf(option->palette).rule);
    default:
        return QProxyStyle::drawPrimitive(element, option, painter, widget);
    }
}

void LookStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                            const QWidget* widget) const
{
    const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option);
    const auto* progress = qstyleoption_cast<const QStyleOptionProgressBar*>(option);
    switch (element) {
    case CE_ProgressBarGroove:
        return drawBox(*painter, option->rect, lookOf(option->palette).base,
                       lookOf(option->palette).border);
    case CE_ProgressBarContents:
        if (progress)
            drawProgress(*painter, *progress);
        return;
    case CE_PushButtonBevel:
        return drawButton(*painter, *option);
    case CE_TabBarTabShape:
        if (tab)
            drawTab(*painter, *tab);
        return;
    case CE_TabBarTabLabel:
        if (tab)
            drawTabLabel(*painter, *tab);
        return;
    case CE_ToolBar:
        return drawToolBar(*painter, *option, widget);
    case CE_Splitter:
        return painter->fillRect(option->rect, lookOf(option->palette).rule);
    case CE_HeaderSection:
    case CE_HeaderEmptyArea:
        return painter->fillRect(option->rect, lookOf(option->palette).panel);
    case CE_MenuBarEmptyArea:
        return painter->fillRect(option->rect, option->palette.window());
    default:
        return QProxyStyle::drawControl(element, option, painter, widget);
    }
}

/// A framed button with a menu has a chevron, as lists have.
void LookStyle::drawMenuButton(const QStyleOptionToolButton& button, QPainter& painter,
                               const QWidget* widget) const
{
    drawButton(painter, button);
    const bool enabled = has(button, State_Enabled);
    const Look& look = lookOf(button.palette);
    QRect arrow = button.rect;
    arrow.setLeft(arrow.right() - chevronWidth);
    drawChevron(painter, arrow, enabled ? look.muted : look.border, 1);
    QStyleOptionToolButton label = button;
    label.features = QStyleOptionToolButton::None;
    label.rect.setRight(arrow.left());
    drawControl(CE_ToolButtonLabel, &label, &painter, widget);
}

void LookStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                   QPainter* painter, const QWidget* widget) const
{
    const Look& look = lookOf(option->palette);
    const QColor mark = has(*option, State_Enabled) ? look.muted : look.border;
    if (control == CC_SpinBox) {
        const auto* field = qstyleoption_cast<const QStyleOptionSpinBox*>(option);
        if (!field || field->frame || has(*option, State_HasFocus) || has(*option, State_MouseOver))
            drawField(*painter, *option, option->rect);
        if (field && field->buttonSymbols == QAbstractSpinBox::NoButtons)
            return;
        const QRect up = subControlRect(CC_SpinBox, option, SC_SpinBoxUp, widget);
        const QRect down = subControlRect(CC_SpinBox, option, SC_SpinBoxDown, widget);
        painter->fillRect(up.left(), option->rect.top() + 5, 1, option->rect.height() - 10,
                          look.rule);
        drawChevron(*painter, up, mark, -1);
        drawChevron(*painter, down, mark, 1);
    } else if (control == CC_ComboBox) {
        const auto* list = qstyleoption_cast<const QStyleOptionComboBox*>(option);
        if (!list || list->frame || has(*option, State_HasFocus) || has(*option, State_MouseOver))
            drawField(*painter, *option, option->rect);
        drawChevron(*painter, subControlRect(CC_ComboBox, option, SC_ComboBoxArrow, widget), mark,
                    1);
    } else if (const auto* button = qstyleoption_cast<const QStyleOptionToolButton*>(option);
               button && button->features & QStyleOptionToolButton::HasMenu && widget
               && widget->property("framed").toBool()) {
        drawMenuButton(*button, *painter, widget);
    } else {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        const bool framed = widget && widget->property("framed").toBool(); // has a ring
        if (control == CC_ToolButton && has(*option, State_HasFocus) && !framed)
            drawFocusRing(*painter, *option);
    }
}

int LookStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                           const QWidget* widget) const
{
    switch (metric) {
    case PM_DockWidgetSeparatorExtent:
        return 1;
    case PM_DockWidgetFrameWidth:
    case PM_ToolBarFrameWidth:
    case PM_TabBarBaseOverlap:
        return 0;
    case PM_ToolBarItemSpacing:
        return 4;
    case PM_ToolBarHandleExtent:
        return 6;
    case PM_ToolBarSeparatorExtent:
        return 16;
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
        return 14;
    case PM_ExclusiveIndicatorWidth:
    case PM_ExclusiveIndicatorHeight:
        return 15;
    case PM_TabBarTabHSpace:
        return 18;
    default:
        return QProxyStyle::pixelMetric(metric, option, widget);
    }
}

QSize LookStyle::sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& size,
                                  const QWidget* widget) const
{
    QSize answer = QProxyStyle::sizeFromContents(type, option, size, widget);
    if (type == CT_ComboBox || type == CT_SpinBox || type == CT_LineEdit || type == CT_PushButton)
        answer.setHeight(std::max(space::fieldHeight, size.height() + 6));
    if (type == CT_TabBarTab)
        answer.setHeight(space::dockTitleHeight + 2);
    return answer;
}

static bool turnsWithTheWheel(const QWidget* widget)
{
    return qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QComboBox*>(widget)
           || qobject_cast<const QTabBar*>(widget);
}

void LookStyle::polish(QWidget* widget)
{
    QProxyStyle::polish(widget);
    // Also of the label of a tooltip: names of files and layers are other people's.
    if (auto* label = qobject_cast<QLabel*>(widget); label && label->textFormat() == Qt::AutoText)
        label->setTextFormat(Qt::PlainText);
    if (!turnsWithTheWheel(widget))
        return;
    if (widget->focusPolicy() == Qt::WheelFocus)
        widget->setFocusPolicy(Qt::StrongFocus); // the wheel would give it the focus first
    widget->installEventFilter(this);
}

void LookStyle::unpolish(QWidget* widget)
{
    if (turnsWithTheWheel(widget))
        widget->removeEventFilter(this);
    QProxyStyle::unpolish(widget);
}

bool LookStyle::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() != QEvent::Wheel || static_cast<QWidget*>(watched)->hasFocus())
        return QProxyStyle::eventFilter(watched, event);
    event->ignore(); // it goes to the parent
    return true;
}

int LookStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                         QStyleHintReturn* answer) const
{
    switch (hint) {
    case SH_EtchDisabledText:
        return 0;
    case SH_UnderlineShortcut:
        return 1;
    case SH_ItemView_ActivateItemOnSingleClick:
        return qobject_cast<const QListWidget*>(widget) != nullptr; // recent files
    case SH_ComboBox_Popup:
        return 0;
    default:
        return QProxyStyle::styleHint(hint, option, widget, answer);
    }
}

} // namespace ui

#include "moc_look_style.cpp"
