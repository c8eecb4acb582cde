// SPDX-License-Identifier: MIT
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

namespace sl {

/// Asks for huge pages once an array is large: a million components then cost some ten page faults instead of
/// thousands, which halves the time to create them.
template <class T>
struct HugePageAllocator {
    using value_type = T;
    static constexpr std::size_t huge_page = std::size_t{2} << 20;

    HugePageAllocator() = default;
    template <class Other>
    HugePageAllocator(const HugePageAllocator<Other>&) noexcept {}

    T* allocate(std::size_t count) {
        if (!large(count)) return std::allocator<T>().allocate(count);
        if (count > (std::size_t{1} << 48) / sizeof(T)) throw std::bad_array_new_length();
        const std::size_t bytes = (count * sizeof(T) + huge_page - 1) / huge_page * huge_page;
        void* memory = std::aligned_alloc(huge_page, bytes);
        if (memory == nullptr) throw std::bad_alloc();
        madvise(memory, bytes, MADV_HUGEPAGE);  // a wish: small pages are right too
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) noexcept {
        if (large(count)) {
            std::free(memory);
        } else {
            std::allocator<T>().deallocate(memory, count);
        }
    }
    template <class Other>
    bool operator==(const HugePageAllocator<Other>&) const noexcept {
        return true;
    }

  private:
    static constexpr bool large(std::size_t count) { return count >= huge_page / sizeof(T); }
};

/// A vector in huge pages where the system has them.
template <class T>
using LargeVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace sl
