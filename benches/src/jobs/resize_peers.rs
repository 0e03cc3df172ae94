//! The other crates that resize images.

use crate::jobs::resize::{Case, Make, Run, Way};
use fast_image_resize::images::{Image, ImageRef};
use fast_image_resize::{FilterType, PixelType, ResizeAlg, ResizeOptions, create_srgb_mapper};
use pic_scale::{ImageSize, ImageStore, ImageStoreMut, LinearScaler, ResamplingFunction, Scaler, ThreadingPolicy};

/// A kind of number that others resize, too.
pub trait Known: Sized {
    /// What others make of it.
    fn peers(case: Case, source: &[Self], threads: usize) -> Vec<Way<'_, Self>>;
}

impl Known for f32 {
    fn peers(case: Case, source: &[Self], threads: usize) -> Vec<Way<'_, Self>> {
        let bytes: &[u8] = bytemuck::cast_slice(source);
        let pixel = [PixelType::F32, PixelType::F32x3][case.channels / 2];
        let fast = move || -> Run<'_, Self> {
            let mut fast = fast(case, bytes, pixel);
            Box::new(move |out| fast(bytemuck::cast_slice_mut(out)))
        };
        both(Box::new(fast), Box::new(move || Self::plan(case, source, threads)))
    }
}

impl Known for u8 {
    fn peers(case: Case, source: &[Self], threads: usize) -> Vec<Way<'_, Self>> {
        let pixel = [PixelType::U8, PixelType::U8x3][case.channels / 2];
        let fast = move || -> Run<'_, Self> {
            if case.light { Box::new(fast_light(case, source, pixel)) } else { Box::new(fast(case, source, pixel)) }
        };
        both(Box::new(fast), Box::new(move || Self::plan(case, source, threads)))
    }
}

fn both<'a, C>(fast: Make<'a, C>, pic: Make<'a, C>) -> Vec<Way<'a, C>> {
    vec![Way { name: "fast_image_resize 6.1.0", make: fast }, Way { name: "pic-scale 0.7.12", make: pic }]
}

fn options(case: Case) -> ResizeOptions {
    let filter = match case.kernel {
        "mitchell" => FilterType::Mitchell,
        "catmull-rom" => FilterType::CatmullRom,
        _ => FilterType::Lanczos3,
    };
    ResizeOptions::new().resize_alg(ResizeAlg::Convolution(filter)).use_alpha(false)
}

fn fast(case: Case, source: &[u8], pixel: PixelType) -> impl FnMut(&mut [u8]) + Send + '_ {
    let (from, to) = (case.from as u32, case.to as u32);
    let source = ImageRef::new(from, from, source, pixel).expect("the sizes agree");
    let (options, mut resizer) = (options(case), fast_image_resize::Resizer::new());
    move |out| {
        let mut target = Image::from_slice_u8(to, to, out, pixel).expect("the sizes agree");
        resizer.resize(&source, &mut target, &options).expect("one kind of pixels");
    }
}

/// Through light in 16 bits, as its documentation shows.
fn fast_light(case: Case, source: &[u8], pixel: PixelType) -> impl FnMut(&mut [u8]) + Send + '_ {
    let (from, to) = (case.from as u32, case.to as u32);
    let wide = [PixelType::U16, PixelType::U16x3][case.channels / 2];
    let source = ImageRef::new(from, from, source, pixel).expect("the sizes agree");
    let (mut light, mut small) = (Image::new(from, from, wide), Image::new(to, to, wide));
    let (options, mapper) = (options(case), create_srgb_mapper());
    let mut resizer = fast_image_resize::Resizer::new();
    move |out| {
        let mut target = Image::from_slice_u8(to, to, out, pixel).expect("the sizes agree");
        mapper.forward_map(&source, &mut light).expect("the sizes agree");
        resizer.resize(&light, &mut small, &options).expect("one kind of pixels");
        mapper.backward_map(&small, &mut target).expect("the sizes agree");
    }
}

/// A kind of number of pic-scale.
trait Scaled: Copy + Default + Send + Sync + std::fmt::Debug + 'static {
    /// A plan, as a function that uses it.
    fn plan<'a>(case: Case, source: &'a [Self], threads: usize) -> Run<'a, Self>;
}

macro_rules! plan {
    ($plan:expr, $case:ident, $source:ident, $depth:literal, $channels:literal) => {{
        let plan = $plan.expect("sizes are positive");
        let mut store =
            ImageStore::<Self, $channels>::borrow($source, $case.from, $case.from).expect("the sizes agree");
        store.bit_depth = $depth;
        let mut scratch = plan.alloc_scratch();
        Box::new(move |out| {
            let mut target =
                ImageStoreMut::<Self, $channels>::borrow(out, $case.to, $case.to).expect("the sizes agree");
            target.bit_depth = $depth;
            plan.resample_with_scratch(&store, &mut target, &mut scratch).expect("the sizes agree");
        })
    }};
}

fn sizes(case: Case) -> (ImageSize, ImageSize) {
    (ImageSize::new(case.from, case.from), ImageSize::new(case.to, case.to))
}

fn function(case: Case) -> ResamplingFunction {
    match case.kernel {
        "mitchell" => ResamplingFunction::MitchellNetravalli,
        "catmull-rom" => ResamplingFunction::CatmullRom,
        _ => ResamplingFunction::Lanczos3,
    }
}

fn policy(threads: usize) -> ThreadingPolicy {
    if threads == 1 { ThreadingPolicy::Single } else { ThreadingPolicy::Fixed(threads) }
}

impl Scaled for f32 {
    fn plan<'a>(case: Case, source: &'a [Self], threads: usize) -> Run<'a, Self> {
        let ((from, to), mut scaler) = (sizes(case), Scaler::new(function(case)));
        scaler.set_threading_policy(policy(threads));
        match case.channels {
            1 => plan!(scaler.plan_planar_resampling_f32(from, to), case, source, 0, 1),
            _ => plan!(scaler.plan_rgb_resampling_f32(from, to), case, source, 0, 3),
        }
    }
}

impl Scaled for u8 {
    fn plan<'a>(case: Case, source: &'a [Self], threads: usize) -> Run<'a, Self> {
        let (from, to) = sizes(case);
        if case.light {
            let mut scaler = LinearScaler::new(function(case));
            scaler.set_threading_policy(policy(threads));
            return match case.channels {
                1 => plan!(scaler.plan_planar_resampling(from, to), case, source, 8, 1),
                _ => plan!(scaler.plan_rgb_resampling(from, to), case, source, 8, 3),
            };
        }
        let mut scaler = Scaler::new(function(case));
        scaler.set_threading_policy(policy(threads));
        match case.channels {
            1 => plan!(scaler.plan_planar_resampling(from, to), case, source, 8, 1),
            _ => plan!(scaler.plan_rgb_resampling(from, to), case, source, 8, 3),
        }
    }
}
