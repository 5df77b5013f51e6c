/**
 * The cells of a detection field: their grid, the courses and terms on which each is assessed, and the bit codes in
 * which the results are stored.
 */
package org.dronewatch.analysis.cell;
