// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/change_bytes.h"

#include "app/commands/move_objects.h"
#include "app/commands/transform_objects.h"

#include <algorithm>

namespace app {
namespace {

using How = Derivation::How;

// Whether the splices replace objects one for one.
bool exchanges(std::span<const Splice> splices)
{
    return std::ranges::all_of(splices, [](const Splice& s) { return s.removed == s.added; });
}

Objects addedObjects(const Document& now, std::span<const Splice> splices)
{
    Objects added = now.objects().slice(0, 0);
    for (const Splice& s : inverse(splices))
        added.append(now.objects().slice(s.first, s.removed));
    return added;
}

std::size_t sizeOf(std::span<const Splice> splices)
{
    std::size_t size = 0;
    for (const Splice& s : splices)
        size += s.added;
    return size;
}

// The styles that are used, and one index for all objects or one for each.
void writeStyles(ByteWriter& out, const Document& now, std::span<const Splice> splices)
{
    std::vector<StyleIndex> used;
    std::vector<std::uint32_t> each;
    std::unordered_map<StyleIndex, std::uint32_t> numbers;
    StyleIndex last = 0; // neighbours often have the same style
    std::uint32_t number = 0;
    each.reserve(sizeOf(splices));
    for (const Splice& s : splices)
        now.objects().forEach(s.first, s.added, [&](std::size_t, const ObjectView& object) {
            const StyleIndex style = object.styleIndex();
            if (used.empty() || style != last) {
                const auto [at, isNew] = numbers.try_emplace(style, std::uint32_t(used.size()));
                if (isNew)
                    used.push_back(style);
                number = at->second;
                last = style;
            }
            each.push_back(number);
        });
    out.putCount(used.size());
    for (const StyleIndex style : used)
        writeStyle(out, now.styles()[style]);
    out.putList(std::span(each).first(used.size() == 1 ? 1 : each.size()));
}

std::optional<Edit> readStyles(ByteReader& in, const Document& document,
                               std::span<const Splice> splices)
{
    std::vector<Style> styles;
    for (std::size_t left = in.count(1); left > 0 && in.ok(); --left)
        styles.push_back(readStyle(in));
    const auto each = in.list<std::uint32_t>();
    in.require(each.size() == sizeOf(splices) || each.size() == 1);
    for (const std::uint32_t style : each)
        in.require(style < styles.size());
    if (!in.ok())
        return std::nullopt;
    std::vector<StyleEntry> entries;
    std::size_t next = 0;
    return changed(document, addedBy(splices), [&](ObjectRow& object, StyleTable& table) {
        if (entries.empty())
            for (const Style& style : styles)
                entries.push_back(table.entryOf(style));
        object.style = entries[each[each.size() == 1 ? 0 : next++]];
    });
}

} // namespace

// The parts other than objects that the edit set, whose undoing is `back`.
static Edit settingOf(const Edit& back, const Document& now)
{
    Edit set;
    if (back.containers)
        set.containers = now.containers();
    if (back.windows)
        set.windows = now.windows();
    if (back.page)
        set.page = now.page();
    return set;
}

Objects writeChange(ByteWriter& out, const EditCommand& command, const Document& now)
{
    Objects written;
    const Edit& back = command.next();
    const std::vector<Splice> splices = inverse(back.splices);
    const bool plain = !back.containers && !back.windows && !back.page;
    const How meant = command.derivation().how;
    const How how = exchanges(splices) && (plain || meant == How::Restyled) ? meant : How::Unknown;
    out.put(how);
    KnownImages images = back.containers ? imagesOf(*back.containers) : KnownImages();
    writeSplices(out, splices);
    if (how == How::Placed) {
        out.put(command.derivation().where);
    } else if (how == How::Mapped) {
        out.put(command.derivation().map);
    } else if (how == How::Restyled) {
        writeStyles(out, now, splices);
        writeSetting(out, settingOf(back, now), images);
    } else {
        written = addedObjects(now, splices);
        ObjectBytes().write(out, written);
        writeSetting(out, settingOf(back, now), images);
    }
    return written;
}

std::optional<Change> readChange(ByteReader& in, const Document& document)
{
    const How how = in.choice(How::Mapped);
    std::vector<Splice> splices = readSplices(in);
    std::uint64_t end = 0;
    for (const Splice& s : splices) {
        in.require(s.first >= end && (how == How::Unknown || s.removed == s.added));
        end = std::uint64_t(s.first) + s.removed;
    }
    in.require(end <= document.objects().size());
    if (!in.ok())
        return std::nullopt;

    KnownImages images = imagesOf(document.containers());
    Change change{{}, {how}};
    if (how == How::Placed) {
        const auto where = change.derivation.where = in.get<Placement>();
        change.edit = changed(document, addedBy(splices),
                              [&](ObjectRow& object, StyleTable&) { place(object, where); });
    } else if (how == How::Mapped) {
        const auto map = change.derivation.map = in.get<AffineMap>();
        change.edit = changed(document, addedBy(splices),
                              [&](ObjectRow& object, StyleTable&) { transform(object, map); });
    } else if (how == How::Restyled) {
        auto edit = readStyles(in, document, splices);
        if (!edit)
            return std::nullopt;
        change.edit = std::move(*edit);
        readSetting(in, change.edit, images);
    } else {
        change.edit.objects = document.objects().slice(0, 0);
        ObjectReader().read(in, change.edit.objects);
        readSetting(in, change.edit, images);
    }
    change.edit.splices = std::move(splices);
    if (!in.ok() || !in.atEnd() || !fits(change.edit, document))
        return std::nullopt;
    return change;
}

} // namespace app
