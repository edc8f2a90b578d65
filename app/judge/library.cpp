// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/library.h"

#include "app/judge/child.h"

#include <algorithm>
#include <dlfcn.h>

namespace app::plug_in {
namespace {

/// One line of printable characters.
std::string plain(const char* text)
{
    constexpr std::size_t most = 300;
    std::string line;
    for (; text && *text != '\0' && line.size() < most; ++text)
        line += (static_cast<unsigned char>(*text) < ' ') ? ' ' : *text;
    return line;
}

Library failed(const char* word, const std::string& more)
{
    return {nullptr, {}, std::string(word) + ' ' + more};
}

} // namespace

Library loaded(const char* path)
{
    void* const library = ::dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return failed(hello::notLoadable, plain(::dlerror()));
    if (void* const version = ::dlsym(library, "clearcut_abi_version"))
        if (const int its = reinterpret_cast<int (*)()>(version)(); its != CLEARCUT_ABI_VERSION)
            return failed(hello::otherVersion, std::to_string(its));
    void* const clip = ::dlsym(library, "clearcut_clip");
    if (!clip)
        return failed(hello::noFunction, {});
    void* const name = ::dlsym(library, "clearcut_name");
    return {reinterpret_cast<Clip>(clip),
            name ? plain(reinterpret_cast<const char* (*)()>(name)()) : std::string(),
            {}};
}

} // namespace app::plug_in
