// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/geojson/read_geojson.h"

#include "app/base/memory.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/formats/csv/lines_by_layer.h"
#include "app/formats/svg/colour.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app::geojson {
namespace {

constexpr double largestNumber = 1e300; // keeps sums and differences finite
constexpr double shareOfSize = 1e-3;    // of a stroke, as a part of the drawing's size
constexpr double usualSize = 300;       // millimetres, of a map in degrees
constexpr int deepestCollection = 100;
constexpr std::uint64_t memoryForByte = 8; // of the file, while it is read

struct Unreadable {
    QString why;
};

/// A feature as it is drawn.
struct Drawn {
    std::vector<Subpath> paths;
    Style style;
    bool hasWidth = false; ///< of its own
    std::string layer;
};

struct FoundLosses {
    int heights = 0, properties = 0, empty = 0, beyond = 0;
};

std::optional<Colour> simpleColour(const QJsonObject& properties, const QString& name)
{
    const QString text = properties[name].toString();
    auto colour = text.isEmpty() ? std::nullopt : svg::parseColour(text.toStdString());
    const double opacity = properties[name + QStringLiteral("-opacity")].toDouble(1);
    if (colour && opacity >= 0 && opacity < 1)
        colour->alpha = std::uint8_t(std::lround(opacity * 255));
    return colour;
}

class FeatureReader {
public:
    explicit FeatureReader(Projection projection) : projection_(kindOf(projection)) {}

    void addText(const QByteArray& bytes, qsizetype firstLine)
    {
        QJsonParseError error{};
        const QJsonDocument json = QJsonDocument::fromJson(bytes, &error);
        if (error.error != QJsonParseError::NoError)
            throw Unreadable{Text::tr("line %1 is not JSON: %2.")
                                 .arg(firstLine + bytes.left(error.offset).count('\n'))
                                 .arg(error.errorString())};
        add(json.object(), {}, 0);
    }

    Imported take()
    {
        const bool hasDegrees = this->hasDegrees();
        if (projection_.projection != Projection::PlateCarree)
            project();
        csv::LinesByLayer lines;
        const double width = widthOfStrokes();
        for (Drawn& drawn : drawn_) {
            if (!drawn.hasWidth)
                drawn.style.width = width;
            lines.turnTo(drawn.layer);
            lines.add(drawn.paths, lines.style(drawn.style));
        }
        Imported imported{.document = lines.take(), .report = report(lines.beyond(), hasDegrees)};
        imported.paged = false;
        if (hasDegrees)
            imported.document.apply({.page = ofUsualSize(imported.document.page())});
        return imported;
    }

private:
    void add(const QJsonObject& object, const QJsonObject& properties, int depth)
    {
        const QString type = object[QStringLiteral("type")].toString();
        if (depth > deepestCollection)
            throw Unreadable{Text::tr("collections lie in each other more than %1 deep.")
                                 .arg(deepestCollection)};
        if (type == QStringLiteral("FeatureCollection"))
            return addAll(object[QStringLiteral("features")], {}, depth);
        if (type == QStringLiteral("GeometryCollection"))
            return addAll(object[QStringLiteral("geometries")], properties, depth);
        if (type == QStringLiteral("Feature"))
            return add(object[QStringLiteral("geometry")].toObject(),
                       object[QStringLiteral("properties")].toObject(), depth + 1);
        if (type.isEmpty() && depth > 0) {
            ++losses_.empty; // a feature without a place
            return;
        }
        addGeometry(type, object[QStringLiteral("coordinates")].toArray(), properties);
    }

    void addAll(const QJsonValue& objects, const QJsonObject& properties, int depth)
    {
        for (const QJsonValue& object : objects.toArray())
            add(object.toObject(), properties, depth + 1);
    }

