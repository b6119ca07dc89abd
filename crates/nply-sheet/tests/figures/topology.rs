//! Figures 12 to 15 and the tables: link, twist, writhe.

use super::{close, data, pairs};

/// Figure 12: what is let go keeps its link, twist of the closure included, and comes to rest as simulated.
#[test]
fn link_is_kept() {
    let data = data("12");
    let of = |name: &str| pairs(&data, &[name], "straight", "let_go")[0];
    let (before, after) = of("link");
    close(before, after, 1e-12);
    for place in [|p: (f64, f64)| p.0, |p: (f64, f64)| p.1] {
        close(place(of("twist")) + place(of("writhe")) + place(of("twist_of_closure")), before, 1e-12);
    }
    close(of("helical_angle_deg").1, 30.6130, 5e-5);
    // (A.26): W_r = (ψ_L/2π)(1 − 3 cos θ)
    let turns = -of("twist_of_closure").1;
    close(of("writhe").1, turns * (1.0 - 3.0 * of("helical_angle_deg").1.to_radians().cos()), 1e-10);
}

/// Figure 13: the change of variables keeps the area, and puts the diagonal on x = 0.
#[test]
fn the_square_keeps_its_area() {
    let data = data("13");
    let area = |corners: &[(f64, f64)]| {
        let cross = |i: usize| {
            let (a, b) = (corners[i], corners[(i + 1) % corners.len()]);
            a.0 * b.1 - b.0 * a.1
        };
        0.5 * (0..corners.len()).map(cross).sum::<f64>().abs()
    };
    let before = pairs(&data, &[], "psi_s", "psi_t");
    let after = pairs(&data, &[], "x", "y");
    close(area(&before), 1.0, 1e-15);
    close(area(&after), 1.0, 1e-15);
    for ((s, t), (x, y)) in before.into_iter().zip(after) {
        close(x, 0.5 * (s - t), 1e-15);
        close(y, s + t, 1e-15);
    }
}

/// Figures 14 and 15: one closed line; half the helices, rounded up, run forward.
#[test]
fn the_pieces_close() {
    for (name, strands, closures) in [("14", 2, 0), ("15", 3, 1)] {
        let data = data(name);
        let count = |kind: &str| data.rows.iter().filter(|row| row[1] == kind.into()).count();
        assert_eq!((count("helix"), count("closure")), (strands, closures));
        assert_eq!(count("end section"), strands + closures);
        let forward = data.rows.iter().filter(|row| row[1] == "helix".into() && row[2] == "forward".into()).count();
        assert_eq!(forward, strands.div_ceil(2));
    }
}

/// Tables I and II: all entries together are (A.27), (ψ_L/2π)(σ − n cos θ).
#[test]
fn the_tables_add_up() {
    for (name, n, sigma) in [("table1", 2.0, 0.0), ("table2", 3.0, 1.0)] {
        let data = data(name);
        let sum = |column: &str| data.numbers(&[], column).sum::<f64>();
        close(sum("constant"), sigma, 1e-15);
        close(sum("cosine"), -n, 1e-15);
        let cells: Vec<_> =
            data.rows.iter().map(|row| (row[0].clone(), row[1].clone(), row[2].clone(), row[3].clone())).collect();
        for (i, j, constant, cosine) in &cells {
            let mirror = cells.iter().find(|cell| cell.0 == *j && cell.1 == *i).unwrap();
            assert_eq!((&mirror.2, &mirror.3), (constant, cosine), "symmetric");
        }
    }
}

/// Beside the tables: ten turns at 30° have ten times the entries' writhe a turn, and what the ends add stays small.
#[test]
fn a_finite_ply_is_near_its_table() {
    for name in ["table1", "table2"] {
        let data = data(name);
        let column = |name: &str| data.numbers(&[], name).collect::<Vec<f64>>();
        let (constant, cosine) = (column("constant"), column("cosine"));
        let (writhe, ends) = (column("writhe_of_ten_turns_at_30_deg"), column("of_it_from_ends"));
        for i in 0..constant.len() {
            let leading = 10.0 * (constant[i] + cosine[i] * 30_f64.to_radians().cos());
            close(writhe[i] - ends[i], leading, 1e-9);
            assert!(ends[i].abs() < 0.5 && ends[i] != 0.0, "{}", ends[i]);
        }
    }
}
