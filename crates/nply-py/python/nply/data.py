"""What can be said of a ply by keyword arguments, for editors and type checkers. The names are those of the command's flags."""

from __future__ import annotations

from typing import Any, Literal, TypedDict

Quantity = Any
"""A number, a text with a unit (``"0.5 mm"``), or a quantity of pint."""


class Data(TypedDict, total=False):
    """Single data of a ply."""

    title: str
    strands: int
    balance: Literal["contact", "radial"]
    hand: Literal["right", "left", "Z", "S"]
    radius: Quantity
    diameter: Quantity
    linear_density: Quantity
    density: Quantity
    packing_fraction: float | str
    bending_stiffness: Quantity
    torsional_stiffness: Quantity
    stiffness_ratio: float | str
    youngs_modulus: Quantity
    poissons_ratio: float | str
    shear_modulus: Quantity
    bending_persistence_length: Quantity
    twist_persistence_length: Quantity
    temperature: Quantity
    strand_length: Quantity
    stretch: bool
    axial_stiffness: Quantity
    thinning_ratio: float | str
    pretwist: float | str
    surface_angle: Quantity
    turns_per_length: Quantity
    turns: Quantity
    end_rotation: Quantity
    strand_twist: Quantity
    helical_angle: Quantity
    lay_angle: Quantity
    pitch_angle: Quantity
    lay_length: Quantity
    lay_ratio: float | str
    ply_turns_per_length: Quantity
    radius_ratio: float | str
    helix_radius: Quantity
    core_radius: Quantity
    core_diameter: Quantity
    formed_helical_angle: Quantity
    formed_lay_length: Quantity
    formed_radius_ratio: float | str
    formed_hand: Literal["right", "left", "Z", "S"]
    preforming: float | str
    force: Quantity
    moment: Quantity
    external_pressure: Quantity
    separation: bool
    ply_rotation: Quantity
    ply_turns: Quantity
    ply_turns_per_strand_length: Quantity
    ply_length: Quantity
    length_ratio: float | str
    support_core_radius: Quantity
    support_core_diameter: Quantity
    support_core_youngs_modulus: Quantity
    support_core_poissons_ratio: float | str
    support_core_axial_stiffness: Quantity
    support_core_torsional_stiffness: Quantity


class ConstructionData(TypedDict, total=False):
    """Single data of a strand of layers; those of a layer may be lists, one value for each."""

    title: str
    outer_diameter: Quantity
    core_diameter: Quantity
    core_diameter_ratio: float | str | list[float | str]
    core_density: Quantity
    core_material: str
    core_youngs_modulus: Quantity
    core_poissons_ratio: float | str | list[float | str]
    core_tensile_strength: Quantity
    core_fibre: bool
    strands: int | list[int]
    wire_diameter: Quantity
    lay_length: Quantity
    lay_ratio: float | str | list[float | str]
    lay_angle: Quantity
    hand: Literal["right", "left", "Z", "S"] | list[Literal["right", "left", "Z", "S"]]
    gap: Quantity
    wire_density: Quantity
    wire_material: str
    wire_youngs_modulus: Quantity
    wire_poissons_ratio: float | str | list[float | str]
    wire_tensile_strength: Quantity
    preforming: float | str | list[float | str]
    wire_pretwist: Quantity
    force: Quantity
    moment: Quantity
    turns_per_length: Quantity
    torque_factor: float | str | list[float | str]
    balanced_layer: int | list[int]
