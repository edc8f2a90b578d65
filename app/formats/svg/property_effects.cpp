// SPDX-License-Identifier: GPL-3.0-or-later
// The properties that are not evaluated.
#include "app/formats/svg/property.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

// Whether a name is the pattern, or begins with the pattern's text before its final *.
bool fits(std::string_view name, std::string_view pattern)
{
    if (!pattern.ends_with('*'))
        return name == pattern;
    pattern.remove_suffix(1);
    return name.starts_with(pattern);
}

constexpr std::array lost{
    LostProperty{"all", ""},
    LostProperty{"animation*", "none"},
    LostProperty{"backdrop-filter", "none"},
    LostProperty{"background", "none transparent white #fff #ffffff rgb(255,255,255)", true},
    LostProperty{"background-color", "transparent white #fff #ffffff rgb(255,255,255)", true},
    LostProperty{"background-image", "none", true},
    LostProperty{"border*", "none 0 0px", true},
    LostProperty{"box-shadow", "none", true},
    LostProperty{"clip", "auto"},
    LostProperty{"content-visibility", "visible auto"},
    LostProperty{"mask-border*", "none 0"},
    LostProperty{"mask-image", "none"},
    LostProperty{"offset*", "none auto normal 0"},
    LostProperty{"outline*", "none 0 0px"},
    LostProperty{"overflow-*", "auto hidden clip scroll normal anywhere break-word"},
    LostProperty{"perspective", "none"},
    LostProperty{"shape-rendering", "auto geometricPrecision"}, // the others have hard edges
    LostProperty{"zoom", "1 100% normal"},
};

constexpr auto withoutEffect = std::to_array<std::string_view>({
    // of text alone
    "font*",
    "glyph-orientation*",
    "hanging-punctuation",
    "hyphen*",
    "initial-letter*",
    "line*",
    "quotes",
    "ruby*",
    "shape-image-threshold",
    "shape-margin",
    "shape-outside",
    "shape-padding",
    "shape-subtract",
    "tab-size",
    "text*",
    "white-space*",
    "word*",
    // of filters, masks, gradients and images, which are told themselves
    "buffered-rendering",
    "color-interpolation-filters",
    "color-profile",
    "color-rendering",
    "enable-background",
    "flood-color",
    "flood-opacity",
    "image-orientation",
    "image-resolution",
    "lighting-color",
    "mask-*",
    "object-fit",
    "object-position",
    "solid-color",
    "solid-opacity",
    // hints on quality, and what a pointer does
    "accent-color",
    "caret*",
    "color-adjust",
    "color-scheme",
    "cursor",
    "forced-color-adjust",
    "nav*",
    "overscroll*",
    "pointer-events",
    "print-color-adjust",
    "resize",
    "scroll*",
    "touch-action",
    "transition*",
    "user-select",
    "will-change",
    // without effect unless another property has one
    "backface-visibility",
    "background-*",
    "isolation",
    "perspective-origin",
    "transform-style",
    // of boxes in pages, which shapes are not
    "align*",
    "appearance",
    "aspect-ratio",
    "block*",
    "bottom",
    "box-decoration-break",
    "box-sizing",
    "break*",
    "caption-side",
    "clear",
    "column*",
    "contain",
    "contain-*",
    "container*",
    "content",
    "counter*",
    "empty-cells",
    "flex*",
    "float",
    "gap",
    "grid*",
    "inline*",
    "inset*",
    "justify*",
    "left",
    "list*",
    "margin*",
    "max*",
    "min*",
    "order",
    "orphans",
    "padding*",
    "page*",
    "place*",
    "position",
    "right",
    "row-gap",
    "speak*",
    "table-layout",
    "top",
    "vertical-align",
    "widows",
    "z-index",
    // of other programs
    "-*",
});

} // namespace

std::span<const LostProperty> lostProperties() { return lost; }
std::span<const std::string_view> propertiesWithoutEffect() { return withoutEffect; }

static const LostProperty* findLost(std::string_view name)
{
    const auto row =
        std::ranges::find_if(lost, [&](const LostProperty& each) { return fits(name, each.name); });
    return row == lost.end() ? nullptr : &*row;
}

bool isLost(std::string_view name, std::string_view value, bool isRoot)
{
    if (const LostProperty* row = findLost(name))
        return (isRoot || !row->ofRoot)
               && std::ranges::none_of(wordsOf(row->without), [&](std::string_view without) {
                      return equalsIgnoringCase(without, value);
                  });
    return true;
}

bool hasNoEffect(std::string_view name)
{
    return !findLost(name) && std::ranges::any_of(withoutEffect, [&](std::string_view pattern) {
        return fits(name, pattern);
    });
}

std::string plainName(std::string_view name)
{
    for (const std::string_view prefix : {"-webkit-", "-moz-"})
        if (equalsIgnoringCase(name.substr(0, prefix.size()), prefix)) {
            const std::string plain = plainName(name.substr(prefix.size()));
            return findProperty(plain) || findLost(plain) ? plain : std::string(name);
        }
    std::string small(name);
    std::ranges::transform(small, small.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return small;
}

} // namespace app::svg
