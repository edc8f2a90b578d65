// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/gallery.h"

#include "app/view/thumbnail.h"
#include "ui/look.h"

#include <QEvent>
#include <QPainter>
#include <QPointer>
#include <QStyledItemDelegate>
#include <QThread>

namespace ui {

namespace {

constexpr int gap = 10;
constexpr int captionHeight = 22;

class CellPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        const bool open = index.data(Qt::UserRole + 1).toBool();
        const QRect picture = option.rect.adjusted(1, 1, -1, -captionHeight - 1);
        painter->fillRect(picture, look.paper);
        if (const auto image = index.data(Qt::UserRole).value<QImage>(); !image.isNull())
            painter->drawImage(picture, image);
        const bool lit = option.state & (QStyle::State_MouseOver | QStyle::State_HasFocus);
        painter->setPen(QPen(open || lit ? look.selection : look.border, open ? 2 : 1));
        painter->drawRect(picture.adjusted(0, 0, -1, -1));
        painter->setPen(look.text);
        painter->setFont(open ? semiBold(captionFont(option.font)) : captionFont(option.font));
        const QRect caption(option.rect.left(), picture.bottom() + 1, option.rect.width(),
                            captionHeight);
        painter->drawText(caption, Qt::AlignVCenter,
                          painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight,
                                                            caption.width()));
    }
};

QSize cellSize(int width)
{
    const int each = std::max(80, (width - gap) / 2);
    return {each, each * 2 / 3 + captionHeight};
}

QImage pictureOf(const app::Sample& sample, const QSize& points, double ratio,
                 const app::ThumbnailColours& colours)
{
    const auto imported = app::readFile(sample.file);
    return imported ? app::thumbnail(imported.value->sheet, points, ratio, colours) : QImage();
}

} // namespace

Gallery::Gallery(QWidget* parent)
    : QListWidget(parent), samples_(app::samples()),
      generation_(std::make_shared<std::atomic<int>>(0))
{
    setAccessibleName(tr("Samples"));
    setViewMode(QListView::IconMode);
    setMovement(QListView::Static);
    setResizeMode(QListView::Adjust);
    setFrameShape(QFrame::NoFrame);
    setMouseTracking(true);
    setSpacing(0);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setItemDelegate(new CellPainter(this));
    viewport()->setAutoFillBackground(false);
    for (const app::Sample& sample : samples_)
        addItem(sample.title);
    const auto open = [this](QListWidgetItem* item) {
        emit chosen(samples_[std::size_t(row(item))]);
    };
    connect(this, &QListWidget::itemClicked, this, open);
    connect(this, &QListWidget::itemActivated, this, [this, open](QListWidgetItem* item) {
        if (hasFocus())
            open(item);
    });
}

Gallery::~Gallery() { ++*generation_; }

void Gallery::mark(const QString& key)
{
    for (std::size_t i = 0; i < samples_.size(); ++i)
        item(int(i))->setData(Qt::UserRole + 1, samples_[i].key == key);
}

int Gallery::heightForWidth(int width) const
{
    const int rows = int(samples_.size() + 1) / 2;
    return rows * (cellSize(width).height() + gap);
}

void Gallery::showEvent(QShowEvent* event)
{
    QListWidget::showEvent(event);
    if (!painted_)
        paintPictures();
}

void Gallery::resizeEvent(QResizeEvent* event)
{
    QListWidget::resizeEvent(event);
    layOut();
}

void Gallery::layOut()
{
    const QSize cell = cellSize(width());
    setGridSize({cell.width() + gap / 2, cell.height() + gap});
    for (int i = 0; i < count(); ++i)
        item(i)->setSizeHint(cell);
    setFixedHeight(heightForWidth(width()));
}

void Gallery::changeEvent(QEvent* event)
{
    QListWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && painted_)
        paintPictures();
}

void Gallery::paintPictures()
{
    painted_ = true;
    const int generation = ++*generation_;
    const Look& look = lookOf(palette());
    const app::ThumbnailColours colours{look.paper, look.accent, look.ghost};
    const QSize cell = cellSize(width());
    const QSize points(cell.width() - 2, cell.height() - captionHeight - 2);
    // The thread knows nothing of this widget but a counter that outlives it.
    auto* painter =
        QThread::create([samples = samples_, points, colours, generation, current = generation_,
                         ratio = devicePixelRatioF(), gallery = QPointer<Gallery>(this)] {
            for (int i = 0; i < int(samples.size()) && *current == generation; ++i) {
                const QImage image = pictureOf(samples[std::size_t(i)], points, ratio, colours);
                QMetaObject::invokeMethod(qApp, [gallery, current, generation, i, image] {
                    if (gallery && *current == generation)
                        gallery->item(i)->setData(Qt::UserRole, image);
                });
            }
        });
    connect(painter, &QThread::finished, painter, &QObject::deleteLater);
    connect(qApp, &QCoreApplication::aboutToQuit, painter, [painter] { painter->wait(); });
    painter->start(QThread::LowPriority);
}

} // namespace ui
