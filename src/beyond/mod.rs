//! Beyond uniform sampling: derivatives, interlaced and band-pass combs, irregular positions.
