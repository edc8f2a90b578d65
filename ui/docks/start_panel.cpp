// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/start_panel.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "ui/docks/algorithm_list.h"
#include "ui/docks/gallery.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/panel_list.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QVBoxLayout>

namespace ui {

namespace {

enum Role { PathRole = Qt::UserRole, LinesRole, DayRole };

class RecentPainter : public RowPainter {
public:
    using RowPainter::RowPainter;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        QStyleOptionViewItem ground = option;
        ground.state &= ~QStyle::State_Selected;
        drawRowGround(*painter, ground);
        const bool there = option.state & QStyle::State_Enabled;
        icon("page").paint(painter, QRect(option.rect.left(), option.rect.center().y() - 8, 16, 16),
                           Qt::AlignCenter, there ? QIcon::Normal : QIcon::Disabled);
        const QFontMetrics metrics(captionFont(option.font));
        const int day = metrics.horizontalAdvance(QStringLiteral("yesterday")) + 4;
        const QString lines = index.data(LinesRole).toString();
        const int counts = day + 12 + metrics.horizontalAdvance(lines);
        const QRect name = option.rect.adjusted(24, 0, -counts - 8, 0);
        drawName(*painter, option, name, index.data().toString(), !there, Qt::ElideMiddle);
        painter->setFont(captionFont(option.font));
        painter->setPen(look.muted);
        painter->drawText(option.rect.adjusted(0, 0, -day - 12, 0),
                          Qt::AlignRight | Qt::AlignVCenter, lines);
        painter->drawText(option.rect, Qt::AlignRight | Qt::AlignVCenter,
                          index.data(DayRole).toString());
    }
};

QString readableFormats()
{
    QStringList names;
    for (const app::Format& format : app::formats())
        if (format.read)
            names << format.shortName();
    return names.join(QStringLiteral(", "));
}

QHBoxLayout* heading(const QString& text, const QString& remark)
{
    auto* row = new QHBoxLayout;
    auto* name = new QLabel(text);
    name->setFont(semiBold(name->font()));
    auto* aside = new QLabel(remark);
    aside->setFont(captionFont(aside->font()));
    aside->setForegroundRole(QPalette::PlaceholderText);
    row->addWidget(name);
    row->addStretch();
    row->addWidget(aside);
    return row;
}

} // namespace

StartPanel::StartPanel(QWidget* parent)
    : QWidget(parent), gallery_(new Gallery),
      noRecent_(new QLabel(Text::tr("Drawings you open are listed here."))),
      recent_(new QListWidget)
{
    auto* draw = new StartButton("pencil", Text::tr("Draw"), Text::tr("on a new page"));
    auto* open = new StartButton("folder", Text::tr("Open…"), readableFormats());
    auto* lesson = new StartButton("book", Text::tr("First lesson"), Text::tr("why clip a line?"));
    auto* paper = new StartButton("chart", Text::tr("The paper…"), Text::tr("which is fastest?"));
    recent_->setAccessibleName(Text::tr("Recent drawings"));
    recent_->setFrameShape(QFrame::NoFrame);
    recent_->setMouseTracking(true);
    recent_->setItemDelegate(new RecentPainter(recent_));
    recent_->viewport()->setAutoFillBackground(false);
    recent_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    recent_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    noRecent_->setForegroundRole(QPalette::PlaceholderText);

    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(10);
    buttons->addWidget(draw);
    buttons->addWidget(open);
    auto* body = new QWidget;
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(16, 14, 16, 16);
    column->setSpacing(space::labelToField);
    column->addLayout(buttons);
    column->addSpacing(6);
    column->addLayout(heading(Text::tr("Samples"), Text::tr("free to use")));
    column->addWidget(gallery_);
    column->addLayout(heading(Text::tr("Recent"), {}));
    column->addWidget(noRecent_);
    column->addWidget(recent_);
    column->addSpacing(6);
    auto* further = new QHBoxLayout;
    further->setSpacing(10);
    further->addWidget(lesson);
    further->addWidget(paper);
    column->addLayout(heading(Text::tr("Learn"), {}));
    column->addLayout(further);
    column->addStretch();
    auto* scroll = new QScrollArea;
    scroll->setWidget(body);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus); // its buttons have it
    scroll->setFrameShape(QFrame::NoFrame);
    // The samples' height depends on the width. A scroll bar that appears and disappears would
    // change both in an endless loop.
    scroll->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->viewport()->setAutoFillBackground(false);
    body->setAutoFillBackground(false);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scroll);

    showRecent({});
    connect(draw, &QAbstractButton::clicked, this, &StartPanel::drawWanted);
    connect(open, &QAbstractButton::clicked, this, &StartPanel::openWanted);
    connect(lesson, &QAbstractButton::clicked, this, &StartPanel::lessonWanted);
    connect(paper, &QAbstractButton::clicked, this, &StartPanel::paperWanted);
    connect(gallery_, &Gallery::chosen, this, &StartPanel::sampleWanted);
    connect(recent_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        emit fileWanted(item->data(PathRole).toString());
    });
}

void StartPanel::showRecent(const std::vector<app::RecentFile>& files)
{
    recent_->clear();
    const QDate today = QDate::currentDate();
    for (const app::RecentFile& file : files) {
        auto* item = new QListWidgetItem(QFileInfo(file.path).fileName(), recent_);
        item->setToolTip(file.path);
        item->setData(PathRole, file.path);
        item->setData(LinesRole, app::linesText(file.lines));
        item->setData(DayRole, app::dayText(file.when.toLocalTime().date(), today));
        if (file.missing())
            item->setFlags(Qt::NoItemFlags);
    }
    noRecent_->setVisible(files.empty());
    recent_->setVisible(!files.empty());
    recent_->setFixedHeight(int(files.size()) * space::rowHeight + 2);
}

void StartPanel::markSample(const QString& key) { gallery_->mark(key); }

} // namespace ui

#include "moc_start_panel.cpp"
