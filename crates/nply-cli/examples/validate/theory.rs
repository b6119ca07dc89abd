//! What no command prints: calls of the library, by name and numbers.

use nply::Handedness;
use nply::geometry::{Contact, DensestHelix, HelicalAngle};
use nply::mechanics::{ExtensiblePly, FormedLay, Load, StretchingStrand, Support, Twist, WorkingCore};
use nply::topology::PlyWrithe;

pub(crate) fn call(line: &str) -> Result<f64, String> {
    let words: Vec<&str> = line.split(' ').collect();
    let number = |word: &str| word.parse::<f64>().map_err(|_| format!("`{line}`: {word} is no number"));
    match words[..] {
        ["densest_helix_shift"] => Ok(DensestHelix::new().arclength_shift()),
        ["densest_helix_pitch_over_radius"] => {
            let helix = DensestHelix::new();
            Ok(helix.pitch() / helix.radius_ratio())
        }
        ["writhe_of_a_strand", degrees, turns] => {
            let angle = HelicalAngle::new(number(degrees)?.to_radians()).map_err(said)?;
            let ply = PlyWrithe::new(1, angle, Handedness::Right, number(turns)?).map_err(said)?;
            Ok(ply.itself().writhe)
        }
        ["formed_layer_stiffness", degrees, load, displacement] => {
            let matrix = formed_layer_stiffness(number(degrees)?)?;
            let row = place(load, ["force", "moment"])?;
            Ok(matrix[row][place(displacement, ["strain", "turning"])?])
        }
        _ => Err(format!("`{line}` is not known here")),
    }
}

/// Six solid round wires (EA r²/B = 4, C/B = 1/1.3) that keep their thickness, formed in their lay on a rigid core, 2 % clear of each other: force and
/// moment by strain and turning, over the EA of six straight wires, lengths in wire radii.
fn formed_layer_stiffness(degrees: f64) -> Result<[[f64; 2]; 2], String> {
    let (wires, alpha, gamma) = (6, 4.0, 1.0 / 1.3);
    let angle = HelicalAngle::new(degrees.to_radians()).map_err(said)?;
    let radius_ratio = 1.02 * Contact::at_angle(wires, angle).map_err(said)?.radius_ratio();
    let lay = FormedLay { handedness: Handedness::Right, angle, radius_ratio, preforming: 1.0 };
    let strand = StretchingStrand::new(gamma, alpha, 0.0).map_err(said)?;
    let core = WorkingCore::rigid(radius_ratio - 1.0).map_err(said)?;
    let ply = ExtensiblePly::new(wires, strand).and_then(|ply| ply.with_core(core)).and_then(|ply| ply.formed_in(lay));
    // a pull so small that nothing moves, and contact is sure
    let load = Load { force: 1e-7, moment: 0.0 };
    let states = ply.map_err(said)?.states(Twist::Pretwist(0.0), load).map_err(said)?;
    let on_core = states.iter().find(|state| state.support() == Support::Core).ok_or("no state on the core")?;
    let stiffness = on_core.stiffness().ok_or("no stiffness on the core")?;
    let over = |value: f64| value / (f64::from(wires) * alpha);
    Ok([[over(stiffness.axial), over(stiffness.coupling)], [over(stiffness.coupling), over(stiffness.torsional)]])
}

fn place(word: &str, of: [&str; 2]) -> Result<usize, String> {
    of.iter().position(|name| *name == word).ok_or_else(|| format!("{word} is neither {} nor {}", of[0], of[1]))
}

fn said(error: impl core::fmt::Display) -> String {
    error.to_string()
}
