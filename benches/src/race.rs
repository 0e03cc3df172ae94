//! Contenders take turns, so that what slows the machine slows them all.

use crate::memory::peak_of;
use rayon::ThreadPool;
use serde::{Deserialize, Serialize};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// One way to do a job.
pub struct Contender<'a> {
    name: String,
    ours: bool,
    begin: Box<dyn FnOnce(&ThreadPool) -> Begun<'a> + 'a>,
}

/// What is known after the first run: the memory that it took, the error of its result, and how to run again.
struct Begun<'a> {
    memory: Option<f64>,
    error: f64,
    run: Box<dyn FnMut() + Send + 'a>,
}

impl<'a> Contender<'a> {
    /// Ours. `make` builds what is kept from run to run: the plan, its rooms, the place of the result if it has one. `run`
    /// does the job with it, and `error` is how far the first result is from the reference, in the norm that the job names.
    pub fn ours<K: Send + 'a, R: Send>(
        name: impl Into<String>,
        make: impl FnOnce() -> K + Send + 'a,
        mut run: impl FnMut(&mut K) -> R + Send + 'a,
        error: impl FnOnce(&mut K, R) -> f64 + 'a,
    ) -> Self {
        let begin = move |pool: &ThreadPool| {
            let mut first = None;
            let memory = peak_of(|| {
                first = Some(pool.install(|| {
                    let mut kept = make();
                    let result = run(&mut kept);
                    (kept, result)
                }));
            });
            let (mut kept, result) = first.expect("the work was done");
            let error = error(&mut kept, result);
            Begun { memory, error, run: Box::new(move || drop(black_box(run(&mut kept)))) }
        };
        Self { name: name.into(), ours: true, begin: Box::new(begin) }
    }

    /// Another library's.
    pub fn peer<K: Send + 'a, R: Send>(
        name: impl Into<String>,
        make: impl FnOnce() -> K + Send + 'a,
        run: impl FnMut(&mut K) -> R + Send + 'a,
        error: impl FnOnce(&mut K, R) -> f64 + 'a,
    ) -> Self {
        Self { ours: false, ..Self::ours(name, make, run, error) }
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
    /// Megabytes that the plan, the first run and its result need at most beyond what stood in memory before them.
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
    /// Runs it: each contender begins, for memory and error, then `rounds` rounds in which each has its turn.
    pub fn run(self, job: &str, rounds: usize) -> Outcome {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(self.threads).build().expect("threads can be started");
        let Self { case, threads, limit, allowed, contenders } = self;
        let (mut lines, mut runs, mut repeats) = (Vec::new(), Vec::new(), Vec::new());
        for Contender { name, ours, begin } in contenders {
            let Begun { memory, error, mut run } = begin(&pool);
            let once = timed(&pool, 1, &mut run);
            repeats.push((LEAST.as_secs_f64() / once).clamp(1.0, 1e6) as usize);
            runs.push(run);
            lines.push(Line { name, ours, error, least: once, median: once, spread: 0.0, memory });
        }
        let mut times = vec![Vec::new(); lines.len()];
        for _ in 0..rounds {
            for ((run, times), &repeats) in runs.iter_mut().zip(&mut times).zip(&repeats) {
                times.push(timed(&pool, repeats, run));
            }
        }
        for (line, times) in lines.iter_mut().zip(&mut times) {
            times.sort_by(f64::total_cmp);
            let at = |part: f64| times[(part * (times.len() - 1) as f64).round() as usize];
            (line.least, line.median, line.spread) = (times[0], at(0.5), 0.5 * (at(0.75) - at(0.25)));
        }
        Outcome { job: job.to_owned(), case, threads, limit, allowed, lines }
    }
}

/// Seconds a run, the mean of `repeats`.
fn timed(pool: &ThreadPool, repeats: usize, run: &mut (dyn FnMut() + Send)) -> f64 {
    pool.install(|| {
        let start = Instant::now();
        for _ in 0..repeats {
            run();
        }
        start.elapsed().as_secs_f64() / repeats as f64
    })
}
