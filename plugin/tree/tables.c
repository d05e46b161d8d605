/* SPDX-License-Identifier: Apache-2.0 */
#include "tables.h"

#include "../table.h"

static const sozai_column branches_columns[] = {
    {"order", "", "0: the stem; of an arm that of what forks."},
    {"parent", "", "Its row; -1 of the stem."},
    {"at", "mm", "Along the parent's axis."},
    {"birth", "years", "Of the tree's age."},
    {"death", "years", "-1: alive."},
    {"shed", "years", "-1: still there."},
    {"azimuth", "deg", "From north (-z) clockwise seen from above."},
    {"elevation", "deg", "Above the horizontal, at the base."},
    {"length", "mm", "Along its axis, as it grew; a dead one has broken off since."},
    {"diameter", "mm", "At the base."}};
TABLE(branches, "branches",
      "The stem and first-order branches, or all that was measured, and the arms into which "
      "branches fork: curves of the same number.");

static const sozai_column knots_columns[] = {
    {"branch", "", "Row of the table branches; -1: shed."},
    {"birth", "years", "When the stem's tip bore it."},
    {"death", "years", "-1: alive. Wood laid down later does not join its own."},
    {"shed", "years", "-1: still there. Wood laid down later covers it."},
    {"azimuth", "rad", "In wood's log: x = r cos, z = r sin."},
    {"inclination", "rad", "Of its pith above the horizontal."},
    {"height", "mm", "Of its pith on the stem's, wood's y."},
    {"radius", "mm", "Now, or when it died."},
    {"first", "", "Its first row of knot_radii."},
    {"count", "", "How many rows of it."}};
TABLE(knots, "knots",
      "Every first-order branch the stem ever bore, from the ground up; of a measured tree those "
      "measured, all alive, born evenly over its age.");

static const sozai_column knot_radii_columns[] = {
    {"knot", "", "Row of the table knots."},
    {"year", "years", "Of the tree's age, at the year's end."},
    {"radius", "mm", "Of the branch at the stem; it never falls."}};
TABLE(knot_radii, "knot_radii", "The knots' radii from year to year.");

static const sozai_column rings_columns[] = {
    {"year", "years", "At the year's end."},
    {"height", "mm", "Above the ground."},
    {"radius", "mm", "Of the wood; 0 above the stem's tip of that year."}};
TABLE(rings, "rings",
      "The stem's radius by year and height: years in turn, heights within; of a measured tree, of "
      "a cone that rose evenly.");

static const sozai_column turning_columns[] = {
    {"year", "", "The year's shoot it stands on, from 1; 0 where it is not known."},
    {"turning", "deg", "Summed from the lowest branch."},
    {"divergence", "deg", "From the branch below; 0 of the lowest."},
    {"azimuth", "deg", "From north clockwise."},
    {"height", "", "Over the tree's height."},
    {"length", "", "Over the tree's height."},
    {"elevation", "deg", "At the base."}};
TABLE(turning, "turning", "The first-order branches that are there, as the paper plots them.");

static const sozai_column nodes_columns[] = {
    {"block", "", "0: the trunk; else which first-order branch, or block, from 1."},
    {"parent", "", "The parent's block; -1 of the trunk."},
    {"node", "", "The node from the ground that the segment starts from."},
    {"length", "cm", "Of the segment."},
    {"azimuth", "deg", "From north clockwise."},
    {"elevation", "deg", "Above the horizontal."},
    {"diameter", "cm", "At its base."}};
TABLE(nodes, "nodes",
      "The tree as a field table would have it; of a grown one each branch is one segment.");

static const sozai_column statistics_columns[] = {
    {"age", "years", "Of the tree."},
    {"height", "mm", "Of its stem."},
    {"diameter", "mm", "At the ground."},
    {"diameter_breast", "mm", "1.3 m up; 0 of a lower tree."},
    {"crown_base", "mm", "The lowest live branch."},
    {"turns_year", "1/year", "As in the paper's table 1."},
    {"branches_turn", "", "Likewise."},
    {"divergence_mean", "deg", "From branch to branch."},
    {"divergence_sd", "deg", "Its standard deviation."},
    {"divergence_min", "deg", "Its least."},
    {"divergence_max", "deg", "Its greatest."},
    {"crown_a", "", "Least squares of length / H on (1 - z / H)^b."},
    {"crown_a_up", "", "Of the upslope side."},
    {"crown_a_down", "", "Of the downslope side."},
    {"crown_b", "", "The b of it."},
    {"crown_rms", "", "Of the lengths about the curve, as a share."},
    {"first_order", "", "Branches that are there."},
    {"second_order", "", "Shoots."},
    {"third_order", "", "Shoots."},
    {"fourth_order", "", "Needles or leaves, or clothed shoots."},
    {"clothed", "", "1: the fourth order are shoots clothed as one."},
    {"shed", "", "First-order branches gone."},
    {"arms", "", "Into which branches fork."}};
TABLE(statistics, "statistics", "One row.");

static const sozai_column fit_columns[] = {
    {"what", "", "0: measured; 1: this tree; 2: its relative error, 0 of what was not measured."},
    {"crown_a", "", "As in statistics."},
    {"crown_a_up", "", ""},
    {"crown_a_down", "", ""},
    {"turns_year", "1/year", ""},
    {"branches_turn", "", ""},
    {"divergence_mean", "deg", ""},
    {"divergence_sd", "deg", ""},
    {"height", "mm", ""},
    {"branches", "", "First-order branches."},
    {"elevation", "deg", "Mean, of branches' tips seen from their bases; its error in radians."},
    {"elevation_sd", "deg", "Its standard deviation; likewise."},
    {"diameter", "mm", "Of the stem where it was measured lowest; 0: nowhere."},
    {"slenderness", "", "Branches' diameters at their base over their lengths; 0: not measured."},
    {"branch_share", "", "Mean of their diameters over the stem's there; 0: not measured."}};
TABLE(fit, "fit", "What a field table's fit gives, and how near this tree is; else no row.");

const sozai_table_info *const tree_table_infos[TREE_TABLES] = {
    [TABLE_BRANCHES] = &branches,     [TABLE_KNOTS] = &knots,     [TABLE_KNOT_RADII] = &knot_radii,
    [TABLE_RINGS] = &rings,           [TABLE_TURNING] = &turning, [TABLE_NODES] = &nodes,
    [TABLE_STATISTICS] = &statistics, [TABLE_FIT] = &fit};

uint32_t tree_table_columns(int table) { return tree_table_infos[table]->column_count; }
