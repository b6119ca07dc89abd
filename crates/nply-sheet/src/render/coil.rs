//! The wires of a strand that is wound itself, asked together how far away they are.

use core::f64::consts::TAU;

use nply::geometry::{Centreline, Course, DoubleHelix, Tube, Vector};

/// Wires alike round one helix, which differ in their phase alone.
#[derive(Clone, Debug)]
pub(super) struct Coil {
    axis: Centreline,
    first: DoubleHelix,
    /// The wires' radius.
    radius: f64,
    /// Number and body of each.
    wires: Vec<(usize, Tube)>,
    phases: Vec<f64>,
}

/// The foot of a perpendicular on one of the wires.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foot {
    pub(super) wire: usize,
    /// Parameter on its course.
    pub(super) t: f64,
    /// From its centreline.
    pub(super) distance: f64,
}

impl Coil {
    /// Puts a wire to those of its kind; a wire that winds once only is handed back.
    pub(super) fn gather(coils: &mut Vec<Self>, number: usize, tube: &Tube) -> bool {
        let Course::DoubleHelix(wire) = *tube.course() else { return false };
        let kin = |coil: &&mut Self| {
            let same = |a: f64, b: f64| a.to_bits() == b.to_bits();
            coil.axis == *wire.axis()
                && same(coil.radius, tube.radius())
                && same(coil.first.radius(), wire.radius())
                && same(coil.first.rate(), wire.rate())
        };
        let phase = wire.phase();
        if let Some(coil) = coils.iter_mut().find(kin) {
            coil.wires.push((number, *tube));
            coil.phases.push(phase);
        } else {
            let (wires, phases) = (vec![(number, *tube)], vec![phase]);
            coils.push(Self { axis: *wire.axis(), first: wire, radius: tube.radius(), wires, phases });
        }
        true
    }

    pub(super) fn radius(&self) -> f64 {
        self.radius
    }

    /// No wire is nearer to the point than this; negative within the tube that encloses them. The second is where the point stands beside the
    /// strand.
    pub(super) fn bound(&self, point: Vector) -> (f64, f64) {
        let (level, distance) = self.axis.nearest(point);
        (distance - self.first.radius() - self.radius, level)
    }

    /// The nearest of the wires to a point that stands beside the strand at a level: one of the two between which it is.
    pub(super) fn nearest(&self, point: Vector, level: f64) -> Option<Foot> {
        let (frame, from) = (self.axis.frame(level), self.axis.position(level));
        let off = |way: Vector| (0..3).map(|i| (point[i] - from[i]) * way[i]).sum::<f64>();
        let azimuth = libm::atan2(off(frame.binormal), off(frame.normal)) - self.first.rate() * level;
        // how far round from the point the next wire stands, on either side
        let (mut ahead, mut behind) = ((f64::INFINITY, 0), (f64::INFINITY, 0));
        for (place, phase) in self.phases.iter().enumerate() {
            let turns = (phase - azimuth) / TAU;
            let share = turns - libm::floor(turns);
            if share < ahead.0 {
                ahead = (share, place);
            }
            if 1.0 - share < behind.0 {
                behind = (1.0 - share, place);
            }
        }
        let foot = |place: usize| {
            let (wire, tube) = self.wires.get(place)?;
            let (t, distance) = tube.course().nearest_from(point, level);
            Some(Foot { wire: *wire, t, distance })
        };
        let (one, other) = (foot(ahead.1)?, foot(behind.1)?);
        Some(if other.distance < one.distance { other } else { one })
    }

    /// A wire's course.
    pub(super) fn course(&self, wire: usize) -> Option<&Course> {
        self.wires.iter().find(|(number, _)| *number == wire).map(|(_, tube)| tube.course())
    }
}
