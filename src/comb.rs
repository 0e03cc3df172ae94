//! The Dirac comb.
