//! `worlds/trace`: a world traced from a ROS map.

use axum::Json;
use axum::body::Body as RawBody;
use axum::extract::{FromRequest, Request};
use axum::http::header;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use multer::Multipart;

use super::blocking;
use super::extract::{Body, Raw, media_type};
use super::problem::Failure;
use crate::rosmap::{Options, trace};
use crate::wire::{Problem, TraceDraft, TraceRequest};

/// A map as it came.
struct Map {
    picture: Vec<u8>,
    yaml: String,
    options: Options,
}

/// Trace the walls of a ROS map
///
/// Either JSON, or a form with the files `image` and `yaml` and, if wanted, `speck_m2`, `crop` (`x0, y0,
/// x1, y1`) and `name`. Nothing is saved: the draft goes back for its user to finish.
#[utoipa::path(post, path = "/worlds/trace", tag = "worlds", request_body = TraceRequest,
    responses((status = 200, body = TraceDraft), (status = 400, body = Problem),
        (status = 413, body = Problem), (status = 422, body = Problem)))]
pub(super) async fn create(request: Request) -> Result<Json<TraceDraft>, Failure> {
    let map = if media_type(request.headers()).eq_ignore_ascii_case("multipart/form-data") {
        from_form(request).await?
    } else {
        from_json(request).await?
    };
    let work = move || -> Result<TraceDraft, Failure> {
        Ok(trace(&map.yaml, &map.picture, &map.options)?.draft()?)
    };
    blocking(work).await.map(Json)
}

async fn from_json(request: Request) -> Result<Map, Failure> {
    let Body(asked) = Body::<TraceRequest>::from_request(request, &()).await?;
    let picture = BASE64_STANDARD.decode(asked.image_base64.trim()).map_err(|error| {
        Failure::not_acceptable("image_base64", format!("must be base 64 ({error})"))
    })?;
    let speck_m2 = asked.speck_m2.unwrap_or(0.0);
    let options = Options { speck_m2, crop_m: asked.crop, name: asked.name };
    Ok(Map { picture, yaml: asked.yaml, options })
}

async fn from_form(request: Request) -> Result<Map, Failure> {
    let kind = request.headers().get(header::CONTENT_TYPE).and_then(|kind| kind.to_str().ok());
    let boundary = multer::parse_boundary(kind.unwrap_or_default()).map_err(unreadable)?;
    let Raw(body) = Raw::from_request(request, &()).await?;
    let mut form = Multipart::new(RawBody::from(body).into_data_stream(), boundary);
    let (mut picture, mut yaml) = (None, None);
    let mut options = Options::default();
    while let Some(part) = form.next_field().await.map_err(unreadable)? {
        let name = part.name().unwrap_or_default().to_owned();
        match name.as_str() {
            "image" => picture = Some(part.bytes().await.map_err(unreadable)?.to_vec()),
            "yaml" => yaml = Some(part.text().await.map_err(unreadable)?),
            "speck_m2" => {
                options.speck_m2 = number(&name, &part.text().await.map_err(unreadable)?)?;
            }
            "crop" => options.crop_m = Some(rectangle(&part.text().await.map_err(unreadable)?)?),
            "name" => options.name = Some(part.text().await.map_err(unreadable)?),
            _ => {
                let known = "`image`, `yaml`, `speck_m2`, `crop` and `name`";
                let detail = format!("there is no part `{name}`; there are {known}");
                return Err(Failure::unreadable(detail).at(name));
            }
        }
    }
    let missing = |name: &str| {
        let detail = format!(
            "the part `{name}` is missing: send the PGM or PNG as `image` and the YAML as `yaml`"
        );
        Failure::unreadable(detail).at(name)
    };
    let picture = picture.ok_or_else(|| missing("image"))?;
    Ok(Map { picture, yaml: yaml.ok_or_else(|| missing("yaml"))?, options })
}

fn number(field: &str, text: &str) -> Result<f64, Failure> {
    let number = text.trim().parse();
    number.map_err(|_| Failure::unreadable(format!("must be a number, not {text:?}")).at(field))
}

/// `x0, y0, x1, y1`.
fn rectangle(text: &str) -> Result<[f64; 4], Failure> {
    let numbers = text.split(',').map(|text| number("crop", text));
    let numbers: Vec<f64> = numbers.collect::<Result<_, _>>()?;
    let rectangle = numbers.try_into();
    rectangle.map_err(|_| {
        Failure::unreadable(format!("must be x0, y0, x1, y1 in metres, not {text:?}")).at("crop")
    })
}

fn unreadable(error: multer::Error) -> Failure {
    Failure::unreadable(error.to_string())
}
