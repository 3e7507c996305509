//! Controllers: the fuzzy reflex.

/// The reflex at work: activations are `[left, forward, right]`, section 5.6.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ReflexTrace {
    /// Nearest reading ahead, to the left and to the right, metres.
    pub nearest_m: [f64; 3],
    /// Membership of "near" ahead, left and right.
    pub near: [f64; 3],
    /// `α_a`, obstacle avoidance.
    pub avoid: [f64; 3],
    /// `α_g`, goal following.
    pub goal: [f64; 3],
    /// `α_f`, Eq. (5.8).
    pub fused: [f64; 3],
    /// `α_r`, the defuzzified rotation, radians.
    pub rotation_rad: f64,
}
