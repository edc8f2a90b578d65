// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/document_bytes.h"

// A structured binding names all members of what is written: a new member does not compile here
// until it is written and read, too.

namespace app {
namespace {

void writeLength(ByteWriter& out, const Length& length)
{
    out.put(length.value);
    out.put(std::uint8_t(length.unit));
}

Length readLength(ByteReader& in)
{
    const auto value = in.get<double>();
    return {value, in.choice(Unit::Foot)};
}

void writeSheets(ByteWriter& out, const PageSheets& sheets)
{
    const auto& [paper, landscape, byNumber, plan] = sheets;
    const auto& [size, columns, rows, margin, overlap, marks, scale, shift, leftOut, beyond,
                 empty] = plan;
    const auto& [left, top, right, bottom] = beyond;
    const auto& [registration, labels, cropLines] = marks;
    out.put(paper);
    for (const bool flag : {landscape, byNumber, registration, labels, cropLines})
        out.put(std::uint8_t(flag));
    out.put(size);
    out.put(std::int32_t(columns));
    out.put(std::int32_t(rows));
    for (const double number : {margin, overlap, scale})
        out.put(number);
    out.put(shift);
    out.putList(leftOut);
    for (const int count : {left, top, right, bottom})
        out.put(std::int32_t(count));
    out.put(std::uint8_t(empty));
}

PageSheets readSheets(ByteReader& in)
{
    PageSheets sheets;
    TilePlan& plan = sheets.plan;
    sheets.paper = in.text();
    for (bool* const flag : {&sheets.landscape, &sheets.byNumber, &plan.marks.registration,
                             &plan.marks.labels, &plan.marks.cropLines})
        *flag = in.flag();
    plan.sheet = in.get<Point>();
    plan.columns = in.get<std::int32_t>();
    plan.rows = in.get<std::int32_t>();
    for (double* const number : {&plan.margin, &plan.overlap, &plan.scale})
        *number = in.get<double>();
    plan.shift = in.get<Point>();
    plan.leftOut = in.list<int>();
    for (int* const count :
         {&plan.beyond.left, &plan.beyond.top, &plan.beyond.right, &plan.beyond.bottom})
        in.require((*count = in.get<std::int32_t>()) >= 0 && *count <= mostTiles);
    plan.empty = in.choice(EmptySheets::Written);
    return sheets;
}

void writeScale(ByteWriter& out, const DrawingScale& scale)
{
    const auto& [ratio, unit] = scale;
    out.put(ratio);
    out.put(std::uint8_t(unit.value_or(Unit::User)));
}

DrawingScale readScale(ByteReader& in)
{
    DrawingScale scale;
    scale.ratio = in.get<double>();
    in.require(scale.ratio >= DrawingScale::least && scale.ratio <= DrawingScale::most);
    const Unit unit = in.choice(Unit::Foot);
    in.require(unit == Unit::User || infoOf(unit).millimetres > 0);
    if (unit != Unit::User)
        scale.unit = unit;
    return scale;
}

void writeMargins(ByteWriter& out, const PaperMargins& margins)
{
    const auto& [left, top, right, bottom, shown] = margins;
    for (const double side : {left, top, right, bottom})
        out.put(side);
    out.put(std::uint8_t(shown));
}

PaperMargins readMargins(ByteReader& in)
{
    PaperMargins margins;
    for (double* const side : {&margins.left, &margins.top, &margins.right, &margins.bottom})
        *side = in.get<double>();
    margins.shown = in.flag();
    return margins;
}

void writePage(ByteWriter& out, const Page& page)
{
    const auto& [min, size, width, height, guides, sheets, scale, margins, background] = page;
    out.put(min);
    out.put(size);
    writeLength(out, width);
    writeLength(out, height);
    out.putCount(guides.list.size());
    for (const auto& [axis, at] : guides.list) {
        out.put(std::uint8_t(axis));
        out.put(at);
    }
    out.put(std::uint8_t(sheets.has_value()));
    if (sheets)
        writeSheets(out, *sheets);
    writeScale(out, scale);
    writeMargins(out, margins);
    out.put(background.colour);
    out.put(std::uint8_t(background.exported));
}

Page readPage(ByteReader& in)
{
    Page page;
    page.min = in.get<Point>();
    page.size = in.get<Point>();
    page.width = readLength(in);
    page.height = readLength(in);
    for (auto n = in.count(1 + sizeof(double)); n > 0; --n) {
        const int axis = in.flag() ? 1 : 0;
        page.guides.list.push_back({axis, in.get<double>()});
    }
    if (in.flag())
        page.sheets = readSheets(in);
    page.scale = readScale(in);
    page.margins = readMargins(in);
    page.background.colour = in.get<Colour>();
    page.background.exported = in.flag();
    return page;
}

// A path with its fill rule and its recipe has the bytes of an object.
Object objectOf(const PathShape& shape)
{
    return {shape.path, {.fillRule = shape.rule}, {.recipe = shape.recipe}};
}

PathShape shapeOf(const Object& object)
{
    return {object.path, object.style.fillRule, object.particulars.recipe};
}

void writeWindows(ByteWriter& out, const ClipWindows& windows)
{
    ObjectBytes paths;
    const auto& [list, keep] = windows;
    out.putCount(list.size());
    for (const auto& [name, shape, operation, visible, colour] : list) {
        out.put(name);
        const auto* own = std::get_if<PathShape>(&shape);
        out.put(std::uint8_t(own != nullptr));
        if (own)
            paths.write(out, objectOf(*own));
        else
            out.put(std::get<RectangleShape>(shape));
        out.put(std::uint8_t(operation));
        out.put(std::uint8_t(visible));
        out.put(std::uint8_t(colour.has_value()));
        if (colour)
            out.put(*colour);
    }
    out.put(std::uint8_t(keep));
}

ClipWindows readWindows(ByteReader& in)
{
    ClipWindows windows;
    ObjectReader paths;
    const std::size_t count = in.count(1);
    in.require(count <= ClipWindows::most);
    for (std::size_t i = 0; i < count && in.ok(); ++i) {
        ClipWindow& window = windows.list.emplace_back();
        window.name = in.text();
        if (in.flag())
            window.shape = shapeOf(paths.object(in));
        else
            window.shape = in.get<RectangleShape>();
        window.operation = in.choice(WindowOperation::Replace);
        window.visible = in.flag();
        if (in.flag())
            window.colour = in.get<Colour>();
    }
    windows.keep = in.choice(Keep::Outside);
    return windows;
}

void writeContainers(ByteWriter& out, const Containers& containers, KnownImages& images)
{
    const Containers::Parts parts = containers.parts();
    out.putList(parts.marks);
    out.put(parts.nextId);
    out.putCount(parts.containers.size());
    for (const auto& [id, kind, name, svgId, title, description, newStyle, visible, locked,
                      underlay] : parts.containers) {
        out.put(id);
        out.put(std::uint8_t(kind));
        for (const QString* const text : {&name, &svgId, &title, &description, &newStyle})
            out.put(*text);
        out.put(std::uint8_t(visible));
        out.put(std::uint8_t(locked));
        writeUnderlay(out, underlay, images);
    }
}

std::optional<Containers> readContainers(ByteReader& in, KnownImages& images)
{
    Containers::Parts parts;
    parts.marks = in.list<ContainerMark>();
    parts.nextId = in.get<ContainerId>();
    for (std::size_t left = in.count(1); left > 0 && in.ok(); --left) {
        Container& container = parts.containers.emplace_back();
        container.id = in.get<ContainerId>();
        container.kind = in.choice(Container::Kind::Group);
        for (QString* const text : {&container.name, &container.svgId, &container.title,
                                    &container.description, &container.newStyle})
            *text = in.text();
        container.visible = in.flag();
        container.locked = in.flag();
        container.underlay = readUnderlay(in, images);
    }
    auto containers = in.ok() ? Containers::of(parts) : std::nullopt;
    in.require(containers.has_value());
    return containers;
}

} // namespace

void writeDocument(ByteWriter& out, const Document& document, ObjectBytes& objects)
{
    writePage(out, document.page());
    const auto& [id, comments, title, description, metadata] = document.about();
    for (const QString* const text : {&id, &comments, &title, &description, &metadata})
        out.put(*text);
    objects.write(out, document.objects());
    writeContainers(out, document.containers(), objects.images);
    writeWindows(out, document.windows());
}

std::optional<Document> readDocument(ByteReader& in, ObjectReader& objects)
{
    DocumentParts parts;
    auto& [page, about, objectsOf, containersOf, windows] = parts;
    page = readPage(in);
    for (QString* const text :
         {&about.id, &about.comments, &about.title, &about.description, &about.metadata})
        *text = in.text();
    objects.read(in, objectsOf);
    auto containers = readContainers(in, objects.images);
    windows = readWindows(in);
    if (!in.ok() || containers->objects() != objectsOf.size())
        return std::nullopt;
    containersOf = std::move(*containers);
    return Document(std::move(parts));
}

void writeSplices(ByteWriter& out, std::span<const Splice> splices) { out.putList(splices); }

std::vector<Splice> readSplices(ByteReader& in) { return in.list<Splice>(); }

void writeSetting(ByteWriter& out, const Edit& edit, KnownImages& images)
{
    out.put(std::uint8_t(edit.containers.has_value()));
    if (edit.containers)
        writeContainers(out, *edit.containers, images);
    out.put(std::uint8_t(edit.windows.has_value()));
    if (edit.windows)
        writeWindows(out, *edit.windows);
    out.put(std::uint8_t(edit.page.has_value()));
    if (edit.page)
        writePage(out, *edit.page);
}

void readSetting(ByteReader& in, Edit& edit, KnownImages& images)
{
    if (in.flag())
        edit.containers = readContainers(in, images);
    if (in.flag())
        edit.windows = readWindows(in);
    if (in.flag())
        edit.page = readPage(in);
}

void writeEdit(ByteWriter& out, const Edit& edit, ObjectBytes& objects)
{
    // Names are not recorded.
    const auto& [splices, added, containers, windows, page, moved, numbers] = edit;
    writeSplices(out, splices);
    objects.write(out, added);
    writeSetting(out, edit, objects.images);
}

std::optional<Edit> readEdit(ByteReader& in, ObjectReader& objects, const Objects& styles)
{
    Edit edit;
    edit.splices = readSplices(in);
    edit.objects = styles.slice(0, 0);
    objects.read(in, edit.objects);
    readSetting(in, edit, objects.images);
    return in.ok() ? std::optional(std::move(edit)) : std::nullopt;
}

bool fits(const Edit& edit, const Document& document)
{
    const std::uint64_t size = document.objects().size();
    std::uint64_t at = 0, removed = 0, added = 0;
    for (const Splice& s : edit.splices) {
        if (s.first < at)
            return false;
        at = std::uint64_t(s.first) + s.removed;
        removed += s.removed;
        added += s.added;
    }
    if (at > size || added != edit.objects.size())
        return false;
    const std::uint64_t after = size - removed + added;
    return edit.containers ? edit.containers->objects() == after
                           : document.containers().objects() == after;
}

} // namespace app
