//! Figures 9 to 11: plies under force and moment.

use nply::Handedness;
use nply::geometry::Contact;
use nply_sheet::figure::{Cell, Data};

use super::{close, data, pairs};

const GAMMA: f64 = 0.75;

struct Row {
    balance: String,
    pretwist: f64,
    curve: String,
    eps: f64,
    degrees: f64,
    force: f64,
    moment: f64,
}

fn rows(data: &Data) -> Vec<Row> {
    let word = |cell: &Cell| match cell {
        Cell::Word(word) => word.clone(),
        Cell::Number(number) => panic!("{number}"),
    };
    let number = |cell: &Cell| match cell {
        Cell::Number(number) => *number,
        Cell::Word(word) => panic!("{word}"),
    };
    let row = |cells: &Vec<Cell>| Row {
        balance: word(&cells[0]),
        pretwist: number(&cells[1]),
        curve: word(&cells[2]),
        eps: if word(&cells[3]) == "right" { 1.0 } else { -1.0 },
        degrees: number(&cells[4]),
        force: number(&cells[5]),
        moment: number(&cells[6]),
    };
    data.rows.iter().map(row).collect()
}

/// On the locus (37) and (48) vanish; it begins at m = nγφ̄a and ends where rings carry nothing.
#[test]
fn the_locus_is_where_neighbours_stop_pressing() {
    for (figure, strands) in [("9", 2), ("10", 3)] {
        let n = f64::from(strands);
        for row in rows(&data(figure)) {
            if row.curve == "θ = 0°" {
                close(row.force, 0.0, 1e-12);
                close(row.moment, n * GAMMA * row.pretwist, 1e-12);
            } else if row.curve == "θ = 90°" {
                close(row.force.hypot(row.moment), 0.0, 1e-9);
            } else if row.curve == "locus" && row.degrees < 89.0 {
                let contact = Contact::new(strands, row.degrees.to_radians()).unwrap();
                let (rho, s, c) = (contact.radius_ratio(), contact.angle().sin(), contact.angle().cos());
                let u3 = row.pretwist + row.eps * s * c / rho;
                let thirty_seven = -s.powi(4) - row.eps * GAMMA * u3 * rho * s * c + row.eps * row.moment / n * rho * s;
                close(thirty_seven, 0.0, 1e-12 * rho * rho * rho);
                let forty_eight = n * (1.0 - GAMMA) * s * s * c - row.eps * n * GAMMA * row.pretwist * rho * s
                    + rho * rho * row.force;
                close(forty_eight, 0.0, 1e-11 * rho * rho * rho);
            }
        }
    }
}

/// Lines of constant angle have slope ερ tan θ in radial balance, divided by 1 − q in contact balance.
#[test]
fn lines_have_their_slopes() {
    for (figure, strands) in [("9", 2), ("10", 3)] {
        let rows = rows(&data(figure));
        let lines: Vec<&Row> = rows.iter().filter(|row| row.curve.starts_with("angle")).collect();
        assert_eq!(lines.len(), 2 * 2 * 2 * 5 * 4); // balances, pretwists, hands, angles, both sides with two points
        for pair in lines.chunks(2) {
            let (a, b) = (pair[0], pair[1]);
            let contact = Contact::new(strands, a.degrees.to_radians()).unwrap();
            let radial = a.eps * contact.radius_ratio() * contact.angle().tan();
            let wanted = if a.balance == "radial" { radial } else { radial / (1.0 - contact.shift_ratio_squared()) };
            close((b.moment - a.moment) / (b.force - a.force) / wanted, 1.0, 1e-9);
            // towards more moment of the ply's own hand neighbours press
            assert_eq!(b.curve.ends_with("p < 0"), a.eps * (b.moment - a.moment) < 0.0);
        }
    }
}

/// Figure 11: R = 2.1 r is 20.0°; the wedge between the two balances' lines begins where p vanishes.
#[test]
fn six_strands_on_a_core() {
    let contact = Contact::from_radius_ratio(6, 2.1).unwrap();
    close(contact.angle().degrees(), 20.0, 0.05);
    let data = data("11");
    let slope = |panel: &str, balance: &str, hand: &str| {
        let line = pairs(&data, &[panel, balance, hand], "force", "value");
        ((line[2].1 - line[0].1) / (line[2].0 - line[0].0), line[1])
    };
    for hand in Handedness::BOTH {
        let name = if hand == Handedness::Right { "right" } else { "left" };
        let radial = hand.sign() * 2.1 * contact.angle().tan();
        close(slope("moment", "radial", name).0, radial, 1e-12);
        close(slope("moment", "contact", name).0, radial / (1.0 - contact.shift_ratio_squared()), 1e-12);
        let tip = pairs(&data, &["moment", "tip of the wedge", name], "force", "value")[0];
        for balance in ["radial", "contact"] {
            let (rise, (from, at)) = slope("moment", balance, name);
            close(at + rise * (tip.0 - from), tip.1, 1e-12);
            let (rise, (from, at)) = slope("resultant_pressure", balance, name);
            close(at + rise * (tip.0 - from), 0.0, 1e-12);
        }
        // (48): p rises with f as sin θ tan θ/(nρ), whatever the hand
        let (s, t) = (contact.angle().sin(), contact.angle().tan());
        close(slope("resultant_pressure", "radial", name).0, s * t / (6.0 * 2.1), 1e-12);
    }
}
