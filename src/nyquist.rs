//! Folding, verdicts and rates.
