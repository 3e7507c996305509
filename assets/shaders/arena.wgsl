// Draws every primitive of an arena picture as an instance of a rectangle whose fragments know how
// much of their pixel the shape covers. Coordinates are pixels, the origin the top left corner.
// Colours arrive premultiplied. The CPU back end computes areas exactly; the formulas here follow
// it closely enough that a picture test holds one against the other.

struct Sheet {
    size: vec2<f32>,
    padding: vec2<f32>,
}

@group(0) @binding(0) var<uniform> sheet: Sheet;
// Edges of polygons and glyphs: from (x, y) to (z, w).
@group(0) @binding(1) var<storage, read> edges: array<vec4<f32>>;

const SEGMENT: u32 = 0u;
const SECTOR: u32 = 1u;
const POLYGON: u32 = 2u;

struct Shape {
    // Segment: its two ends. Sector: centre, inner and outer radius. Polygon: left, top, right, bottom.
    @location(0) place: vec4<f32>,
    // Segment: normals of the planes at both ends, zero at a round cap. Sector: directions of both sides.
    @location(1) sides: vec4<f32>,
    @location(2) colour: vec4<f32>,
    // Segment: half width. Sector: sweep in radians.
    @location(3) size: f32,
    // Kind; polygon: first edge and number of edges.
    @location(4) kind: vec3<u32>,
}

struct Fragment {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) place: vec4<f32>,
    @location(1) @interpolate(flat) sides: vec4<f32>,
    @location(2) @interpolate(flat) colour: vec4<f32>,
    @location(3) @interpolate(flat) size: f32,
    @location(4) @interpolate(flat) kind: vec3<u32>,
}

// The corner of a rectangle along a segment, wide enough for its soft rim.
fn segment_corner(shape: Shape, corner: vec2<f32>) -> vec2<f32> {
    let from_end = shape.place.xy;
    let along = shape.place.zw - from_end;
    let length = length(along);
    let direction = select(vec2<f32>(1.0, 0.0), along / max(length, 1e-6), length > 1e-6);
    let normal = vec2<f32>(-direction.y, direction.x);
    let reach = shape.size + 1.0;
    return from_end + direction * mix(-reach, length + reach, corner.x) + normal * mix(-reach, reach, corner.y);
}

// The corner of a rectangle around a sector; a narrow one gets a narrow rectangle along its middle,
// because sonar cones are long and many.
fn sector_corner(shape: Shape, corner: vec2<f32>) -> vec2<f32> {
    let half = 0.5 * shape.size;
    let outer = shape.place.w;
    if half > 1.57 {
        return shape.place.xy + (corner * 2.0 - 1.0) * (outer + 1.0);
    }
    let turn = vec2<f32>(cos(half), sin(half));
    let start = shape.sides.xy;
    let axis = vec2<f32>(start.x * turn.x - start.y * turn.y, start.x * turn.y + start.y * turn.x);
    let across = vec2<f32>(-axis.y, axis.x) * (outer * turn.y + 1.0);
    let along = mix(shape.place.z * turn.x - 1.0, outer + 1.0, corner.x);
    return shape.place.xy + axis * along + across * (corner.y * 2.0 - 1.0);
}

@vertex
fn vertex(@builtin(vertex_index) index: u32, shape: Shape) -> Fragment {
    let corner = vec2<f32>(f32(index & 1u), f32(index >> 1u));
    var at = mix(shape.place.xy - 1.0, shape.place.zw + 1.0, corner);
    if shape.kind.x == SEGMENT {
        at = segment_corner(shape, corner);
    } else if shape.kind.x == SECTOR {
        at = sector_corner(shape, corner);
    }
    let clip = at / sheet.size * vec2<f32>(2.0, -2.0) + vec2<f32>(-1.0, 1.0);
    return Fragment(
        vec4<f32>(clip, 0.0, 1.0), shape.place, shape.sides, shape.colour, shape.size, shape.kind,
    );
}

