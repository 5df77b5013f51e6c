/**
 * The cells of a detection field: their grid, what is asked of each of them, and the code in which the answer is
 * kept.
 */
package org.dronewatch.analysis.cell;
