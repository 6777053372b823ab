#version 450 core
// How far a loop goes before the driver leaves it. Each round depends on the last in a way that no
// compiler takes a short cut through.

layout(local_size_x = 1) in;

layout(std430, binding = 0) buffer Probe {
    uint state; // of a generator: the host steps one beside it
};

layout(location = 0) uniform uint rounds;

void main() {
    uint x = state;
    for (uint i = 0u; i < rounds; ++i) x = (x ^ x >> 15) * 0x2c1b3c6du + i;
    state = x;
}
