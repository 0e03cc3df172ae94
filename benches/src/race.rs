//! Contenders take turns, so that what slows the machine slows them all.

use crate::memory::peak_of;
use serde::{Deserialize, Serialize};
use std::time::{Duration, Instant};

/// One way to do a job.
pub struct Contender<'a> {
    name: String,
    ours: bool,
    error: f64,
    run: Box<dyn FnMut() + Send + 'a>,
}

impl<'a> Contender<'a> {
    /// Ours. `error` is how far its result is from the reference, measured before the race in the norm that the job names.
    pub fn ours(name: impl Into<String>, error: f64, run: impl FnMut() + Send + 'a) -> Self {
        Self { name: name.into(), ours: true, error, run: Box::new(run) }
    }

    /// Another library's.
    pub fn peer(name: impl Into<String>, error: f64, run: impl FnMut() + Send + 'a) -> Self {
        Self { ours: false, ..Self::ours(name, error, run) }
    }
}

/// A job of one size, done by several contenders on so many threads.
pub struct Race<'a> {
    /// What is done, in short: the line of the table.
    pub case: String,
    /// How many threads each may use.
    pub threads: usize,
    /// How fast it could be on this machine, in seconds, and what that counts.
    pub limit: Option<(f64, String)>,
    /// The largest error that counts as having done the job.
    pub allowed: f64,
    /// Who takes part.
    pub contenders: Vec<Contender<'a>>,
}

/// What came of a race.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Outcome {
    /// The job's letter.
    pub job: String,
    /// What was done.
    pub case: String,
    /// On how many threads.
    pub threads: usize,
    /// Seconds that the machine needs at least, and what was counted.
    pub limit: Option<(f64, String)>,
    /// The largest error allowed.
    pub allowed: f64,
    /// One line a contender.
    pub lines: Vec<Line>,
}

/// How one contender did.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Line {
    /// Who.
    pub name: String,
    /// Whether it is ours.
    pub ours: bool,
    /// The measured error.
    pub error: f64,
    /// Seconds: the least, the median, and half the distance between the quartiles.
    pub least: f64,
    /// The median.
    pub median: f64,
    /// Half the distance between the quartiles.
    pub spread: f64,
    /// Megabytes that one run needs beyond what stood in memory before it.
    pub memory: Option<f64>,
}

impl Outcome {
    /// The line of the fastest among ours, or among the others, that kept to the allowed error.
    pub fn best(&self, ours: bool) -> Option<&Line> {
        let able = self.lines.iter().filter(|line| line.ours == ours && line.error <= self.allowed);
        able.min_by(|a, b| a.median.total_cmp(&b.median))
    }

    /// Median of ours over median of the best other: below one is faster.
    pub fn ratio(&self) -> Option<f64> {
        Some(self.best(true)?.median / self.best(false)?.median)
    }
}

/// The least time that a measurement takes: shorter runs are repeated within it.
const LEAST: Duration = Duration::from_millis(20);

impl Race<'_> {
    /// Runs it: one run for warmth and memory, then `rounds` rounds in which each contender has its turn.
    pub fn run(self, job: &str, rounds: usize) -> Outcome {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.threads).build().expect("threads can be started");
        let Self { case, threads, limit, allowed, mut contenders } = self;
        let mut repeats = Vec::new();
        let mut memory = Vec::new();
        for contender in &mut contenders {
            memory.push(peak_of(|| pool.install(|| (contender.run)())));
            let once = timed(&pool, 1, &mut contender.run);
            repeats.push((LEAST.as_secs_f64() / once).clamp(1.0, 1e6) as usize);
        }
        let mut times = vec![Vec::new(); contenders.len()];
        for _ in 0..rounds {
            for ((contender, times), &repeats) in contenders.iter_mut().zip(&mut times).zip(&repeats) {
                times.push(timed(&pool, repeats, &mut contender.run));
            }
        }
        let lines = contenders.iter().zip(times).zip(memory).map(|((contender, mut times), memory)| {
            times.sort_by(f64::total_cmp);
            let at = |part: f64| times[(part * (times.len() - 1) as f64).round() as usize];
            Line {
                name: contender.name.clone(),
                ours: contender.ours,
                error: contender.error,
                least: times[0],
                median: at(0.5),
                spread: 0.5 * (at(0.75) - at(0.25)),
                memory,
            }
        });
        Outcome { job: job.to_owned(), case, threads, limit, allowed, lines: lines.collect() }
    }
}

/// Seconds a run, the mean of `repeats`.
fn timed(pool: &rayon::ThreadPool, repeats: usize, run: &mut (dyn FnMut() + Send)) -> f64 {
    pool.install(|| {
        let start = Instant::now();
        for _ in 0..repeats {
            run();
        }
        start.elapsed().as_secs_f64() / repeats as f64
    })
}