// How much of a pixel lies inside an edge at this signed distance (negative inside).
fn covered(distance: f32) -> f32 {
    return clamp(0.5 - distance, 0.0, 1.0);
}

fn segment_coverage(shape: Fragment, at: vec2<f32>) -> f32 {
    let from_end = shape.place.xy;
    let to_end = shape.place.zw;
    // Neighbours share a joint and the plane through it: a pixel belongs to exactly one of them, so
    // translucent lines do not double up.
    let before = any(shape.sides.xy != vec2<f32>(0.0)) && dot(at - from_end, shape.sides.xy) < 0.0;
    let behind = any(shape.sides.zw != vec2<f32>(0.0)) && dot(at - to_end, shape.sides.zw) >= 0.0;
    if before || behind {
        return 0.0;
    }
    let along = to_end - from_end;
    let share = clamp(dot(at - from_end, along) / max(dot(along, along), 1e-9), 0.0, 1.0);
    let apart = length(at - from_end - along * share);
    // A line thinner than a pixel covers no more than its width.
    return clamp(shape.size + 0.5 - apart, 0.0, min(1.0, 2.0 * shape.size));
}

fn sector_coverage(shape: Fragment, at: vec2<f32>) -> f32 {
    let offset = at - shape.place.xy;
    let apart = length(offset);
    var coverage = covered(apart - shape.place.w);
    if shape.place.z > 0.0 {
        coverage = max(coverage - covered(apart - shape.place.z), 0.0);
    }
    if shape.size >= 6.28308 {
        return coverage;
    }
    let start = shape.sides.xy;
    let end = shape.sides.zw;
    let after_start = covered(-(start.x * offset.y - start.y * offset.x));
    let before_end = covered(end.x * offset.y - end.y * offset.x);
    let reflex = shape.size > 3.14159265;
    return coverage * select(after_start * before_end, max(after_start, before_end), reflex);
}

// The integral of clamp(1 - x, 0, 1) up to x: area to the right of an edge within a pixel.
fn area_to(x: f32) -> f32 {
    let inside = clamp(x, 0.0, 1.0);
    return min(x, 0.0) + inside - 0.5 * inside * inside;
}

// The signed area that lies to the right of an edge within the pixel from (0, 0) to (1, 1).
fn edge_area(from_end: vec2<f32>, to_end: vec2<f32>) -> f32 {
    let y0 = clamp(from_end.y, 0.0, 1.0);
    let y1 = clamp(to_end.y, 0.0, 1.0);
    if y0 == y1 {
        return 0.0;
    }
    let slope = (to_end.x - from_end.x) / (to_end.y - from_end.y);
    let x0 = from_end.x + (y0 - from_end.y) * slope;
    let x1 = from_end.x + (y1 - from_end.y) * slope;
    if min(x0, x1) >= 1.0 {
        return 0.0;
    }
    if max(x0, x1) <= 0.0 {
        return y1 - y0;
    }
    if abs(x1 - x0) < 1e-3 {
        return (y1 - y0) * clamp(1.0 - 0.5 * (x0 + x1), 0.0, 1.0);
    }
    return (y1 - y0) * (area_to(x1) - area_to(x0)) / (x1 - x0);
}

fn polygon_coverage(shape: Fragment, at: vec2<f32>) -> f32 {
    let corner = at - 0.5;
    var area = 0.0;
    for (var i = 0u; i < shape.kind.z; i++) {
        let edge = edges[shape.kind.y + i];
        area += edge_area(edge.xy - corner, edge.zw - corner);
    }
    return min(abs(area), 1.0);
}

@fragment
fn fragment(shape: Fragment) -> @location(0) vec4<f32> {
    let at = shape.position.xy;
    var coverage = 0.0;
    if shape.kind.x == SEGMENT {
        coverage = segment_coverage(shape, at);
    } else if shape.kind.x == SECTOR {
        coverage = sector_coverage(shape, at);
    } else {
        coverage = polygon_coverage(shape, at);
    }
    return shape.colour * coverage;
}
