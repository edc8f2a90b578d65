// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_icon.h"

#include "app/formats/format.h"
#include "app/view/outline.h"

#include <QFile>
#include <QIconEngine>

namespace ui {

namespace {

constexpr double disabledOpacity = 0.45;

QPixmap paintedPixmap(QIconEngine& engine, const QSize& size, QIcon::Mode mode, QIcon::State state)
{
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    engine.paint(&painter, QRect({}, size), mode, state);
    return picture;
}

/// Reads the icon's file at the first painting and paints it as paths at every size.
class Engine : public QIconEngine {
public:
    explicit Engine(QString path) : path_(std::move(path)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const app::Document& drawing = document();
        const Look& look = lookOf(QApplication::palette());
        const double scale = rect.width() / drawing.page().size.x;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (mode == QIcon::Disabled)
            painter->setOpacity(painter->opacity() * disabledOpacity);
        painter->translate(rect.topLeft());
        painter->scale(scale, scale);
        painter->translate(-drawing.page().min.x, -drawing.page().min.y);
        for (std::size_t i = 0; i < drawing.objects().size(); ++i)
            paint(*painter, drawing.objects()[i], look);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        return paintedPixmap(*this, size, mode, state);
    }

    QIconEngine* clone() const override { return new Engine(*this); }

private:
    const app::Document& document()
    {
        if (!document_) {
            document_.emplace();
            document_->apply({.page = app::Page{.size = {20, 20}}});
            QFile file(path_);
            const app::Format* svg = app::findFormat(u"svg");
            if (svg && svg->read && file.open(QIODevice::ReadOnly))
                if (auto imported = svg->read(file))
                    document_ = imported.value->document;
        }
        return *document_;
    }

    static QColor shown(const app::Colour& strokeColour, const Look& look)
    {
        const bool black =
            strokeColour.red == 0 && strokeColour.green == 0 && strokeColour.blue == 0;
        return black ? look.text : look.accent;
    }

    static void paint(QPainter& painter, const app::ObjectView& object, const Look& look)
    {
        const app::Style& style = object.style();
        painter.setPen(style.stroke ? QPen(shown(*style.stroke, look), style.width, Qt::SolidLine,
                                           Qt::RoundCap, Qt::RoundJoin)
                                    : QPen(Qt::NoPen));
        painter.setBrush(style.fill ? QBrush(shown(*style.fill, look)) : QBrush(Qt::NoBrush));
        painter.drawPath(app::painterPath(object.path(), style.fillRule));
    }

    QString path_;
    std::optional<app::Document> document_;
};

class PaintedEngine : public QIconEngine {
public:
    using Paint = std::function<void(QPainter& painter, const Look& look)>;
    PaintedEngine(const QSize& size, Paint paint) : size_(size), paint_(std::move(paint)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        painter->save();
        if (mode == QIcon::Disabled)
            painter->setOpacity(painter->opacity() * disabledOpacity);
        painter->translate(rect.topLeft());
        painter->scale(double(rect.width()) / size_.width(),
                       double(rect.height()) / size_.height());
        paint_(*painter, lookOf(QApplication::palette()));
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        return paintedPixmap(*this, size, mode, state);
    }
    QIconEngine* clone() const override { return new PaintedEngine(*this); }

private:
    QSize size_;
    Paint paint_;
};

} // namespace

QIcon icon(std::string_view key)
{
    const QLatin1StringView name(key.data(), qsizetype(key.size()));
    return QIcon(new Engine(QStringLiteral(":/icons/%1.svg").arg(name)));
}

QIcon paintedIcon(const QSize& size, std::function<void(QPainter& painter, const Look& look)> paint)
{
    return QIcon(new PaintedEngine(size, std::move(paint)));
}

QPixmap tinted(const QIcon& icon, const QSize& size, double pixelRatio, const QColor& colour)
{
    QPixmap picture = icon.pixmap(size, pixelRatio);
    QPainter painter(&picture);
    painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
    painter.fillRect(QRect({}, size), colour);
    return picture;
}

} // namespace ui
