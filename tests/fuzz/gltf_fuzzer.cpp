// The glTF reader, text and binary, and the placement of what it read.

#include "tests/fuzz/gltf_read.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, dirt::fuzz::readGltfWhole);
}
