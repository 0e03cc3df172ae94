//! Figures drawn: the only place that knows plotters.
