//! Diagrams with logarithmic axes, as SVG.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;

use super::figure::Mark;
use crate::report::Failure;

/// A diagram. Both axes are logarithmic.
pub(crate) struct Chart {
    /// Above it.
    pub(crate) title: String,
    /// Below the x axis, with the unit.
    pub(crate) x_label: String,
    /// Beside the y axis, with the unit.
    pub(crate) y_label: String,
    /// From the left to the right end, greater than 0.
    pub(crate) x: [f64; 2],
    /// From the lower to the upper end, greater than 0. What is less, 0 for example, is drawn at the lower end.
    pub(crate) y: [f64; 2],
    /// What the lower end of the y axis is called, if it stands for all that is less.
    pub(crate) y_floor: Option<&'static str>,
    /// What is drawn, the first below.
    pub(crate) series: Vec<Series>,
}

/// Points, perhaps joined.
pub(crate) struct Series {
    /// Red, green, blue.
    pub(crate) color: [u8; 3],
    /// How points are drawn.
    pub(crate) mark: Mark,
    /// How points are joined.
    pub(crate) line: Line,
    /// The points. Those with an infinite or undefined coordinate are left out.
    pub(crate) points: Vec<[f64; 2]>,
    /// A name beside the last point.
    pub(crate) label: Option<String>,
}

/// How points are joined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Line {
    /// Not at all.
    None,
    /// By a line.
    Full,
}

/// Stands for the colour of the page's text, which is not known here: it becomes `currentColor`.
const TEXT: RGBColor = RGBColor(1, 2, 3);
const TEXT_WRITTEN: &str = "#010203";

/// How large a diagram is drawn, in the page's pixels, and whether there is room for the axes' names.
struct Frame {
    size: (u32, u32),
    title: u32,
    text: u32,
    left: u32,
    below: u32,
    names: bool,
}

const LARGE: Frame = Frame { size: (480, 330), title: 16, text: 12, left: 62, below: 44, names: true };
const SMALL: Frame = Frame { size: (240, 180), title: 13, text: 11, left: 40, below: 22, names: false };

impl Chart {
    /// The SVG element, without an XML declaration. It takes its text's colour and font from the page.
    pub(crate) fn svg(&self) -> Result<String, Failure> {
        self.framed(&LARGE)
    }

    /// The same, small, for a [`super::figure::Part::Grid`]: the names of the axes are left out.
    pub(crate) fn small_svg(&self) -> Result<String, Failure> {
        self.framed(&SMALL)
    }

    fn framed(&self, frame: &Frame) -> Result<String, Failure> {
        let mut svg = String::new();
        self.draw(&mut svg, frame).map_err(|error| Failure::of("a diagram could not be drawn", error))?;
        let start = svg.find("<svg").unwrap_or(0);
        Ok(svg[start..].replace(TEXT_WRITTEN, "currentColor").replace("font-family=\"sans-serif\"", ""))
    }

    fn draw(&self, svg: &mut String, frame: &Frame) -> Result<(), Box<dyn std::error::Error + '_>> {
        let root = SVGBackend::with_string(svg, frame.size).into_drawing_area();
        let mut chart = ChartBuilder::on(&root)
            .margin(8)
            .margin_right(16)
            .caption(&self.title, ("sans-serif", frame.title).into_font().style(FontStyle::Bold).color(&TEXT))
            .x_label_area_size(frame.below)
            .y_label_area_size(frame.left)
            .build_cartesian_2d(Decades::new(self.x, None), Decades::new(self.y, self.y_floor))?;
        let mut mesh = chart.configure_mesh();
        if frame.names {
            mesh.x_desc(&self.x_label).y_desc(&self.y_label);
        }
        mesh.axis_desc_style(("sans-serif", 13).into_font().color(&TEXT))
            .label_style(("sans-serif", frame.text).into_font().color(&TEXT))
            .axis_style(TEXT.mix(0.6))
            .bold_line_style(TEXT.mix(0.16))
            .light_line_style(TEXT.mix(0.0))
            .draw()?;
        for series in &self.series {
            let color = RGBColor(series.color[0], series.color[1], series.color[2]);
            let points: Vec<(f64, f64)> = series.points.iter().filter_map(|&point| self.place(point)).collect();
            match series.line {
                Line::None => {}
                Line::Full => {
                    chart.draw_series(LineSeries::new(points.clone(), color.stroke_width(2)))?;
                }
            }
            match series.mark {
                Mark::Disc => {
                    chart.draw_series(points.iter().map(|&point| Circle::new(point, 4, color.filled())))?;
                }
                Mark::Ring => {
                    chart.draw_series(points.iter().map(|&point| Circle::new(point, 4, color.stroke_width(2))))?;
                }
                Mark::Square => {
                    let square = |&point: &(f64, f64)| {
                        EmptyElement::at(point) + Rectangle::new([(-4, -4), (4, 4)], color.filled())
                    };
                    chart.draw_series(points.iter().map(square))?;
                }
            }
            if let (Some(label), Some(&point)) = (&series.label, points.last()) {
                let style = ("sans-serif", 12).into_font().color(&TEXT);
                chart.draw_series([EmptyElement::at(point) + Text::new(label.clone(), (8, -6), style)])?;
            }
        }
        root.present()?;
        drop(chart);
        drop(root);
        Ok(())
    }

    /// A point's place in decades; what is below the floor is on it.
    fn place(&self, [x, y]: [f64; 2]) -> Option<(f64, f64)> {
        let place = (x.log10(), y.clamp(self.y[0], self.y[1]).log10());
        (place.0.is_finite() && place.1.is_finite()).then_some(place)
    }
}

