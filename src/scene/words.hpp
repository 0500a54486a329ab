#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "scene/scene.hpp"

/// The words of the scene file that stand for enumerators.
namespace stokesbook::scene_text {

/// A word of the scene file and its meaning.
template <class T>
struct Word {
  std::string_view name;  ///< the word as it is written
  T meaning;              ///< the value that the word stands for
};

/// All words that a key accepts.
template <class T, std::size_t N>
using Words = std::array<Word<T>, N>;

/// Returns the word for a meaning, which must be one of the meanings of the words.
template <class T, std::size_t N>
std::string_view name_of(T meaning, const Words<T, N>& words) {
  return std::ranges::find(words, meaning, &Word<T>::meaning)->name;
}

/// Words of `kind` in [flow]: default values of all types of flow, in the order of the variant.
inline const Words<BackgroundFlow, 7> flow_kinds{{{"quiescent", QuiescentFlow{}},
                                                  {"uniform", UniformFlow{}},
                                                  {"shear", ShearFlow{}},
                                                  {"extensional", ExtensionalFlow{}},
                                                  {"taylor_green", TaylorGreenFlow{}},
                                                  {"linear", LinearFlow{}},
                                                  {"sum", SumFlow{}}}};

/// Words of `kind` in `amplitude`, in the order of the variant.
inline const Words<Amplitude, 4> amplitude_kinds{{{"constant", ConstantAmplitude{}},
                                                  {"steps", SteppedAmplitude{}},
                                                  {"ramp", RampedAmplitude{}},
                                                  {"oscillation", OscillatingAmplitude{}}}};

/// Words of `kind` in `motion` of [[walls]], in the order of the variant.
inline const Words<WallMotion, 7> motion_kinds{{{"fixed", FixedWall{}},
                                                {"rotating", RotatingWall{}},
                                                {"translating", TranslatingWall{}},
                                                {"linear", LinearWall{}},
                                                {"radial", RadialWall{}},
                                                {"parabolic", ParabolicWall{}},
                                                {"data", VelocityData{}}}};

/// Words of `kind` in `slip` of [[bodies]], in the order of the variant.
inline const Words<Slip, 2> slip_kinds{{{"squirmer", Squirmer{}}, {"data", VelocityData{}}}};

/// Words of `kind` in `shape`, in the order of the variant.
inline const Words<Shape, 5> shape_kinds{{{"circle", Circle{}},
                                          {"ellipse", Ellipse{}},
                                          {"star", Star{}},
                                          {"superellipse", Superellipse{}},
                                          {"nodes", NodalCurve{}}}};

/// The word for automatic_nodes in `n_nodes`.
inline constexpr std::string_view automatic_word = "auto";

/// Words of `role` in [[walls]].
inline constexpr Words<WallRole, 2> wall_roles{
    {{"outer", WallRole::outer}, {"inner", WallRole::inner}}};

/// Words of `summation` in [solver].
inline constexpr Words<Summation, 3> summations{
    {{"auto", Summation::automatic}, {"direct", Summation::direct}, {"fmm", Summation::fmm}}};

/// Words of `near_singular` in [solver].
inline constexpr Words<NearSingular, 4> near_singular_schemes{
    {{"auto", NearSingular::automatic},
     {"cauchy", NearSingular::cauchy},
     {"interpolation", NearSingular::interpolation},
     {"off", NearSingular::off}}};

/// Words of `preconditioner` in [solver].
inline constexpr Words<PreconditionerKind, 6> preconditioners{
    {{"auto", PreconditionerKind::automatic},
     {"none", PreconditionerKind::none},
     {"block_diagonal", PreconditionerKind::block_diagonal},
     {"clusters", PreconditionerKind::clusters},
     {"hierarchical", PreconditionerKind::hierarchical},
     {"direct", PreconditionerKind::direct}}};

/// Words of `coupling` in [solver].
inline constexpr Words<Coupling, 2> couplings{
    {{"global", Coupling::global}, {"local", Coupling::local}}};

/// Words of `method` in [time].
inline constexpr Words<SteppingMethod, 7> stepping_methods{
    {{"euler", SteppingMethod::euler},
     {"adams_bashforth2", SteppingMethod::adams_bashforth2},
     {"heun", SteppingMethod::heun},
     {"rk4", SteppingMethod::rk4},
     {"bogacki_shampine32", SteppingMethod::bogacki_shampine32},
     {"dormand_prince54", SteppingMethod::dormand_prince54},
     {"prince_dormand87", SteppingMethod::prince_dormand87}}};

/// Words of `formats` in [output].
inline constexpr Words<OutputFormat, 4> output_formats{{{"csv", OutputFormat::csv},
                                                        {"vtk", OutputFormat::vtk},
                                                        {"svg", OutputFormat::svg},
                                                        {"html", OutputFormat::html}}};

/// Words of `quantities` in `fields` of [output].
inline constexpr Words<FieldQuantity, 5> field_quantities{
    {{"velocity", FieldQuantity::velocity},
     {"pressure", FieldQuantity::pressure},
     {"vorticity", FieldQuantity::vorticity},
     {"shear_stress", FieldQuantity::shear_stress},
     {"dissipation", FieldQuantity::dissipation}}};

}  // namespace stokesbook::scene_text
