// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/object_bytes.h"

#include <algorithm>

// A structured binding names all members of what is written: a new member does not compile here
// until it is written and read, too.

namespace app {
namespace {

enum class Kind : std::uint8_t { Empty, Line, Own, Shared };

void writeColour(ByteWriter& out, const std::optional<Colour>& colour)
{
    out.put(std::uint8_t(colour.has_value()));
    out.put(colour.value_or(Colour{}));
}

std::optional<Colour> readColour(ByteReader& in)
{
    const bool some = in.flag();
    const auto colour = in.get<Colour>();
    return some ? std::optional(colour) : std::nullopt;
}

struct WriteRecipe {
    ByteWriter& out;
    void operator()(std::monostate) const {}
    void operator()(const RectangleRecipe& r) const { out.put(r); }
    void operator()(const EllipseRecipe& r) const { out.put(r); }
    void operator()(const StarRecipe& r) const { out.put(r); }
    void operator()(const TextRecipe& r) const
    {
        const auto& [text, font, size, at, turn, mirrored, face] = r;
        out.put(text);
        out.put(font);
        out.put(size);
        out.put(at);
        out.put(turn);
        for (const bool flag : {mirrored, face.bold, face.italic})
            out.put(std::uint8_t(flag));
    }
};

Recipe readRecipe(ByteReader& in)
{
    static_assert(std::variant_size_v<Recipe> == 5);
    switch (in.get<std::uint8_t>()) {
    case 0:
        return {};
    case 1:
        return in.get<RectangleRecipe>();
    case 2:
        return in.get<EllipseRecipe>();
    case 3:
        return in.get<StarRecipe>();
    case 4: {
        TextRecipe text;
        text.text = in.text();
        text.font = in.text();
        text.size = in.get<double>();
        text.at = in.get<Point>();
        text.turn = in.get<double>();
        for (bool* const flag : {&text.mirrored, &text.face.bold, &text.face.italic})
            *flag = in.flag();
        return text;
    }
    default:
        in.fail();
        return {};
    }
}

void writeParticulars(ByteWriter& out, const Particulars& particulars)
{
    const bool some = !(particulars == Particulars{});
    out.put(std::uint8_t(some));
    if (!some)
        return;
    // No open drawing has clip paths that were kept: only the command line keeps them.
    const auto& [id, title, description, recipe, clips] = particulars;
    out.put(id);
    out.put(title);
    out.put(description);
    out.put(std::uint8_t(recipe.index()));
    std::visit(WriteRecipe{out}, recipe);
}

Shared<Particulars> readParticulars(ByteReader& in)
{
    if (!in.flag())
        return noParticulars();
    Particulars particulars;
    particulars.id = in.text();
    particulars.title = in.text();
    particulars.description = in.text();
    particulars.recipe = readRecipe(in);
    return Shared(std::move(particulars));
}

/// The styles that objects use, in the order of their first use.
struct UsedStyles {
    explicit UsedStyles(const Objects& objects)
    {
        for (const Shared<ObjectBlock>& block : objects.blocks())
            for (const StyleIndex style : block->styles)
                if (numbers.try_emplace(style, std::uint32_t(list.size())).second)
                    list.push_back(style);
    }
    std::unordered_map<StyleIndex, std::uint32_t> numbers;
    std::vector<StyleIndex> list;
};

/// Without those that are lent, those of paths and styles, and the small ones of particular
/// objects.
std::size_t leastBytes(const Objects& objects, Lending lending)
{
    constexpr std::size_t aBlock = 64;
    std::size_t bytes = 0;
    for (const Shared<ObjectBlock>& block : objects.blocks())
        bytes += aBlock
                 + (lending == Lending::No ? block->lines.size() * sizeof(clipping::Segment) : 0)
                 + block->styles.size() * sizeof(std::uint32_t) + block->hidden.size();
    return bytes;
}

} // namespace

void writeStyle(ByteWriter& out, const Style& style)
{
    const auto& [stroke, fill, width, miterLimit, dashOffset, dashes, cap, join, fillRule] = style;
    writeColour(out, stroke);
    writeColour(out, fill);
    for (const double number : {width, miterLimit, dashOffset})
        out.put(number);
    out.putList(dashes);
    out.put(std::uint8_t(cap));
    out.put(std::uint8_t(join));
    out.put(std::uint8_t(fillRule));
}

Style readStyle(ByteReader& in)
{
    Style style;
    style.stroke = readColour(in);
    style.fill = readColour(in);
    for (double* const number : {&style.width, &style.miterLimit, &style.dashOffset})
        *number = in.get<double>();
    style.dashes = in.list<double>();
    style.cap = in.choice(Cap::Square);
    style.join = in.choice(Join::Bevel);
    style.fillRule = in.choice(FillRule::EvenOdd);
    return style;
}

void ObjectBytes::writePath(ByteWriter& out, const Path& path)
{
    if (const auto line = path.singleLine()) {
        out.put(Kind::Line);
        out.put(*line);
        return;
    }
    const auto parts = path.parts();
    if (!parts) {
        out.put(Kind::Empty);
        return;
    }
    const auto [at, isNew] = known_.try_emplace(parts->points.data(), std::uint32_t(known_.size()));
    out.put(isNew ? Kind::Own : Kind::Shared);
    out.put(parts->placement);
    if (!isNew) {
        out.put(at->second);
        return;
    }
    kept_.push_back(path);
    out.putList(parts->points);
    out.putList(parts->sizes);
    out.putList(parts->kinds);
}

Path ObjectReader::path(ByteReader& in)
{
    const Kind kind = in.choice(Kind::Shared);
    if (kind == Kind::Empty)
        return {};
    if (kind == Kind::Line)
        return Path(in.get<clipping::Segment>());
    const auto placement = in.get<Placement>();
    if (kind == Kind::Shared) {
        const auto number = in.get<std::uint32_t>();
        in.require(number < known_.size());
        return in.ok() ? known_[number].withPlacement(placement) : Path();
    }
    const auto points = in.list<Point>();
    const auto sizes = in.list<std::uint32_t>();
    const auto kinds = in.list<std::uint8_t>();
    const auto path = Path::of({placement, points, sizes, kinds});
    in.require(path.has_value());
    if (!path || !in.ok())
        return {};
    known_.push_back(*path);
    return *path;
}

void ObjectBytes::write(ByteWriter& out, const Objects& objects)
{
    out.reserve(leastBytes(objects, out.lending()));
    const UsedStyles styles(objects);
    out.putCount(styles.list.size());
    for (const StyleIndex style : styles.list)
        writeStyle(out, objects.styles()[style]);
    out.putCount(objects.blocks().size());
    for (const Shared<ObjectBlock>& shared : objects.blocks()) {
        const auto& [lines, paths, styleOf, hidden, particularsOf, points] = *shared;
        out.put(std::uint8_t(paths.empty()));
        if (paths.empty()) {
            out.lendList(lines);
        } else {
            out.putCount(paths.size());
            for (const Path& path : paths)
                writePath(out, path);
        }
        out.putCount(styleOf.size());
        for (const StyleIndex style : styleOf)
            out.put(styles.numbers.at(style));
        out.putList(hidden);
        out.putCount(particularsOf.size());
        for (const Shared<Particulars>& particulars : particularsOf)
            writeParticulars(out, *particulars);
    }
}

/// The columns of a block as they were read.
struct ObjectReader::Columns {
    std::vector<clipping::Segment> lines{};
    std::vector<Path> paths{};
    std::vector<std::uint32_t> styles{};
    std::vector<std::uint8_t> hidden{};
    std::vector<Shared<Particulars>> particulars{};

