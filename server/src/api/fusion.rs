//! `lost-at-sea`: the example of section 1.3.

use axum::Json;
use serde::Deserialize;
use sonarium_core::perception::lost_at_sea;
use utoipa::IntoParams;

use super::extract::Query;
use super::problem::Failure;
use crate::wire::{GaussianView, LostAtSea, Problem};

/// Greatest number asked about: beyond it, pictures and squares say nothing any more.
const MOST: f64 = 1e6;
/// Least standard deviation.
const LEAST_SIGMA: f64 = 1e-6;

/// Two measurements of one position; miles, kilometres or whatever is used throughout.
#[derive(Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct Measurements {
    /// z₁, where the star says we are.
    star: f64,
    /// σ₁, its standard deviation, above 0.
    star_sigma: f64,
    /// z₂, where the light beacon says we are.
    beacon: f64,
    /// σ₂, its standard deviation, above 0.
    beacon_sigma: f64,
}

/// Fuse what a star and a light beacon say about a position, as the Kalman filter does
#[utoipa::path(get, path = "/lost-at-sea", tag = "examples", params(Measurements),
    responses((status = 200, body = LostAtSea), (status = 400, body = Problem),
        (status = 422, body = Problem)))]
pub(super) async fn fuse(Query(asked): Query<Measurements>) -> Result<Json<LostAtSea>, Failure> {
    let star = measurement(["star", "star_sigma"], asked.star, asked.star_sigma)?;
    let beacon = measurement(["beacon", "beacon_sigma"], asked.beacon, asked.beacon_sigma)?;
    let filters = lost_at_sea([star.mean, star.sigma], [beacon.mean, beacon.sigma])
        .map_err(|error| Failure::not_acceptable("beacon_sigma", error.to_string()))?;
    let [_, both] = &filters;
    let fused = GaussianView { mean: both.state()[0], sigma: both.covariance()[0].sqrt() };
    let (first, second) = (star.sigma * star.sigma, beacon.sigma * beacon.sigma);
    Ok(Json(LostAtSea {
        star,
        beacon,
        innovation: beacon.mean - star.mean,
        // Eq. (1.10): K = P₀ Hᵀ (H P₀ Hᵀ + R)⁻¹
        gain: first / (first + second),
        fused,
        batch: GaussianView {
            // Eq. (1.10), right-hand side
            mean: (second * star.mean + first * beacon.mean) / (first + second),
            // Eq. (1.11)
            sigma: (first * second / (first + second)).sqrt(),
        },
    }))
}

fn measurement(fields: [&str; 2], mean: f64, sigma: f64) -> Result<GaussianView, Failure> {
    if !(mean.is_finite() && mean.abs() <= MOST) {
        let detail = format!("must be a number from -{MOST} to {MOST}, not {mean}");
        return Err(Failure::not_acceptable(fields[0], detail));
    }
    if !(LEAST_SIGMA..=MOST).contains(&sigma) {
        let detail = format!("must be a number from {LEAST_SIGMA} to {MOST}, not {sigma}");
        return Err(Failure::not_acceptable(fields[1], detail));
    }
    Ok(GaussianView { mean, sigma })
}

#[cfg(test)]
mod tests {
    use axum::http::StatusCode;

    use crate::testing::House;
    use crate::wire::LostAtSea;

    #[tokio::test]
    async fn the_recursion_and_the_batch_agree_and_both_are_surer_than_either() {
        let house = House::new();
        for (z1, s1, z2, s2) in [(0.0, 4.0, 5.0, 2.0), (-7.5, 0.3, 12.0, 9.0), (1.0, 1.0, 1.0, 1.0)]
        {
            let path = format!(
                "/api/v1/lost-at-sea?star={z1}&star_sigma={s1}&beacon={z2}&beacon_sigma={s2}"
            );
            let answer = house.get(&path).await;
            let sea: LostAtSea = serde_json::from_slice(&answer.bytes).expect("an answer");
            assert!((sea.fused.mean - sea.batch.mean).abs() < 1e-12, "{sea:?}");
            assert!((sea.fused.sigma - sea.batch.sigma).abs() < 1e-12, "{sea:?}");
            assert!(sea.fused.sigma < f64::min(s1, s2), "{sea:?}");
            assert!((z1 + sea.gain * sea.innovation - sea.fused.mean).abs() < 1e-12, "{sea:?}");
        }
    }

    #[tokio::test]
    async fn a_deviation_that_cannot_be_is_named() {
        let house = House::new();
        for (query, status, field) in [
            ("star=0&star_sigma=0&beacon=1&beacon_sigma=1", 422, "star_sigma"),
            ("star=0&star_sigma=1&beacon=1&beacon_sigma=-1", 422, "beacon_sigma"),
            ("star=1e9&star_sigma=1&beacon=1&beacon_sigma=1", 422, "star"),
            ("star=a&star_sigma=1&beacon=1&beacon_sigma=1", 400, "star"),
        ] {
            let answer = house.get(&format!("/api/v1/lost-at-sea?{query}")).await;
            assert_eq!(answer.status, StatusCode::from_u16(status).expect("a status"), "{query}");
            assert_eq!(answer.json()["field"], field, "{query}");
        }
    }
}
