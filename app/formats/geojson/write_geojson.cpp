// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/geojson/write_geojson.h"

#include "app/base/number.h"
#include "app/base/write_all.h"
#include "app/document/flatten.h"
#include "app/document/hidden_objects.h"
#include "app/formats/coordinates.h"
#include "app/formats/geojson/polygons.h"
#include "app/formats/painted.h"
#include "app/formats/y_up.h"

#include <QJsonDocument>
#include <QJsonObject>

namespace app::geojson {
namespace {

constexpr std::size_t featureBufferSize = 1 << 16;

QString cssColour(const Colour& colour)
{
    return QStringLiteral("#%1").arg(colour.red << 16 | colour.green << 8 | colour.blue, 6, 16,
                                     QLatin1Char('0'));
}

class FeatureWriter {
public:
    FeatureWriter(const Document& document, QIODevice& out, const WriteOptions& options)
        : document_(document), out_(out), options_(options),
          height_(heightOfPlane(document.page(), options)),
          tolerance_(options.tolerance > 0 ? options.tolerance : usualTolerance(document.page())),
          onGlobe_(kindOf(options.projection).onGlobe)
    {
        if (options_.bounds)
            options_.bounds = {
                onGlobe_({options_.bounds->min.x, height_ - options_.bounds->max.y}),
                onGlobe_({options_.bounds->max.x, height_ - options_.bounds->min.y})};
    }

    std::optional<QString> write()
    {
        text_ = "{\"type\":\"FeatureCollection\",\"features\":[";
        const Objects& objects = document_.objects();
        const ObjectRanges hidden = hiddenObjects(document_);
        objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
            if (!hidden.contains(i) && lineColour(object))
                write(object, document_.containers().layerOf(i));
        });
        text_ += "\n]}\n";
        flush();
        return failed_ ? std::optional(out_.errorString() + u'.') : std::nullopt;
    }

private:
    void write(const ObjectView& object, ContainerId layer)
    {
        std::string geometry;
        if (object.style().fill && hasArea(object))
            geometry = polygonsText(object);
        if (geometry.empty())
            geometry = linesText(object);
        if (geometry.empty())
            return; // of which the precision leaves nothing
        text_ += isFirst_ ? "\n" : ",\n";
        isFirst_ = false;
        text_ += "{\"type\":\"Feature\",\"properties\":";
        text_ += propertiesOf(object, layer).toStdString();
        text_ += ",\"geometry\":{\"type\":" + geometry + "}}";
        if (text_.size() > featureBufferSize)
            flush();
    }

    QByteArray propertiesOf(const ObjectView& object, ContainerId layer) const
    {
        QJsonObject properties{{"layer", document_.containers()[layer].name}};
        const auto add = [&](const QString& name, const std::optional<Colour>& colour) {
            if (!colour)
                return;
            properties[name] = cssColour(*colour);
            if (colour->alpha < 255)
                properties[name + QStringLiteral("-opacity")] = colour->alpha / 255.0;
        };
        const Style& style = object.style();
        add(QStringLiteral("stroke"), style.stroke);
        if (style.stroke)
            properties[QStringLiteral("stroke-width")] = style.width;
        add(QStringLiteral("fill"), hasArea(object) ? style.fill : std::nullopt);
        if (!object.particulars().id.isEmpty())
            properties[QStringLiteral("id")] = object.particulars().id;
        return QJsonDocument(properties).toJson(QJsonDocument::Compact);
    }

    // The points of a path as they are written, without equal ones that follow each other.
    std::vector<Point> pointsOf(const Subpath& path) const
    {
        std::vector<Chord> chords;
        flatten(path, tolerance_, chords);
        std::vector<Point> points{written(path.start)};
        for (const Chord& chord : chords)
            if (const Point next = written(chord.segment.b); next != points.back())
                points.push_back(next);
        return points;
    }

    Point written(const Point& p) const
    {
        const Point up = onGlobe_({p.x, height_ - p.y});
        return options_.precision < 0 ? up : roundedPoint(up, options_);
    }

    std::string polygonsText(const ObjectView& object) const
    {
        std::vector<Ring> rings;
        for (const Subpath& path : object.path().subpaths()) {
            rings.push_back(pointsOf(path));
            if (rings.back().back() != rings.back().front())
                rings.back().push_back(rings.back().front());
        }
        const auto polygons = polygonsOf(std::move(rings));
        const auto text = [](const Polygon& polygon) { return listText(polygon, ringText); };
        return polygons.empty() ? std::string()
               : polygons.size() == 1
                   ? "\"Polygon\",\"coordinates\":" + text(polygons.front())
                   : "\"MultiPolygon\",\"coordinates\":" + listText(polygons, text);
    }

    std::string linesText(const ObjectView& object) const
    {
        std::vector<std::vector<Point>> lines, points;
        for (const Subpath& path : object.path().subpaths()) {
            auto line = pointsOf(path);
            if (line.size() > 1)
                lines.push_back(std::move(line));
            else if (path.segments.empty())
                points.push_back(std::move(line));
        }
        if (lines.empty())
            return points.empty() ? std::string()
                                  : "\"Point\",\"coordinates\":" + pointText(points[0][0]);
        return lines.size() == 1
                   ? "\"LineString\",\"coordinates\":" + ringText(lines.front())
                   : "\"MultiLineString\",\"coordinates\":" + listText(lines, ringText);
    }

    static std::string pointText(const Point& p)
    {
        std::string text = "[";
        appendNumber(text, p.x);
        text += ',';
        appendNumber(text, p.y);
        return text += ']';
    }

    static std::string ringText(const std::vector<Point>& points)
    {
        return listText(points, pointText);
    }

    template <class List, class Text>
    static std::string listText(const List& list, const Text& textOf)
    {
        std::string text = "[";
        for (const auto& element : list)
            (text += text.size() > 1 ? "," : "") += textOf(element);
        return text += ']';
    }

    void flush()
    {
        failed_ = failed_ || !writeAll(out_, text_);
        text_.clear();
    }

    const Document& document_;
    QIODevice& out_;
    WriteOptions options_;
    const double height_, tolerance_;
    Point (*const onGlobe_)(const Point& at);
    std::string text_;
    bool isFirst_ = true, failed_ = false;
};

} // namespace

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    if (auto fault = faultOf(document.page()))
        return fault;
    return FeatureWriter(document, out, options).write();
}

} // namespace app::geojson
