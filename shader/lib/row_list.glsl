// SPDX-License-Identifier: MIT
// Lists of pixels, one per row of a picture, in one array: each row's count, then its columns.
uint row_list_count(uint row, uint width) { return row * (width + 1u); }
uint row_list_entry(uint row, uint width, uint entry) { return row * (width + 1u) + 1u + entry; }