/// An axis in decades, with a line and a number at each power of ten.
struct Decades {
    range: RangedCoordf64,
    ends: [f64; 2],
    floor: Option<&'static str>,
}

impl Decades {
    fn new(ends: [f64; 2], floor: Option<&'static str>) -> Self {
        let ends = ends.map(f64::log10);
        Self { range: (ends[0]..ends[1]).into(), ends, floor }
    }
}

impl Ranged for Decades {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        self.range.map(value, limit)
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        let [low, high] = self.ends;
        if high - low < 2.0 {
            let steps = (low.floor() as i32..=high.ceil() as i32)
                .flat_map(|power| [1.0, 2.0, 5.0].map(|digit: f64| f64::from(power) + digit.log10()));
            return steps.filter(|step| (low..=high).contains(step)).collect();
        }
        let count = (high.floor() - low.ceil()) as usize + 1;
        let step = count.div_ceil(hint.bold_points().clamp(2, 9)).max(1);
        let mut powers: Vec<f64> = (0..count).step_by(step).map(|i| low.ceil() + i as f64).collect();
        if self.floor.is_some() {
            powers.retain(|&power| power > low);
            powers.insert(0, low);
        }
        powers
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.range.range()
    }
}

impl ValueFormatter<f64> for Decades {
    fn format_ext(&self, value: &f64) -> String {
        match self.floor {
            Some(floor) if *value == self.ends[0] => floor.to_owned(),
            _ if *value == value.round() => power_of_ten(*value as i32),
            // 2 or 5 in some decade.
            _ => format!("{}", (10_f64.powf(*value) * 100.0).round() / 100.0),
        }
    }
}

/// 0.01, 0.1, 1, 10, 100; beyond them with an exponent.
fn power_of_ten(power: i32) -> String {
    if (-3..=3).contains(&power) {
        return 10_f64.powi(power).to_string();
    }
    let digits = power.to_string();
    let raised = digits.chars().map(|letter| match letter {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32(0x2070 + digit.to_digit(10).unwrap_or(0)).unwrap_or(digit),
    });
    format!("10{}", raised.collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_written_as_people_write_them() {
        assert_eq!([-6, -2, 0, 3, 12].map(power_of_ten), ["10⁻⁶", "0.01", "1", "1000", "10¹²"]);
    }

    #[test]
    fn a_chart_takes_its_colours_from_the_page_and_leaves_out_what_is_not_finite() {
        let chart = Chart {
            title: "a <b>".to_owned(),
            x_label: "x".to_owned(),
            y_label: "y".to_owned(),
            x: [1.0, 1e6],
            y: [1e-3, 1.0],
            y_floor: Some("0"),
            series: vec![Series {
                color: [9, 9, 9],
                mark: Mark::Disc,
                line: Line::Full,
                points: vec![[10.0, 0.0], [100.0, 0.5], [f64::INFINITY, 0.1], [10.0, f64::NAN]],
                label: None,
            }],
        };
        let svg = chart.svg().unwrap();
        assert!(svg.starts_with("<svg") && svg.contains("currentColor") && !svg.contains(TEXT_WRITTEN));
        assert_eq!(svg.matches("<circle").count(), 2, "{svg}");
        assert!(svg.contains("a &lt;b&gt;"));
    }
}
