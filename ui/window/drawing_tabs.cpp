// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/drawing_tabs.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAbstractButton>
#include <QGuiApplication>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>
#include <QTabBar>
#include <QToolButton>

#include <utility>

namespace ui {

namespace {

constexpr int barHeight = 28, leastWidth = 96, mostWidth = 220, markSize = 18;
constexpr double dotRadius = 3.5;

/// A dot: unsaved changes. Under the pointer, a cross that closes the tab; of the other tabs
/// nothing, unless the pointer is on them.
class TabMark : public QAbstractButton {
public:
    TabMark(QTabBar& bar, bool modified) : QAbstractButton(&bar), bar_(bar), modified_(modified)
    {
        setFixedSize(markSize, markSize);
        setFocusPolicy(Qt::NoFocus);
        setToolTip(Text::tr("Close this drawing (Ctrl+W)"));
        setAccessibleName(Text::tr("Close"));
    }

protected:
    void enterEvent(QEnterEvent*) override { update(); }
    void leaveEvent(QEvent*) override { update(); }

    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const Look& look = lookOf(palette());
        if (underMouse()) {
            painter.fillRect(rect(), look.hover);
            return ui::icon("close").paint(&painter, rect().adjusted(3, 3, -3, -3));
        }
        const bool hovered =
            bar_.tabAt(bar_.mapFromGlobal(QCursor::pos())) == bar_.tabAt(geometry().center());
        if (modified_) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(look.text);
            painter.drawEllipse(QRectF(rect()).center(), dotRadius, dotRadius);
        } else if (hovered && bar_.underMouse()) {
            ui::icon("close").paint(&painter, rect().adjusted(3, 3, -3, -3));
        }
    }

private:
    QTabBar& bar_;
    bool modified_;
};

} // namespace

/// As wide as the names, within limits. The middle button closes a tab.
class TabBar : public QTabBar {
public:
    explicit TabBar(DrawingTabs& tabs) : tabs_(tabs) { setMouseTracking(true); }

    void mark(int tab)
    {
        if (std::exchange(marked_, tab) != tab)
            update();
    }

protected:
    QSize tabSizeHint(int tab) const override
    {
        QFont bold = semiBold(font()); // the current one is
        const int text = QFontMetrics(bold).horizontalAdvance(tabText(tab));
        return {std::clamp(text + markSize + 30, leastWidth, mostWidth), barHeight};
    }
    QSize minimumTabSizeHint(int) const override { return {leastWidth, barHeight}; }

    void mouseReleaseEvent(QMouseEvent* event) override
    {
        if (const int tab = tabAt(event->pos()); event->button() == Qt::MiddleButton && tab >= 0)
            return emit tabs_.closeWanted(tab);
        QTabBar::mouseReleaseEvent(event);
        if (event->button() == Qt::LeftButton) // not before: it may be dragged
            emit tabs_.chosen(currentIndex());
    }

    void paintEvent(QPaintEvent* event) override
    {
        QTabBar::paintEvent(event);
        if (marked_ < 0)
            return;
        QPainter painter(this);
        painter.setPen(QPen(lookOf(palette()).accent, 2));
        painter.drawRect(tabRect(marked_).adjusted(1, 1, -1, -1));
    }

private:
    DrawingTabs& tabs_;
    int marked_ = -1;
};

DrawingTabs::DrawingTabs(QWidget* parent)
    : QToolBar(Text::tr("Open drawings"), parent), bar_(new TabBar(*this))
{
    setObjectName(QStringLiteral("drawings"));
    setMovable(false);
    setFloatable(false);
    setFixedHeight(barHeight);
    setContentsMargins(0, 0, 0, 0);
    bar_->setObjectName(QStringLiteral("drawing-tabs"));
    bar_->setAccessibleName(Text::tr("Open drawings"));
    bar_->setDrawBase(false);
    bar_->setExpanding(false);
    bar_->setMovable(true);
    bar_->setElideMode(Qt::ElideMiddle);
    bar_->setFocusPolicy(Qt::NoFocus); // Ctrl+Tab serves the keyboard
    bar_->setUsesScrollButtons(true);
    addWidget(bar_);
    auto* more = new QToolButton;
    more->setIcon(icon("plus"));
    more->setAutoRaise(true);
    more->setFixedSize(barHeight, barHeight);
    more->setFocusPolicy(Qt::NoFocus);
    more->setToolTip(Text::tr("New drawing (Ctrl+N)"));
    more->setAccessibleName(Text::tr("New drawing"));
    addWidget(more);
    connect(more, &QToolButton::clicked, this, &DrawingTabs::newWanted);
    connect(bar_, &QTabBar::tabMoved, this, &DrawingTabs::moved);
    hide();
}

int DrawingTabs::tabAt(const QPoint& onScreen) const
{
    return isVisible() ? bar_->tabAt(bar_->mapFromGlobal(onScreen)) : -1;
}

void DrawingTabs::mark(int tab) { bar_->mark(tab); }

void DrawingTabs::show(const std::vector<DrawingTab>& tabs, int current)
{
    const QSignalBlocker quiet(bar_);
    while (bar_->count() > int(tabs.size()))
        bar_->removeTab(bar_->count() - 1);
    while (bar_->count() < int(tabs.size()))
        bar_->addTab({});
    shown_.resize(tabs.size());
    for (int i = 0; i < int(tabs.size()); ++i) {
        const DrawingTab& tab = tabs[std::size_t(i)];
        QString text = tab.name;
        bar_->setTabText(i, text.replace(u'&', QStringLiteral("&&")));
        bar_->setTabToolTip(i, tab.tip);
        bar_->setAccessibleTabName(i, tab.modified ? Text::tr("%1, not saved").arg(tab.name)
                                                   : tab.name);
        DrawingTab& before = shown_[std::size_t(i)];
        if (before != tab || !bar_->tabButton(i, QTabBar::RightSide)) {
            if (QWidget* old = bar_->tabButton(i, QTabBar::RightSide))
                old->deleteLater();
            auto* mark = new TabMark(*bar_, tab.modified);
            connect(mark, &QAbstractButton::clicked, this, [this, mark] {
                for (int one = 0; one < bar_->count(); ++one)
                    if (bar_->tabButton(one, QTabBar::RightSide) == mark)
                        return emit closeWanted(one);
            });
            bar_->setTabButton(i, QTabBar::RightSide, mark);
            before = tab;
        }
    }
    if (!(QGuiApplication::mouseButtons() & Qt::LeftButton && bar_->underMouse()))
        bar_->setCurrentIndex(current); // while a tab is dragged it is the current one
    setVisible(tabs.size() > 1);
}

} // namespace ui

#include "moc_drawing_tabs.cpp"
