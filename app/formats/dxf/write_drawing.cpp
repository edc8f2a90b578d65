// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_drawing.h"

#include "app/base/text.h"
#include "app/document/flatten.h"
#include "app/formats/dxf/write_layers.h"
#include "app/formats/dxf/write_plane.h"
#include "app/formats/dxf/write_shape.h"
#include "app/formats/dxf/write_skeleton.h"
#include "app/formats/painted.h"
#include "app/formats/rounded.h"

#include <glm/common.hpp>

#include <cmath>
#include <numbers>

namespace app::dxf::writing {
namespace {

constexpr double largestWritten = 1e100; // programs compute with squares of coordinates
// Millimetres. Programs that draw curves as lines have no memory for larger ones.
constexpr double largestWithCurves = 1e12;

/// The bounds and the number of all paths, which stand at the beginning of the file.
struct Extent {
    std::optional<clipping::Window> box{};
    std::size_t subpaths = 0;
    bool hasCurves = false;

    void add(const Point& p)
    {
        box = box ? clipping::Window{glm::min(box->min, p), glm::max(box->max, p)}
                  : clipping::Window{p, p};
    }
};

Extent extentOf(const Document& document)
{
    Extent extent;
    const Objects& objects = document.objects();
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        const Path path = object.path();
        extent.subpaths += path.subpathCount();
        extent.hasCurves = extent.hasCurves || !path.straight();
        path.forEachPoint([&](const Point& p) { extent.add(p); });
    });
    return extent;
}

class EntityWriter {
public:
    EntityWriter(const Document& document, const Plane& plane, const WriteOptions& options,
                 TagWriter& tags)
        : document_(document), plane_(plane), options_(inPlane(options, plane)), tags_(tags),
          full_(options.dxf == DxfVersion::R2000),
          tolerance_(plane.length(options.tolerance > 0 ? options.tolerance
                                                        : usualTolerance(document.page()))),
          layers_(document, options.dxf), lineTypes_(document, plane.length(1))
    {
    }

    std::optional<QString> write()
    {
        const Extent extent = extentOf(document_);
        const clipping::Window box = plane_(extent.box.value_or(document_.page().rectangle()));
        const double most =
            extent.hasCurves ? largestWithCurves / plane_.millimetres() : largestWritten;
        for (const Point& p : {box.min, box.max})
            if (!(std::abs(p.x) <= most && std::abs(p.y) <= most))
                return Text::tr("its coordinates are too large for DXF.");
        const std::size_t entries = layers_.entries().size() + lineTypes_.all().size();
        const Skeleton skeleton{
            options_.dxf,      plane_.unit(),    box,
            layers_.entries(), lineTypes_.all(), firstHandle + entries + extent.subpaths};
        handle_ = writeBeforeEntities(tags_, skeleton);
        const Objects& objects = document_.objects();
        objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
            if (!tags_.failed())
                write(i, object);
        });
        writeAfterEntities(tags_, skeleton);
        return tags_.finish();
    }