    void addGeometry(const QString& type, const QJsonArray& at, const QJsonObject& properties)
    {
        Drawn drawn = lookOf(properties);
        if (type == QStringLiteral("Point"))
            drawn.paths.push_back({pointOf(at), {}, false});
        else if (type == QStringLiteral("LineString"))
            addLine(drawn, at, false);
        else if (type == QStringLiteral("MultiPoint"))
            for (const QJsonValue& point : at)
                drawn.paths.push_back({pointOf(point.toArray()), {}, false});
        else if (type == QStringLiteral("MultiLineString"))
            addLines(drawn, at, false);
        else if (type == QStringLiteral("Polygon"))
            addLines(drawn, at, true);
        else if (type == QStringLiteral("MultiPolygon"))
            for (const QJsonValue& polygon : at)
                addLines(drawn, polygon.toArray(), true);
        else
            throw Unreadable{Text::tr("“%1” is no type of GeoJSON.").arg(type.left(40))};
        if (!type.endsWith(QStringLiteral("Polygon")))
            drawn.style.fill.reset();
        if (type.endsWith(QStringLiteral("Point")))
            drawn.style.cap = Cap::Round; // it is seen
        if (!drawn.paths.empty())
            drawn_.push_back(std::move(drawn));
    }

    void addLines(Drawn& drawn, const QJsonArray& lines, bool closed)
    {
        for (const QJsonValue& line : lines)
            addLine(drawn, line.toArray(), closed);
    }

    void addLine(Drawn& drawn, const QJsonArray& points, bool closed)
    {
        if (points.isEmpty())
            return;
        Subpath path{pointOf(points.first().toArray()), {}, closed};
        for (qsizetype i = 1; i < points.size(); ++i)
            path.segments.push_back({pointOf(points[i].toArray())});
        if (closed && path.segments.size() > 1 && path.segments.back().to == path.start)
            path.segments.pop_back(); // the closing line goes there
        drawn.paths.push_back(std::move(path));
    }

    Point pointOf(const QJsonArray& position)
    {
        const QJsonValue x = position.at(0), y = position.at(1);
        if (!x.isDouble() || !y.isDouble())
            throw Unreadable{Text::tr("a position is not two numbers.")};
        const Point p{x.toDouble(), 0 - y.toDouble()};
        if (!(std::abs(p.x) <= largestNumber && std::abs(p.y) <= largestNumber))
            throw Unreadable{Text::tr("a number is too large; numbers go up to 1e300.")};
        losses_.heights += position.size() > 2;
        include(p);
        return p;
    }

    Drawn lookOf(const QJsonObject& properties)
    {
        static const QStringList known{"layer",          "stroke", "stroke-width",
                                       "stroke-opacity", "fill",   "fill-opacity"};
        const auto isKnown = [](const QString& name) { return known.contains(name); };
        losses_.properties += !std::ranges::all_of(properties.keys(), isKnown);
        Drawn drawn;
        drawn.layer = properties[QStringLiteral("layer")].toString().toStdString();
        drawn.style.fill = simpleColour(properties, QStringLiteral("fill"));
        drawn.style.stroke = simpleColour(properties, QStringLiteral("stroke"));
        if (!drawn.style.stroke && !drawn.style.fill)
            drawn.style.stroke = Colour{};
        const double width = properties[QStringLiteral("stroke-width")].toDouble(-1);
        drawn.hasWidth = width >= 0 && width <= largestNumber;
        if (drawn.hasWidth)
            drawn.style.width = width;
        return drawn;
    }

    // A map of a town in degrees would have less than a pixel.
    static Page ofUsualSize(Page page)
    {
        const double longest = std::max(page.size.x, page.size.y);
        const double millimetres = longest > 0 ? usualSize / longest : 1;
        page.width = {page.size.x * millimetres, Unit::Mm};
        page.height = {page.size.y * millimetres, Unit::Mm};
        return page;
    }

    // Until here y is the negative latitude.
    void project()
    {
        if (box_ && !hasDegrees())
            throw Unreadable{
                Text::tr("its positions are no degrees, so they cannot be drawn as %1.")
                    .arg(projection_.name)};
        box_.reset();
        const auto draw = [&](Point& p) {
            const double latitude = std::clamp(-p.y, -farthestLatitude, farthestLatitude);
            losses_.beyond += latitude != -p.y;
            const Point up = projection_.onPlane({p.x, latitude});
            p = {up.x, 0 - up.y};
            include(p);
        };
        for (Drawn& drawn : drawn_)
            for (Subpath& path : drawn.paths)
                forEachPoint(path, draw);
    }

