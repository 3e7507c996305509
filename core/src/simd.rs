//! The vector instructions of the processor at hand.
//!
//! Inner loops are written lane by lane in plain arrays or in vectors of four, each operation rounded as
//! IEEE 754 says. The compiler makes a version of them for each level of instructions and the program takes the best
//! one there is. It may not reorder or fuse operations, so all versions give the same bits, as the
//! tests that run them side by side hold it to.

pub(crate) use fearless_simd::prelude::*;
pub(crate) use fearless_simd::{Level, dispatch, f64x4, f64x8};

/// Every level this processor has.
#[cfg(test)]
pub(crate) fn levels() -> Vec<Level> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    let others = {
        use fearless_simd::Simd;
        let level = |token: Option<Level>| token;
        [
            level(best.as_sse2().map(Simd::level)),
            level(best.as_sse4_2().map(Simd::level)),
            level(best.as_avx2().map(Simd::level)),
        ]
    };
    #[cfg(not(target_arch = "x86_64"))]
    let others = [None; 0];
    others.into_iter().flatten().chain([best]).collect()
}
