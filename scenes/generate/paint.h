#pragma once

#include "scenes/generate/model.h"

/// Procedural textures. Each covers the unit square seamlessly with sRGB colours.
namespace dirt::generate {

using Colour = glm::dvec3;

/// A colour from 0xRRGGBB.
constexpr Colour rgb(unsigned hex) {
    return {(hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0};
}

/// Cream limestone: cloudy, pitted, stained. With `courses` > 0, cut into ashlar blocks in so many
/// courses, each of its own shade.
TextureRecipe limestone(int courses);

/// Marble with veins of `vein` in clouds between two shades.
TextureRecipe marble(Colour light, Colour dark, Colour vein, int scale, std::uint32_t seed);

/// Old stucco: several coats, washed out and stained.
TextureRecipe plaster(Colour coat, Colour undercoat);

/// Bricks in stretcher bond with lime joints.
TextureRecipe bricks();

/// Fired clay in bands, with lime bloom.
TextureRecipe clay(Colour base, std::uint32_t seed);

/// Planks' grain along the texture's second axis.
TextureRecipe timber(Colour light, Colour dark);

/// Woven cloth with a damask pattern in a shade of its own.
TextureRecipe damask(Colour ground, Colour figure, std::uint32_t seed);

/// Gold braid.
TextureRecipe braid();

/// A leaf along the second axis: midrib, veins, paler edge.
TextureRecipe foliage(Colour green, Colour pale);

/// Painted steel: chipped to primer and rust at `wear` (0 to 1), dirt in streaks down the second
/// axis.
TextureRecipe paintedSteel(Colour paint, double wear, std::uint32_t seed);

/// Sheets of bare aluminium, each rolled a little differently, with rows of rivets along the
/// seams: `sheets` across and along.
TextureRecipe aluminiumSkin(Colour metal, int sheets, bool rivets, std::uint32_t seed);

/// A power-floated concrete floor: clouds, oil, tyre marks, hairline cracks, joints at the edges.
TextureRecipe concreteFloor();

/// Its height: grain and joints.
TextureRecipe concreteRelief();

/// Slanted stripes in two colours, worn.
TextureRecipe hazardStripes(Colour bright, Colour dark);

/// Road paint on concrete: the paint is worn off in places.
TextureRecipe floorPaint(Colour paint, std::uint32_t seed);

/// A label: dark lines of print on a ground, with a bar of colour at the top.
TextureRecipe printedLabel(Colour ground, Colour print, Colour bar, std::uint32_t seed);

/// Marble after two thousand years: patina, grey crusts, lichen, pits.
TextureRecipe weatheredMarble();

/// Its height.
TextureRecipe weatheredRelief();

/// Grey limestone with lichen.
TextureRecipe limestoneRock();

/// Dry earth with straw, gravel, and a little green.
TextureRecipe dryGround();

/// A glaze with specks of iron.
TextureRecipe speckledGlaze(Colour glaze, Colour speck);

/// A knotted carpet, whole: border, field, medallion.
TextureRecipe carpet();

/// The edges of a book's pages, across the second axis.
TextureRecipe pages();

/// A painted landscape: hills and a lake in the evening.
TextureRecipe landscape();

} // namespace dirt::generate