    void include(const Point& p)
    {
        box_ = box_ ? clipping::Window{glm::min(box_->min, p), glm::max(box_->max, p)}
                    : clipping::Window{p, p};
    }

    double widthOfStrokes() const
    {
        const Point size = box_ ? box_->max - box_->min : Point{0, 0};
        const double width = std::max(size.x, size.y) * shareOfSize;
        return width > 0 && std::isfinite(width) ? width : 1;
    }

    bool hasDegrees() const
    {
        return box_ && box_->min.x >= -180 && box_->max.x <= 180 && box_->min.y >= -90
               && box_->max.y <= 90;
    }

    std::vector<Loss> report(int beyond, bool hasDegrees) const
    {
        std::vector<Loss> report;
        if (hasDegrees)
            report.push_back(
                {Text::tr("map in degrees, drawn as %1: a user unit for each degree of "
                          "longitude")
                     .arg(projection_.name),
                 1, true});
        if (losses_.beyond > 0)
            report.push_back({Text::tr("positions beyond %1° of latitude, where %2 ends")
                                  .arg(numberText(farthestLatitude, 2), projection_.name),
                              losses_.beyond, false, Text::tr("drawn at its edge")});
        if (losses_.properties > 0)
            report.push_back({losses_.properties == 1 ? Text::tr("property of a feature")
                                                      : Text::tr("properties of features"),
                              losses_.properties});
        if (losses_.heights > 0)
            report.push_back({losses_.heights == 1 ? Text::tr("height of a position")
                                                   : Text::tr("heights of positions"),
                              losses_.heights});
        if (losses_.empty > 0)
            report.push_back({losses_.empty == 1 ? Text::tr("feature without a geometry")
                                                 : Text::tr("features without a geometry"),
                              losses_.empty});
        if (beyond > 0)
            report.push_back({Text::tr("layer names of lines, beyond the first %1 layers")
                                  .arg(Containers::mostLayers),
                              beyond});
        return report;
    }

    const ProjectionKind& projection_;
    std::vector<Drawn> drawn_;
    std::optional<clipping::Window> box_;
    FoundLosses losses_;
};

/// Reads a file, or each text of a sequence: after a record separator, or on lines of their own.
void readTexts(FeatureReader& reader, const QByteArray& bytes)
{
    constexpr char recordSeparator = 0x1e;
    const bool isSequence = bytes.trimmed().startsWith(recordSeparator);
    const QByteArray firstLine = bytes.trimmed().split('\n').value(0).trimmed();
    const bool hasLines =
        firstLine.size() < bytes.trimmed().size() && QJsonDocument::fromJson(firstLine).isObject();
    if (!isSequence && !hasLines)
        return reader.addText(bytes, 1);
    qsizetype line = 1;
    for (const QByteArray& text : bytes.split(isSequence ? recordSeparator : '\n')) {
        if (!text.trimmed().isEmpty())
            reader.addText(text, line);
        line += isSequence ? text.count('\n') : 1;
    }
}

} // namespace

Result<Imported> read(QIODevice& in, const ReadOptions& options)
{
    try {
        const QByteArray bytes = in.read(mostBytes + 1);
        if (bytes.size() > mostBytes)
            throw Unreadable{Text::tr("the file is larger than %1 bytes.")
                                 .arg(countText(std::size_t(mostBytes)))};
        if (QString fault = memoryFault(std::uint64_t(bytes.size()) * memoryForByte);
            !fault.isEmpty())
            throw Unreadable{fault};
        FeatureReader reader(options.projection);
        readTexts(reader, bytes);
        return Result<Imported>::of(reader.take());
    } catch (const Unreadable& unreadable) {
        return Result<Imported>::failure(unreadable.why);
    }
}

} // namespace app::geojson
