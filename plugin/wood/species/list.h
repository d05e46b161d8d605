/* SPDX-License-Identifier: Apache-2.0
 *
 * The list of species, in the order in which hosts show them: X(id) for each.
 */
#ifndef SOZAI_WOOD_SPECIES_LIST_H
#define SOZAI_WOOD_SPECIES_LIST_H

/* clang-format off */
#define SPECIES_JAPAN(X) \
  X(onigurumi) \
  X(makaba) \
  X(yamazakura) \
  X(mizunara) \
  X(harunire) \
  X(keyaki) \
  X(itayakaede) \
  X(buna) \
  X(tamo) \
  X(kuri) \
  X(katsura) \
  X(honoki) \
  X(kiri) \
  X(kusunoki) \
  X(tochinoki) \
  X(isunoki) \
  X(mizume) \
  X(kihada) \
  X(enju) \
  X(kuwa)

#define SPECIES_EUROPE(X) \
  X(beech) \
  X(oak) \
  X(ash) \
  X(elm) \
  X(chestnut) \
  X(robinia) \
  X(walnut) \
  X(pear) \
  X(sycamore) \
  X(birch) \
  X(alder) \
  X(lime) \
  X(poplar) \
  X(willow) \
  X(plane) \
  X(hornbeam) \
  X(olive) \
  X(box) \
  X(holly) \
  X(apple) \
  X(plum) \
  X(laburnum)

#define SPECIES_AMERICA(X) \
  X(white_oak) \
  X(red_oak) \
  X(hickory) \
  X(black_walnut) \
  X(cherry) \
  X(hard_maple) \
  X(yellow_birch) \
  X(tulipwood) \
  X(basswood) \
  X(mahogany) \
  X(balsa) \
  X(rosewood) \
  X(cocobolo) \
  X(purpleheart)

#define SPECIES_TROPICS(X) \
  X(teak) \
  X(sapele) \
  X(iroko) \
  X(wenge) \
  X(zebrano) \
  X(padauk) \
  X(ebony) \
  X(macassar_ebony) \
  X(bubinga) \
  X(afrormosia) \
  X(okoume) \
  X(jarrah) \
  X(silky_oak) \
  X(lignum_vitae) \
  X(rubberwood)

#define SPECIES_CONIFERS(X) \
  X(sugi) \
  X(hinoki) \
  X(karamatsu) \
  X(akamatsu) \
  X(scots_pine) \
  X(douglas_fir) \
  X(spruce) \
  X(momi) \
  X(silver_fir) \
  X(western_red_cedar) \
  X(larch) \
  X(yew) \
  X(hiba) \
  X(sawara) \
  X(kaya) \
  X(tsuga) \
  X(ichii) \
  X(redwood) \
  X(southern_pine) \
  X(knotty_pine) \
  X(knotty_sugi)

#define SPECIES_FIGURED(X) \
  X(curly_maple) \
  X(quilted_maple) \
  X(birdseye_maple) \
  X(pommele_sapele) \
  X(spalted_beech)

#define SPECIES_PANELS(X) \
  X(birch_plywood) \
  X(lauan_plywood) \
  X(sugi_plywood) \
  X(walnut_plywood) \
  X(larch_lvl) \
  X(pine_blockboard)

#define SPECIES_ALL(X) SPECIES_JAPAN(X) SPECIES_EUROPE(X) SPECIES_AMERICA(X) SPECIES_TROPICS(X) SPECIES_CONIFERS(X) SPECIES_FIGURED(X) SPECIES_PANELS(X)
/* clang-format on */

#endif
