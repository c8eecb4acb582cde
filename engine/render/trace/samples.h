// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"

namespace sl {

/// Well-spread points of the unit square for one pixel: Owen-scrambled Sobol' pairs, padded to as many dimensions as a
/// path asks for (Burley, "Practical Hash-based Owen Scrambling", JCGT 2020). A point depends on seed, pixel, sample and
/// dimension alone, so any split of the work over threads, runs and machines gives the same points.
class SampleSequence {
  public:
    SampleSequence(std::uint32_t seed, uvec2 pixel, std::uint32_t sample)
        : seed_(mix(mix(mix(seed ^ 0x68bc21ebu) ^ pixel.x) ^ (pixel.y * 0x9e3779b1u))), reversed_sample_(reverse(sample)) {}

    /// The next two dimensions, each in [0, 1).
    vec2 pair() {
        // Numbers are kept with their bits reversed where that saves turning them round twice.
        const std::uint32_t seed = mix(seed_ ^ (++dimension_ * 0x85ebca6bu));
        const std::uint32_t index = reverse(scramble_reversed(reversed_sample_, seed));
        const std::uint32_t x = scramble_reversed(index, mix(seed ^ 0xb5297a4du));
        const std::uint32_t y = scramble_reversed(pascal(index), mix(seed ^ 0x1b56c4e9u));
        return vec2(to_unit(reverse(x)), to_unit(reverse(y)));
    }

  private:
    static std::uint32_t mix(std::uint32_t h) {
        h = (h ^ (h >> 16)) * 0x7feb352du;
        h = (h ^ (h >> 15)) * 0x846ca68bu;
        return h ^ (h >> 16);
    }
    static std::uint32_t reverse(std::uint32_t v) {
        v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
        v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
        v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
        return __builtin_bswap32(v);
    }
    /// Owen scrambling of a number whose bits are reversed: each bit is flipped by a hash of the bits above it (Laine &
    /// Karras 2011; constants of Vegdahl 2021).
    static std::uint32_t scramble_reversed(std::uint32_t v, std::uint32_t seed) {
        v ^= v * 0x3d20adeau;
        v += seed;
        v *= (seed >> 16) | 1u;
        v ^= v * 0x05526c56u;
        v ^= v * 0x53a22864u;
        return v;
    }
    /// Times Pascal's triangle modulo 2, whose reversed bits are the second dimension of the Sobol' sequence: bit j is the
    /// parity of all bits k whose number contains j's (Lucas), summed up one binary digit at a time.
    static std::uint32_t pascal(std::uint32_t v) {
        v ^= (v & 0xaaaaaaaau) >> 1;
        v ^= (v & 0xccccccccu) >> 2;
        v ^= (v & 0xf0f0f0f0u) >> 4;
        v ^= (v & 0xff00ff00u) >> 8;
        return v ^ (v >> 16);
    }
    static float to_unit(std::uint32_t v) { return static_cast<float>(v >> 8) * 0x1p-24f; }

    std::uint32_t seed_, reversed_sample_, dimension_ = 0;
};

}  // namespace sl