private:
    static WriteOptions inPlane(WriteOptions options, const Plane& plane)
    {
        if (options.bounds)
            options.bounds = plane(*options.bounds);
        return options;
    }

    void write(std::size_t index, const ObjectView& object)
    {
        look_ = lookOf(object, document_.page().millimetresPerUnit());
        layer_ = layers_.placeOf(index);
        hidden_ = object.hidden() || layer_.hidden;
        if (!look_ || (hidden_ && !full_)) // R12 hides no single entities
            return;
        lineType_ = lineTypes_.nameOf(object.style());
        for (const Subpath& path : object.path().subpaths())
            if (const auto kept = rounded(plane_(path), options_))
                std::visit([this](const auto& shape) { put(shape); },
                           shapeOf(*kept, full_ ? Curves::All : Curves::Arcs, tolerance_));
    }

    void begin(std::string_view type)
    {
        const LayerEntry& layer = layers_.entries()[layer_.entry];
        tags_.text(0, type);
        if (full_) {
            tags_.handle(5, handle_++);
            tags_.handle(330, modelSpace);
            tags_.text(100, "AcDbEntity");
        }
        tags_.text(8, layer.name);
        if (!lineType_.empty())
            tags_.text(6, lineType_);
        if (*look_ != layer.look)
            writeLook(tags_, *look_, full_ ? Looks::Full : Looks::IndexOnly);
        if (hidden_)
            tags_.text(60, "1");
    }

    void beginClass(std::string_view name)
    {
        if (full_)
            tags_.text(100, name);
    }

    void put(const PointShape& shape)
    {
        begin("POINT");
        beginClass("AcDbPoint");
        tags_.point(10, shape.at);
    }

    void put(const LineShape& shape)
    {
        begin("LINE");
        beginClass("AcDbLine");
        tags_.point(10, shape.from);
        tags_.point(11, shape.to);
    }

    void put(const ArcShape& shape)
    {
        constexpr double degrees = 180 / std::numbers::pi, fullTurn = 2 * std::numbers::pi;
        const bool whole = shape.sweep >= fullTurn;
        begin(whole ? "CIRCLE" : "ARC");
        beginClass("AcDbCircle");
        tags_.point(10, shape.centre);
        tags_.number(40, shape.radius);
        if (whole)
            return;
        beginClass("AcDbArc");
        tags_.number(50, shape.from * degrees);
        tags_.number(51, std::fmod(shape.from + shape.sweep, fullTurn) * degrees);
    }

    void put(const EllipseShape& shape)
    {
        begin("ELLIPSE");
        beginClass("AcDbEllipse");
        tags_.point(10, shape.centre);
        tags_.point(11, shape.majorAxis);
        tags_.number(40, shape.ratio);
        tags_.number(41, shape.from);
        tags_.number(42, shape.from + shape.sweep);
    }

    void put(const PolylineShape& shape)
    {
        constexpr int closed = 1, dashedAcrossVertices = 128;
        const int flags = (shape.closed ? closed : 0) + dashedAcrossVertices;
        begin(full_ ? "LWPOLYLINE" : "POLYLINE");
        beginClass("AcDbPolyline");
        if (full_)
            tags_.whole(90, std::int64_t(shape.vertices.size()));
        else
            tags_.all({{66, "1"}, {10, "0"}, {20, "0"}, {30, "0"}});
        tags_.whole(70, flags);
        for (const auto& [at, bulge] : shape.vertices) {
            if (full_)
                tags_.flatPoint(10, at);
            else
                putVertex(at);
            if (bulge != 0)
                tags_.number(42, bulge);
        }
        if (!full_) {
            tags_.text(0, "SEQEND");
            tags_.text(8, layers_.entries()[layer_.entry].name);
        }
    }

    void putVertex(const Point& at)
    {
        tags_.text(0, "VERTEX");
        tags_.text(8, layers_.entries()[layer_.entry].name);
        tags_.point(10, at);
    }

    void put(const SplineShape& shape)
    {
        constexpr int degree = 3, planar = 8;
        const std::size_t curves = shape.controls.size() / degree;
        begin("SPLINE");
        beginClass("AcDbSpline");
        tags_.all({{210, "0"}, {220, "0"}, {230, "1"}});
        tags_.whole(70, planar);
        tags_.whole(71, degree);
        tags_.whole(72, std::int64_t(shape.controls.size() + degree + 1));
        tags_.whole(73, std::int64_t(shape.controls.size()));
        tags_.text(74, "0");
        for (std::size_t knot = 0; knot <= curves; ++knot)
            for (int i = knot % curves == 0 ? -1 : 0; i < degree; ++i)
                tags_.whole(40, std::int64_t(knot));
        for (const Point& control : shape.controls)
            tags_.point(10, control);
    }

    const Document& document_;
    const Plane& plane_;
    const WriteOptions options_;
    TagWriter& tags_;
    const bool full_; ///< R2000
    const double tolerance_;
    const DxfLayers layers_;
    const LineTypes lineTypes_;
    std::uint64_t handle_ = 0; ///< of the next entity
    // Of the object that is written:
    std::optional<LineLook> look_;
    DxfLayers::Place layer_{};
    bool hidden_ = false;
    std::string_view lineType_;
};

} // namespace

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    if (auto fault = faultOf(document.page()))
        return fault;
    TagWriter tags(out);
    return EntityWriter(document, Plane(document.page(), options), options, tags).write();
}

} // namespace app::dxf::writing