    std::size_t size() const { return lines.size() + paths.size(); }
    bool fit(std::size_t knownStyles) const
    {
        const auto fits = [&](const auto& column) {
            return column.empty() || column.size() == size();
        };
        return size() > 0 && (styles.size() == 1 || styles.size() == size()) && fits(hidden)
               && fits(particulars) && std::ranges::all_of(styles, [&](std::uint32_t style) {
                      return style < knownStyles;
                  });
    }
    ObjectRow row(std::size_t i, std::span<const StyleEntry> known) const
    {
        return {paths.empty() ? Path(lines[i]) : paths[i],
                known[styles[styles.size() == 1 ? 0 : i]], !hidden.empty() && hidden[i] != 0,
                particulars.empty() ? noParticulars() : particulars[i]};
    }
};

ObjectReader::Columns ObjectReader::columns(ByteReader& in)
{
    Columns columns;
    if (in.flag())
        columns.lines = in.list<clipping::Segment>();
    else
        for (std::size_t left = in.count(1); left > 0 && in.ok(); --left)
            columns.paths.push_back(path(in));
    columns.styles = in.list<std::uint32_t>();
    columns.hidden = in.list<std::uint8_t>();
    for (std::size_t left = in.count(1); left > 0 && in.ok(); --left)
        columns.particulars.push_back(readParticulars(in));
    return columns;
}

void ObjectReader::read(ByteReader& in, Objects& to)
{
    std::vector<StyleEntry> styles;
    for (std::size_t left = in.count(1); left > 0 && in.ok(); --left)
        if (const Style style = readStyle(in); in.ok())
            styles.push_back(to.styles().entryOf(style));
    for (std::size_t left = in.count(1); left > 0 && in.ok(); --left) {
        const Columns block = columns(in);
        in.require(block.fit(styles.size()));
        for (std::size_t i = 0; i < block.size() && in.ok(); ++i)
            to.append(block.row(i, styles));
    }
}

void ObjectBytes::write(ByteWriter& out, const Object& object)
{
    const auto& [path, style, particulars, hidden] = object;
    writePath(out, path);
    writeStyle(out, style);
    out.put(std::uint8_t(hidden));
    writeParticulars(out, particulars);
}

Object ObjectReader::object(ByteReader& in)
{
    Object object;
    object.path = path(in);
    object.style = readStyle(in);
    object.hidden = in.flag();
    object.particulars = *readParticulars(in);
    return object;
}

} // namespace app
