#pragma once

#include "core/io/obj.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dirt {

/// What reading an OBJ file gives.
struct ReadObj {
    ObjFile obj;
    std::vector<std::string> ignored; ///< as LoadReport has them
};

/// Where the cache of an OBJ file may lie, the first choice first: beside it, as NAME.obj.sbin,
/// then in the user's folder for caches ($XDG_CACHE_HOME/dirt, else ~/.cache/dirt).
std::vector<std::filesystem::path> cachePlaces(const std::filesystem::path& obj);

/// A cache that holds \p content, which encodeCache lays out, made from \p source.
std::string sealCache(const std::string& content, std::span<const std::byte> source);

/// The bytes of a cache of \p read, made from \p source, the bytes of the OBJ file.
std::string encodeCache(const ReadObj& read, std::span<const std::byte> source);

/// The contents of a cache, if it is one of this version and kind of machine, sound, and made from
/// the very bytes of \p source; nothing else. \p file is the OBJ file's name.
std::optional<ReadObj> decodeCache(std::span<const std::byte> cache,
                                   std::span<const std::byte> source,
                                   const std::filesystem::path& file);

/// readObj through its cache: taken from there where one is sound and made from what the file holds
/// now, and left there otherwise, under a temporary name until it is whole, which \p report is
/// told. A cache that cannot be read, made or kept is never an error. Small files, which are read
/// as fast, have none. \p memory takes what the result needs.
ObjFile readObjCached(const std::filesystem::path& file, LoadReport& report, MemoryClaim& memory);

} // namespace dirt
