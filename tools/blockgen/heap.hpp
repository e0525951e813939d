#pragma once

namespace rockslope {

/// Takes a gigabyte of addresses for the heap, asks the system for large pages there, and keeps freed memory
/// in the process: a large model fills and frees arrays in turn, and a third of its time went into single
/// pages. Memory is used only as it is touched. Does nothing where addresses are limited or the system has no
/// such pages.
void use_large_pages();

}  // namespace rockslope
