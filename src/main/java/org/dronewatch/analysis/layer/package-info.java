/**
 * The layer of one sensor in a detection field: its looks at each cell, what is interpolated between cells, and
 * layers that were computed before.
 */
package org.dronewatch.analysis.layer;
