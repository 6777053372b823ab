#include "core/io/gltf_meshopt.h"

#ifdef DIRT_HAVE_MESHOPT

#include "core/io/load_report.h"

#include <meshoptimizer.h>

namespace dirt {

namespace {

/// Of vertices 64 bytes take at least one, of triangles (12 bytes) and of indices each one.
constexpr uint64_t kMostFromOneByte = 64;

int decode(const std::string& mode, size_t count, size_t stride, std::span<const std::byte> bytes,
           std::string& out) {
    const auto* data = (const unsigned char*) bytes.data();
    if (mode == "ATTRIBUTES")
        return meshopt_decodeVertexBuffer(out.data(), count, stride, data, bytes.size());
    if (mode == "TRIANGLES")
        return meshopt_decodeIndexBuffer(out.data(), count, stride, data, bytes.size());
    return meshopt_decodeIndexSequence(out.data(), count, stride, data, bytes.size());
}

/// Throws InputError where the decoder's own conditions do not hold, which it takes for granted.
void check(const JsonValue& source, const std::string& mode, const std::string& filter,
           uint64_t count, uint64_t stride) {
    const bool vertices = mode == "ATTRIBUTES";
    if (!vertices && mode != "TRIANGLES" && mode != "INDICES")
        source.fail("has an unknown mode " + inQuotes(mode));
    if (vertices ? stride % 4 != 0 || stride == 0 || stride > 256 : stride != 2 && stride != 4)
        source.fail("has a byteStride that its mode does not allow");
    if (mode == "TRIANGLES" && count % 3 != 0) source.fail("has corners that make no triangles");
    const bool fits =
        filter == "NONE" ||
        (vertices && ((filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) ||
                      (filter == "QUATERNION" && stride == 8) || filter == "EXPONENTIAL"));
    if (!fits) source.fail("has a filter that its mode and byteStride do not allow");
}

} // namespace

std::string decodeMeshopt(const JsonValue& source, std::span<const std::byte> bytes,
                          MemoryClaim& memory) {
    const std::string mode = source.text("mode").value_or("");
    const std::string filter = source.text("filter").value_or("NONE");
    const uint64_t count = source.requiredInteger("count", JsonValue::kMostIndex);
    const uint64_t stride = source.requiredInteger("byteStride", JsonValue::kMostIndex);
    check(source, mode, filter, count, stride);
    if (count * stride / kMostFromOneByte > bytes.size())
        source.fail("claims more than its bytes can hold");
    memory.take(count * stride, source.file(), source.place());
    std::string out(count * stride, '\0');
    if (decode(mode, count, stride, bytes, out) != 0)
        source.fail("holds no meshopt data that can be read");
    // The filters take four elements at a time, and read and write no more than there are.
    if (filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), count, stride);
    if (filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), count, stride);
    if (filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), count, stride);
    return out;
}

} // namespace dirt

#else

namespace dirt {

std::string decodeMeshopt(const JsonValue& source, std::span<const std::byte>, MemoryClaim&) {
    source.fail("cannot be read: this program was built without meshoptimizer");
}

} // namespace dirt

#endif
