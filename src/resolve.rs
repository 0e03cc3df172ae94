//! Adaptive sampling of a continuous function until its spectrum has ended.
