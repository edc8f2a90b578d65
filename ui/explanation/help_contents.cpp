// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/help_contents.h"

#include "app/base/numbers.h"
#include "ui/docks/algorithm_list.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/search_field.h"

#include <QListView>
#include <QPainter>
#include <QVBoxLayout>

namespace ui {

namespace {

constexpr int indent = 12, headingHeight = 34, pageHeight = 27, foundHeight = 46;

class HelpPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const int height = !index.data(HelpModel::IsPageRole).toBool()           ? headingHeight
                           : index.data(HelpModel::WhyRole).toString().isEmpty() ? pageHeight
                                                                                 : foundHeight;
        return {100, std::max(height, option.fontMetrics.height() + 4)};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        const bool isPage = index.data(HelpModel::IsPageRole).toBool();
        const QString why = index.data(HelpModel::WhyRole).toString();
        const QRect row = option.rect.adjusted(space::dockMargin, 0, -4, 0);
        const auto write = [&](const QRect& box, int side, const QFont& font, const QString& text) {
            painter->setFont(font);
            painter->drawText(box, side,
                              QFontMetrics(font).elidedText(text, Qt::ElideRight, box.width()));
        };
        painter->setPen(look.text);
        if (!isPage)
            return write(row.adjusted(0, 0, 0, -5), Qt::AlignBottom, semiBold(option.font),
                         index.data().toString());
        drawRowGround(*painter, option);
        painter->setPen(look.text);
        const QRect text = row.adjusted(indent, 0, 0, 0);
        if (why.isEmpty())
            return write(text, Qt::AlignVCenter, option.font, index.data().toString());
        const int middle = row.height() / 2;
        write(text.adjusted(0, 0, 0, -middle), Qt::AlignBottom, option.font,
              index.data().toString());
        painter->setPen(look.muted);
        write(text.adjusted(0, middle, 0, 0), Qt::AlignTop, captionFont(option.font), why);
    }
};

} // namespace

HelpModel::HelpModel(QObject* parent) : CheckedModel(parent) { find({}); }

void HelpModel::find(const QString& typed)
{
    beginResetModel();
    lines_.clear();
    if (typed.trimmed().isEmpty()) {
        for (const app::HelpPart& part : app::helpContents()) {
            lines_.push_back({part.title});
            for (const app::HelpPage& page : part.pages)
                lines_.push_back({{}, &page});
        }
    } else {
        for (const app::HelpHit& hit : app::searchHelp(typed, commands_))
            lines_.push_back({hit.why, hit.page});
        if (lines_.empty())
            lines_.push_back({Text::tr("Nothing is found.")});
    }
    endResetModel();
}

int HelpModel::found() const
{
    return int(
        std::ranges::count_if(lines_, [](const Line& line) { return line.page != nullptr; }));
}

const app::HelpPage* HelpModel::page(int row) const
{
    return row < 0 || row >= rows() ? nullptr : lines_[std::size_t(row)].page;
}

int HelpModel::rowOf(const QString& link) const
{
    for (int row = 0; row < rows(); ++row)
        if (page(row) && (link.isEmpty() || page(row)->link == link))
            return row;
    return -1;
}

QVariant HelpModel::cell(int row, int, int role) const
{
    const Line& line = lines_[std::size_t(row)];
    switch (role) {
    case Qt::DisplayRole:
        return line.page ? line.page->title : line.text;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return line.page && !line.text.isEmpty()
                   ? line.page->title + QStringLiteral(": ") + line.text
               : line.page ? line.page->title
                           : line.text;
    case IsPageRole:
        return line.page != nullptr;
    case WhyRole:
        return line.page ? line.text : QString();
    default:
        return {};
    }
}

HelpContents::HelpContents(QWidget* parent)
    : QWidget(parent), field_(new SearchField(Text::tr("Search the help"))), list_(new QListView),
      model_(new HelpModel(list_))
{
    field_->setObjectName(QStringLiteral("search-help"));
    field_->setToolTip(Text::tr("Titles, words, commands and keys (Ctrl+K)"));
    list_->setObjectName(QStringLiteral("help-pages"));
    list_->setModel(model_);
    list_->setItemDelegate(new HelpPainter(list_));
    list_->setAccessibleName(Text::tr("Pages"));
    list_->setFrameShape(QFrame::NoFrame);
    list_->setMouseTracking(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->viewport()->setAutoFillBackground(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, space::labelToField, 0, 0);
    column->setSpacing(space::labelToField);
    auto* top = new QHBoxLayout;
    top->setContentsMargins(space::labelToField, 0, space::labelToField, 0);
    top->addWidget(field_);
    column->addLayout(top);
    column->addWidget(list_, 1);
    connect(field_, &QLineEdit::textChanged, this, &HelpContents::find);
    connect(field_, &SearchField::left, this, [this] {
        list_->setCurrentIndex(model_->index(model_->firstPage()));
        list_->setFocus(Qt::TabFocusReason);
    });
    connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
            [this](const QModelIndex& index) {
                const auto* page = model_->page(index.row());
                if (page && page->link != place_)
                    emit chosen(page->link);
            });
}

void HelpContents::setCommands(const app::HelpCommands& commands) { model_->setCommands(commands); }

void HelpContents::find()
{
    model_->find(field_->text());
    field_->showResult(field_->text().trimmed().isEmpty() ? QString()
                                                          : app::countText(model_->found()));
    showPlace(place_);
}

void HelpContents::showPlace(const QString& link)
{
    place_ = link;
    const QModelIndex row = model_->index(model_->rowOf(link));
    list_->setCurrentIndex(link.isEmpty() ? QModelIndex() : row);
    if (row.isValid())
        list_->scrollTo(row);
}

void HelpContents::search()
{
    field_->setFocus(Qt::ShortcutFocusReason);
    field_->selectAll();
}

} // namespace ui

#include "moc_help_contents.cpp"
