//! From samples back to a signal.
