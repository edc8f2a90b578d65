// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/look_icon.h"

#include "app/formats/format.h"
#include "app/view/painter_path.h"
#include "ui/look/look.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>

namespace ui {

namespace {

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
            painter->setOpacity(painter->opacity() * 0.45);
        painter->translate(rect.topLeft());
        painter->scale(scale, scale);
        painter->translate(-drawing.page().min.x, -drawing.page().min.y);
        for (std::size_t i = 0; i < drawing.objects().size(); ++i)
            paint(*painter, drawing.objects()[i], look);
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        paint(&painter, QRect({}, size), mode, state);
        return picture;
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

} // namespace

QIcon icon(std::string_view key)
{
    const QLatin1StringView name(key.data(), qsizetype(key.size()));
    return QIcon(new Engine(QStringLiteral(":/icons/%1.svg").arg(name)));
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
