//! Inputs that nobody means and somebody has.

use super::{Area, Axis, Chart, Curve, Field, Marker, MarkerShape, Note, Picture, Side, Theme};

/// What an XML reader would take as text and elements; stops at what is not well formed.
fn is_well_formed(svg: &str) -> bool {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = svg;
    while let Some(begin) = rest.find('<') {
        let text = &rest[..begin];
        let is_text = !text.contains('>') && !text.split('&').skip(1).any(|t| !t.contains(';'));
        let Some(end) = rest.find('>') else { return false };
        let tag = &rest[begin + 1..end];
        rest = &rest[end + 1..];
        match tag.strip_prefix('/') {
            _ if !is_text => return false,
            Some(name) if open.pop() != Some(name) => return false,
            None if !tag.ends_with('/') && !tag.starts_with('!') => open.extend(tag.split(' ').next()),
            _ => {}
        }
    }
    open.is_empty() && rest.is_empty() && !svg.chars().any(|c| c.is_control() && c != '\n')
}

#[test]
fn names_are_text_and_nothing_else() {
    let name = "</text><script>\"&'\0\u{8} $x$ ]]> 50 $";
    let axis = || Axis::new(name, name);
    let chart = Chart::new(name, axis(), axis())
        .with_curve(Curve::new(name, [(0.0, 1.0), (1e30, 2.0)]))
        .with_marker(Marker::new(name, 0.0, 1.0, MarkerShape::Plus));
    let field = Field::of_values(name, axis(), axis(), 1, &[1.0, 2.0], axis());
    let svg = Picture::row([super::Panel::from(chart), super::Panel::from(field)]).svg();
    assert!(is_well_formed(&svg), "{svg}");
    assert!(!svg.contains("<script") && svg.contains("$x$ ]]&gt; 50 $"));
    let long = Chart::new("word ".repeat(1000), Axis::new("y".repeat(9999), ""), axis()).svg();
    assert!(is_well_formed(&long) && long.len() < 5000, "{}", long.len());
}

#[test]
fn no_numbers_break_a_picture() {
    let (tiny, huge, infinite, nan) = (1e-30, 1e30, f64::INFINITY, f64::NAN);
    let curves: [&[(f64, f64)]; 12] = [
        &[],
        &[(1.0, 2.0)],
        &[(nan, 1.0), (infinite, 2.0)],
        &[(1.0, 5.0), (2.0, 5.0), (3.0, 5.0)],
        &[(tiny, -huge), (huge, tiny)],
        &[(0.0, 0.0), (nan, 0.0), (0.0, 0.0)],
        &[(f64::MIN, f64::MIN), (f64::MAX, f64::MAX)],
        &[(5e-324, -5e-324), (0.0, 5e-324)],
        &[(1.0, 1.0), (1.0 + f64::EPSILON, 1.0)],
        &[(1e9, 1e-9), (1e9 + 1.0, 2e-9)],
        &[(1.0, nan), (2.0, 1.0), (3.0, nan)],
        &[(-infinite, 0.0), (0.0, 0.0), (infinite, infinite)],
    ];
    let ranges =
        [None, Some((0.0, 0.0)), Some((nan, 1.0)), Some((huge, -tiny)), Some((f64::MIN, f64::MAX)), Some((0.0, tiny))];
    let axis = |range: Option<(f64, f64)>| Axis { range, ..Axis::new("q", "N") };
    let mut pictures = Vec::new();
    for range in ranges {
        for curve in curves {
            let chart = Chart::new("", axis(range), axis(range)).with_curve(Curve::new("c", curve.iter().copied()));
            let markers = curve.iter().map(|&(x, y)| Marker::new("m", x, y, MarkerShape::Circle));
            let chart = markers.fold(chart, Chart::with_marker);
            let notes = curve.iter().map(|&(x, y)| Note::new("n", x, y, Side::Above));
            let chart = notes.fold(chart, Chart::with_note).with_area(Area::new("a", curve.iter().copied(), 9));
            pictures.push(chart.svg());
            let (mut logarithmic, mut stepped) = (chart.clone(), chart);
            for axis in [&mut logarithmic.x, &mut logarithmic.y] {
                axis.logarithmic = true;
            }
            for axis in [&mut stepped.x, &mut stepped.y] {
                axis.step = Some(tiny);
            }
            assert!(!logarithmic.text(30, 10).contains("NaN") && !stepped.text(30, 10).contains("NaN"));
            pictures.push(logarithmic.svg_in(Theme::Dark));
            pictures.push(stepped.with_size(nan, -1.0).svg());
            let values: Vec<f64> = curve.iter().flat_map(|&(x, y)| [x, y]).collect();
            for columns in [0, 1, 2, 7, usize::MAX] {
                let (x, y) = (axis(range), axis(range));
                pictures.push(Field::of_values("", x.clone(), y.clone(), columns, &values, axis(range)).svg());
                pictures.push(Field::of_signed_values("", x.clone(), y.clone(), columns, &values, axis(range)).svg());
                pictures.push(Field::of_categories("", x, y, columns, &[0, 9, 255], Vec::<String>::new()).svg());
            }
        }
    }
    pictures.push(Picture::row(Vec::<Chart>::new()).svg());
    for svg in pictures {
        assert!(is_well_formed(&svg) && !svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
